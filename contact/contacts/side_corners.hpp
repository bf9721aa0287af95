#pragma once
/// The corners of one side of a contact, a lane each: what friction does to all of them at once.
#include <array>
#include <cmath>

#include "contact/contacts/friction.hpp"
#include "contact/contacts/record.hpp"
#include "contact/law/spring_slider.hpp"
#include "core/lane_sums.hpp"

namespace brunt {

/// A vector of each corner, by component.
template <int Dim>
using CornerVectors = std::array<Pack, Dim>;

template <int Dim>
BRUNT_INLINE CornerVectors<Dim> all(const Vec<Dim>& v) {
  CornerVectors<Dim> of;
  for (std::size_t c = 0; c < Dim; ++c) of[c] = broadcast<Pack>(v[c]);
  return of;
}
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
/// What a turn does to each corner.
BRUNT_INLINE CornerVectors<2> turn(Real w, const CornerVectors<2>& r) {
  return {broadcast<Pack>(-w) * r[1], broadcast<Pack>(w) * r[0]};
}
BRUNT_INLINE CornerVectors<3> turn(const Vec3& w, const CornerVectors<3>& r) {
  return cross(all<3>(w), r);
}

/// The corners of one side about their mean, with the weights of the point of contact; lanes beyond
/// the last corner are 0.
template <int Dim>
struct SideCorners {
  static_assert(Facet<Dim>::kNodes <= kLanes);
  int n = 0;
  CornerVectors<Dim> arm;                // [m] from the mean
  CornerVectors<Dim> v;                  // [m/s] relative to the mean
  Pack weight;                           // [1]
  Vec<Dim> point = Vec<Dim>::Zero();     // [m] of contact, on the face
  Vec<Dim> velocity = Vec<Dim>::Zero();  // [m/s] there

  SideCorners(const ContactNodes<Dim>& nodes, const ContactRecord<Dim>& record,
              const std::array<Real, Friction<Dim>::kNodes>& weights, const ContactSide& side)
      : n(side.last - side.first) {
    const Real *x[kLanes], *speed[kLanes];
    for (int k = 0; k < kLanes; ++k) {
      const auto i = slot_of(side.first + std::min(k, n - 1));
      const auto node = slot_of(record.node[i]);
      x[k] = nodes.x[node].data(), speed[k] = nodes.v[node].data();
      weight[k] = k < n ? weights[i] : 0.0;
    }
    const Pack lane{0, 1, 2, 3}, zero = broadcast<Pack>(0.0);
    const auto is_corner = lane < broadcast<Pack>(n);
    const Real part = 1.0 / n;
    // The mean of values by corner, which are about it then, and their value at the point.
    const auto take = [&](const Real* const(&from)[kLanes], CornerVectors<Dim>& value,
                          Vec<Dim>& at_point) {
      CornerVectors<Dim> weighted;
      for (std::size_t c = 0; c < Dim; ++c) {
        value[c] = select(is_corner, Pack{from[0][c], from[1][c], from[2][c], from[3][c]}, zero);
        weighted[c] = weight * value[c];
      }
      const Pack mean = part * sums_of(value, zero), weighted_sum = sums_of(weighted, zero);
      for (int c = 0; c < Dim; ++c) {
        at_point[c] = weighted_sum[c];
        value[slot_of(c)] = select(is_corner, value[slot_of(c)] - mean[c], zero);
      }
    };
    take(x, arm, point);
    take(speed, v, velocity);
  }
};

/// Turns the torque about a face into its turn, J^-1 torque with J = sum |r|^2 I - r r^T [m^2].
inline Real turn_of(const SideCorners<2>& side, Real torque) {
  const Real inertia = sum_of(dot(side.arm, side.arm));
  return inertia > 0 ? torque / inertia : 0.0;
}
inline Vec3 turn_of(const SideCorners<3>& side, const Vec3& torque) {
  const auto& [x, y, z] = side.arm;
  const Pack x2 = x * x, y2 = y * y, z2 = z * z;
  const Pack square = sums_of(y2 + z2, z2 + x2, x2 + y2, x * y);
  const Pack mixed = sums_of(x * z, y * z, x, x);
  const Real xx = square[0], yy = square[1], zz = square[2];
  const Real xy = -square[3], xz = -mixed[0], yz = -mixed[1];
  // Cofactors of this matrix.
  const Real c_xx = yy * zz - yz * yz, c_yy = xx * zz - xz * xz, c_zz = xx * yy - xy * xy;
  const Real c_xy = xz * yz - xy * zz, c_xz = xy * yz - xz * yy, c_yz = xy * xz - yz * xx;
  const Real determinant = xx * c_xx + xy * c_xy + xz * c_xz;
  // A face as thin as a line cannot carry a torque about it.
  const Real size = xx + yy + zz;
  if (!(determinant > 1e-12 * size * size * size)) return Vec3::Zero();
  const Vec3 t = (1 / determinant) * torque;
  return {c_xx * t[0] + c_xy * t[1] + c_xz * t[2], c_xy * t[0] + c_yy * t[1] + c_yz * t[2],
          c_xz * t[0] + c_yz * t[1] + c_zz * t[2]};
}

/// Adds the spin of a face about the new normal, as a unit vector of its cosine and sine.
inline void add_spin(const SideCorners<3>& side, const PlaneTurn<3>& turn, const Vec3& normal,
                     Real dt, Real& cosine, Real& sine) {
  const CornerVectors<3> n = all<3>(normal);
  CornerVectors<3> before;
  for (std::size_t c = 0; c < 3; ++c) before[c] = side.arm[c] - dt * side.v[c];
  before = turn.tilted(before);
  const Pack cosines = dot(before, side.arm) - dot(n, before) * dot(n, side.arm);
  const Pack sines = dot(n, cross(before, side.arm));
  const Pack sums = sums_of(cosines, sines, sines, sines);
  const Real c = sums[0], s = sums[1];
  const Real size = std::sqrt(c * c + s * s);
  if (!(size > 0)) return;
  cosine += c / size, sine += s / size;
}

}  // namespace brunt
// Tested by tests/unit/contact/friction_law_test.cpp.
