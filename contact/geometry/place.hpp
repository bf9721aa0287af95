#pragma once
/// A point in space, or four of them side by side: what kernels over the corners of quads work on.
#include "core/simd.hpp"

namespace brunt {

template <class V>
struct Place {
  V x, y, z;
};
template <class V>
BRUNT_INLINE Place<V> operator+(const Place<V>& a, const Place<V>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class V>
BRUNT_INLINE Place<V> operator-(const Place<V>& a, const Place<V>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class V>
BRUNT_INLINE Place<V> operator*(V s, const Place<V>& a) {
  return {s * a.x, s * a.y, s * a.z};
}
template <class V>
BRUNT_INLINE V dot(const Place<V>& a, const Place<V>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class V>
BRUNT_INLINE Place<V> cross(const Place<V>& a, const Place<V>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

BRUNT_INLINE Place<Real> place(const Vec3& p) { return {p[0], p[1], p[2]}; }
/// The same point in all lanes.
BRUNT_INLINE Place<Pack> everywhere(const Vec3& p) {
  return {broadcast<Pack>(p[0]), broadcast<Pack>(p[1]), broadcast<Pack>(p[2])};
}
/// The corners of a quad.
BRUNT_INLINE Place<Pack> corners(const std::array<Vec3, 4>& at) {
  const auto along = [&](Eigen::Index c) { return Pack{at[0][c], at[1][c], at[2][c], at[3][c]}; };
  return {along(0), along(1), along(2)};
}
/// What follows each corner about the quad.
BRUNT_INLINE Place<Pack> next(const Place<Pack>& p) {
  const auto turned = [](Pack v) { return Pack{v[1], v[2], v[3], v[0]}; };
  return {turned(p.x), turned(p.y), turned(p.z)};
}
/// The same about two quads.
BRUNT_INLINE Place<Wide> next(const Place<Wide>& p) {
  const auto turned = [](Wide v) { return __builtin_shufflevector(v, v, 1, 2, 3, 0, 5, 6, 7, 4); };
  return {turned(p.x), turned(p.y), turned(p.z)};
}

}  // namespace brunt
