#pragma once
#include <cmath>

#include "core/types.hpp"

namespace brunt {

/// Solid angle [sr] under which a point sees a triangle a b c [m], positive from behind it: a
/// closed surface that faces outwards is seen from inside under 4 pi. Van Oosterom & Strackee 1983,
/// eq. 8.
inline Real solid_angle(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& from) {
  const Vec3 ra = a - from, rb = b - from, rc = c - from;
  const Real la = ra.norm(), lb = rb.norm(), lc = rc.norm();
  const Real below = la * lb * lc + ra.dot(rb) * lc + rb.dot(rc) * la + rc.dot(ra) * lb;
  return 2 * std::atan2(ra.dot(rb.cross(rc)), below);
}

}  // namespace brunt
// Tested by tests/unit/core/turn_outward_test.cpp.
