#include "core/rigid/rigid_motion.hpp"

#include <algorithm>
#include <cmath>

namespace brunt {

namespace {
/// Two points of Gauss: exact to the third power.
Real gauss(const DrivenRate& rate, Real from, Real to) {
  static const Real kGauss = 1 / std::sqrt(3.0);
  const Real half = 0.5 * (to - from), middle = from + half;
  return half * (rate.at(middle - kGauss * half) + rate.at(middle + kGauss * half));
}

/// Halves the interval until that changes nothing: a step of heat may be as long as many swings.
Real refined(const DrivenRate& rate, Real from, Real to, Real whole, int depth) {
  constexpr Real kSmall = 1e-12;
  const Real middle = from + 0.5 * (to - from);
  const Real left = gauss(rate, from, middle), right = gauss(rate, middle, to);
  const Real change = std::fabs(left + right - whole);
  if (depth == 0 || !(change > kSmall * (std::fabs(left) + std::fabs(right)))) return left + right;
  return refined(rate, from, middle, left, depth - 1) + refined(rate, middle, to, right, depth - 1);
}
}  // namespace

Real DrivenRate::over(Real a, Real b) const {
  constexpr int kDepth = 14;  // 16,384 parts
  Real sum = 0;
  auto kink = std::upper_bound(kinks.begin(), kinks.end(), a);
  for (Real from = a; from < b;) {
    const Real to = kink != kinks.end() && *kink < b ? *kink++ : b;
    sum += refined(*this, from, to, gauss(*this, from, to), kDepth);
    from = to;
  }
  return sum;
}

std::optional<DrivenRate> driven_rate_of(const Varying& varying) {
  if (varying.is_constant()) return std::nullopt;
  return DrivenRate{function_of(varying), varying.abscissa};
}

template <int Dim>
bool RigidMotion<Dim>::varies() const {
  return spin_over_time || std::any_of(velocity_over_time.begin(), velocity_over_time.end(),
                                       [](const auto& v) { return v.has_value(); });
}

template <int Dim>
Vec<Dim> RigidMotion<Dim>::velocity_of(Real t) const {
  Vec<Dim> now = velocity;
  for (std::size_t c = 0; c < Dim; ++c) {
    if (velocity_over_time[c]) now[static_cast<int>(c)] = velocity_over_time[c]->at(t);
  }
  return now;
}

template <int Dim>
Real RigidMotion<Dim>::spin_of(Real t) const {
  return spin_over_time ? spin_over_time->at(t) : spin;
}

template <int Dim>
RigidPose<Dim> RigidMotion<Dim>::pose(Real t) const {
  RigidPose<Dim> at{velocity * t, spin * t};
  for (std::size_t c = 0; c < Dim; ++c) {
    const int k = static_cast<int>(c);
    if (velocity_over_time[c]) at.shift[k] = travelled.shift[k];
  }
  if (spin_over_time) at.angle = travelled.angle;
  return at;
}

template <int Dim>
void RigidMotion<Dim>::advance(Real time, Real dt) {
  for (std::size_t c = 0; c < Dim; ++c) {
    const auto& rate = velocity_over_time[c];
    if (rate) travelled.shift[static_cast<int>(c)] += rate->over(time - dt, time);
  }
  if (!spin_over_time) return;
  travelled.angle += spin_over_time->over(time - dt, time);
  last_spin = spin_of(time);
}

template <int Dim>
Vec<Dim> RigidMotion<Dim>::position(const Vec<Dim>& start, const RigidPose<Dim>& at) const {
  Vec<Dim> arm = start - center;
  if (turns()) {
    const Eigen::AngleAxis<Real> turn(at.angle, axis);
    arm = (turn * in_space<Dim>(arm)).eval().template head<Dim>();
  }
  return center + at.shift + arm;
}

template <int Dim>
Vec<Dim> RigidMotion<Dim>::velocity_at(const Vec<Dim>& start, Real t) const {
  if (!turns()) return velocity_of(t);
  const Vec3 arm = Eigen::AngleAxis<Real>(pose(t).angle, axis) * in_space<Dim>(start - center);
  return velocity_of(t) + (spin_of(t) * axis.cross(arm)).template head<Dim>();
}

template struct RigidMotion<2>;
template struct RigidMotion<3>;

}  // namespace brunt
// Tested by tests/unit/core/rigid_motions_test.cpp.
