#pragma once
/// A point in a plane, or four of them side by side.
#include "core/simd.hpp"

namespace brunt {

/// Coordinates of one point in a plane, or of four.
template <class V>
struct InPlane {
  V x, y;
};
template <class V>
BRUNT_INLINE InPlane<V> operator+(const InPlane<V>& a, const InPlane<V>& b) {
  return {a.x + b.x, a.y + b.y};
}
template <class V>
BRUNT_INLINE InPlane<V> operator-(const InPlane<V>& a, const InPlane<V>& b) {
  return {a.x - b.x, a.y - b.y};
}
template <class V>
BRUNT_INLINE InPlane<V> operator*(V s, const InPlane<V>& a) {
  return {s * a.x, s * a.y};
}
template <class V>
BRUNT_INLINE V cross(const InPlane<V>& a, const InPlane<V>& b) {
  return a.x * b.y - a.y * b.x;
}

/// Four quads side by side.
struct FourQuadsInPlane {
  InPlane<Pack> corner[4];
};

}  // namespace brunt
// Tested by tests/unit/contact/common_plane_test.cpp.
