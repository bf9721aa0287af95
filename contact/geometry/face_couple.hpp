#pragma once
#include <array>
#include <span>

#include "core/types.hpp"

namespace brunt {

/// Torque of a force at an arm, and its part on the corners of a face below: a number in 2D.
inline Real torque_at(const Vec<2>& arm, const Vec<2>& force) {
  return arm[0] * force[1] - arm[1] * force[0];
}
inline Vec3 torque_at(const Vec3& arm, const Vec3& force) { return arm.cross(force); }

namespace detail {
inline void turn_corners(std::span<const Vec<2>> arm, Real torque, std::span<Vec<2>> force) {
  Real inertia = 0;
  for (const auto& r : arm) inertia += r.squaredNorm();
  if (!(inertia > 0)) return;
  for (std::size_t k = 0; k < arm.size(); ++k) {
    force[k] += torque / inertia * Vec<2>(-arm[k][1], arm[k][0]);
  }
}
inline void turn_corners(std::span<const Vec3> arm, const Vec3& torque, std::span<Vec3> force) {
  Mat3 inertia = Mat3::Zero();
  for (const auto& r : arm) inertia += r.squaredNorm() * Mat3::Identity() - r * r.transpose();
  // A face as thin as a line cannot carry a torque about it.
  const Real size = inertia.trace();
  if (!(inertia.determinant() > 1e-12 * size * size * size)) return;
  const Vec3 turn = inertia.inverse() * torque;
  for (std::size_t k = 0; k < arm.size(); ++k) force[k] += turn.cross(arm[k]);
}
}  // namespace detail

/// Adds forces without a sum that give a face's corners a torque: f_k = (J^-1 M) x r_k with
/// J = sum |r|^2 I - r r^T, r from their mean (docs/theory/contact.md (C34)).
/// corner  [m], at most four;  torque  [N m];  force  [N] on each, accumulated
template <int Dim, class Torque>
void add_couple(std::span<const Vec<Dim>> corner, const Torque& torque, std::span<Vec<Dim>> force) {
  Vec<Dim> mean = Vec<Dim>::Zero();
  for (const auto& x : corner) mean += x;
  mean /= static_cast<Real>(corner.size());
  std::array<Vec<Dim>, 4> arm;
  for (std::size_t k = 0; k < corner.size(); ++k) arm[k] = corner[k] - mean;
  detail::turn_corners(std::span<const Vec<Dim>>(arm.data(), corner.size()), torque, force);
}

}  // namespace brunt
// Tested by tests/unit/contact/ties_test.cpp.
