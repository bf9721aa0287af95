#pragma once
/// The largest principal stress, the same bits on any instruction set.
#include <array>

#include "core/simd.hpp"
#include "core/types.hpp"

namespace brunt {

/// cos(acos(x)/3) of -1 <= x <= 1. t solves 4 t^3 - 3 t = x, or (t + 1)(2 t - 1)^2 = x + 1, whose
/// root has a vertical slope at x = -1; s = t - 1/2 instead is smooth in y = sqrt(x + 1):
///   2 s sqrt(s + 3/2) = y, by Newton from s = y/2.4. Four steps leave 1e-16.
template <class V>
BRUNT_INLINE V cosine_of_third(V x) {
  const V y = vsqrt(vmax(x + 1.0, broadcast<V>(0.0)));
  V s = y * (1 / 2.4);
  for (int k = 0; k < 4; ++k) {
    const V root = vsqrt(s + 1.5);
    s = s - (2.0 * s * root - y) / (2.0 * root + s / root);
  }
  return s + 0.5;
}

/// Largest principal value [Pa] of a deviator, components in the order of SymmetricIndex:
///   2 sqrt(J2/3) cos(acos(3 sqrt(3)/2 J3/J2^(3/2))/3)
///   Malvern, Introduction to the Mechanics of a Continuous Medium, 1969, sec. 3.3
template <class V>
BRUNT_INLINE V largest_principal(const std::array<V, 6>& s) {
  const V &a = s[xx], &b = s[yy], &c = s[zz], &d = s[yz], &e = s[zx], &f = s[xy];
  const V j2 = 0.5 * (a * a + b * b + c * c) + d * d + e * e + f * f;
  const V j3 = a * (b * c - d * d) - f * (f * c - d * e) + e * (f * d - b * e);
  const V radius = vsqrt(j2 * (1.0 / 3));
  const V cube = 2.0 * radius * radius * radius;
  // No stress has no direction; any x serves there, as the radius is 0.
  const V x = j3 / vmax(cube, broadcast<V>(1e-300));
  return 2.0 * radius * cosine_of_third(vmax(vmin(x, broadcast<V>(1.0)), broadcast<V>(-1.0)));
}

}  // namespace brunt
// Tested by tests/unit/core/damage_test.cpp.
