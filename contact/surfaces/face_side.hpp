#pragma once
/// What friction reads of a face whatever it touches: found once a step and not once a contact, of
/// which a face has four and more.
#include <algorithm>
#include <array>
#include <span>
#include <type_traits>

#include "contact/surfaces/nodes.hpp"
#include "core/lane_sums.hpp"

namespace brunt {

/// A vector of each corner, by component.
template <int Dim>
using CornerVectors = std::array<Pack, Dim>;

/// The sum over corners, and in the last lane that of `more`.
BRUNT_INLINE Pack sums_of(const CornerVectors<3>& a, const Pack& more) {
  return sums_of(a[0], a[1], a[2], more);
}
BRUNT_INLINE Pack sums_of(const CornerVectors<2>& a, const Pack& more) {
  return sums_of(a[0], a[1], more, more);
}
template <std::size_t n>
BRUNT_INLINE Pack dot(const std::array<Pack, n>& a, const std::array<Pack, n>& b) {
  Pack sum = a[0] * b[0];
  for (std::size_t c = 1; c < n; ++c) sum += a[c] * b[c];
  return sum;
}

BRUNT_INLINE CornerVectors<3> cross(const CornerVectors<3>& a, const CornerVectors<3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// A torque or a turn: a number in the plane.
template <int Dim>
using Couple = std::conditional_t<Dim == 3, Vec3, Real>;

/// Sum r x v over corners.
inline Real moment_of(const CornerVectors<2>& r, const CornerVectors<2>& v) {
  return sum_of(r[0] * v[1] - r[1] * v[0]);
}
inline Vec3 moment_of(const CornerVectors<3>& r, const CornerVectors<3>& v) {
  const Pack sums = sums_of(cross(r, v), broadcast<Pack>(0.0));
  return {sums[0], sums[1], sums[2]};
}

/// J^-1 [1/m^2] of corners about their mean, J = sum |r|^2 I - r r^T: turns a torque about a face
/// into its turn. 0 where the face is as thin as a line, which carries none.
template <int Dim>
struct InverseInertia;

template <>
struct InverseInertia<2> {
  Real inverse;

  BRUNT_INLINE void set(const CornerVectors<2>& arm) {
    const Real inertia = sum_of(dot(arm, arm));
    inverse = inertia > 0 ? 1 / inertia : 0.0;
  }
  Real operator()(Real torque) const { return inverse * torque; }
};

template <>
struct InverseInertia<3> {
  Real xx, yy, zz, xy, xz, yz;

  BRUNT_INLINE void set(const CornerVectors<3>& arm) {
    const auto& [x, y, z] = arm;
    const Pack x2 = x * x, y2 = y * y, z2 = z * z;
    const Pack square = sums_of(y2 + z2, z2 + x2, x2 + y2, x * y);
    const Pack mixed = sums_of(x * z, y * z, x, x);
    const Real a = square[0], b = square[1], c = square[2];
    const Real d = -square[3], e = -mixed[0], f = -mixed[1];  // of xy, xz and yz
    xx = b * c - f * f, yy = a * c - e * e, zz = a * b - d * d;
    xy = e * f - d * c, xz = d * f - e * b, yz = d * e - f * a;
    const Real determinant = a * xx + d * xy + e * xz, size = a + b + c;
    const Real scale = determinant > 1e-12 * size * size * size ? 1 / determinant : 0.0;
    for (Real* one : {&xx, &yy, &zz, &xy, &xz, &yz}) *one *= scale;
  }
  Vec3 operator()(const Vec3& t) const {
    return {xx * t[0] + xy * t[1] + xz * t[2], xy * t[0] + yy * t[1] + yz * t[2],
            xz * t[0] + yz * t[1] + zz * t[2]};
  }
};

/// The corners of a face about their mean, a lane each; lanes beyond the last corner are 0.
template <int Dim>
struct FaceSide {
  CornerVectors<Dim> arm;        ///< [m] from the mean
  CornerVectors<Dim> v;          ///< [m/s] relative to the mean
  Vec<Dim> mean, mean_velocity;  ///< [m], [m/s]
  Couple<Dim> moment;            ///< [m^2/s] sum r x v of the corners about their mean
  InverseInertia<Dim> turn;

  FaceSide() {}  // NOLINT(modernize-use-equals-default): of many, which are filled then
  /// Fills it where it stands: it is not copied.
  /// corner  three or four nodes, two in the plane
  void set(const ContactNodes<Dim>& nodes, std::span<const LocalIndex> corner) {
    const Real *x[kLanes], *speed[kLanes];
    for (std::size_t k = 0; k < kLanes; ++k) {
      const auto node = slot_of(corner[std::min(k, corner.size() - 1)]);
      x[k] = nodes.x[node].data(), speed[k] = nodes.v[node].data();
    }
    take(x, corner.size(), arm, mean);
    take(speed, corner.size(), v, mean_velocity);
    turn.set(arm);
    moment = moment_of(arm, v);
  }
  /// As that of a particle, which has no arms.
  void set(const ContactNodes<Dim>& nodes, LocalIndex node) {
    mean = nodes.x[slot_of(node)], mean_velocity = nodes.v[slot_of(node)];
    for (std::size_t c = 0; c < Dim; ++c) arm[c] = v[c] = broadcast<Pack>(0.0);
    turn = {};
    moment = moment_of(arm, v);
  }

 private:
  /// Values by corner about their mean.
  BRUNT_INLINE static void take(const Real* const (&from)[kLanes], std::size_t n,
                                CornerVectors<Dim>& value, Vec<Dim>& mean_value) {
    const Pack lane{0, 1, 2, 3}, zero = broadcast<Pack>(0.0);
    const auto is_corner = lane < broadcast<Pack>(static_cast<Real>(n));
    for (std::size_t c = 0; c < Dim; ++c) {
      value[c] = select(is_corner, Pack{from[0][c], from[1][c], from[2][c], from[3][c]}, zero);
    }
    const Pack mean_lanes = (1.0 / static_cast<Real>(n)) * sums_of(value, zero);
    for (int c = 0; c < Dim; ++c) {
      mean_value[c] = mean_lanes[c];
      value[slot_of(c)] = select(is_corner, value[slot_of(c)] - mean_lanes[c], zero);
    }
  }
};

}  // namespace brunt
// Tested by tests/unit/contact/face_side_test.cpp.
