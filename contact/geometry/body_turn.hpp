#pragma once
#include <algorithm>
#include <cmath>

#include "core/types.hpp"

namespace brunt {

/// The turn of a body in a step, from the spin w of its material at the end of it [rad/s], half
/// the curl of the velocity of mid-step: x(n) = x(n+1) - dt v, so that the sine of the angle is
/// |w| dt. Exact where the body only turns.
template <int Dim>
class BodyTurn;

template <>
class BodyTurn<2> {
 public:
  BodyTurn(const Vec3& spin, Real dt)
      : sine_(std::clamp(spin[2] * dt, -1.0, 1.0)), cosine_(std::sqrt(1 - sine_ * sine_)) {}
  Vec<2> operator()(const Vec<2>& v) const {
    return {cosine_ * v[0] - sine_ * v[1], sine_ * v[0] + cosine_ * v[1]};
  }

 private:
  Real sine_, cosine_;
};

template <>
class BodyTurn<3> {
 public:
  BodyTurn(const Vec3& spin, Real dt) : axis_(dt * spin) {
    const Real square = axis_.squaredNorm();
    if (square > 1) axis_ /= std::sqrt(square);
    cosine_ = std::sqrt(std::max(1 - square, 0.0));
  }
  /// Rodrigues' formula, its axis as long as the sine.
  Vec3 operator()(const Vec3& v) const {
    return cosine_ * v + axis_.cross(v) + axis_.dot(v) / (1 + cosine_) * axis_;
  }

 private:
  Vec3 axis_;
  Real cosine_;
};

}  // namespace brunt
// Tested by tests/unit/contact/particle_friction_test.cpp.
