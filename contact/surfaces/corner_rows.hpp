#pragma once
/// The corners of four quads, read as they lie in memory.
#include "contact/geometry/four_planes.hpp"
#include "contact/geometry/side_by_side.hpp"
#include "contact/surfaces/entities.hpp"

namespace brunt {

/// Copies the corners of a quad to its plane, and returns them.
BRUNT_INLINE CornerRows take_rows(const std::array<LocalIndex, 4>& node, const Vec3* x,
                                  FacePlane<3>& plane) {
  const auto at = [&](std::size_t c) -> const Vec3& { return x[slot_of(node[c])]; };
  const CornerRows corners(at(0), at(1), at(2), at(3));
  Real* to = plane.corner[0].data();
  for (int i = 0; i < 3; ++i) store(to + i * kLanes, corners.row[i]);
  return corners;
}

}  // namespace brunt
// Tested by tests/unit/contact/unlisted_faces_test.cpp.
