#include "core/rigid/rigid_motion.hpp"

#include <algorithm>

namespace brunt {

template <int Dim>
bool RigidMotion<Dim>::varies() const {
  return spin_over_time || std::any_of(velocity_over_time.begin(), velocity_over_time.end(),
                                       [](const auto& v) { return v.has_value(); });
}

template <int Dim>
Vec<Dim> RigidMotion<Dim>::velocity_of(Real t) const {
  Vec<Dim> now = velocity;
  for (std::size_t c = 0; c < Dim; ++c) {
    if (velocity_over_time[c]) now[static_cast<int>(c)] = (*velocity_over_time[c])(t, Vec3::Zero());
  }
  return now;
}

template <int Dim>
Real RigidMotion<Dim>::spin_of(Real t) const {
  return spin_over_time ? (*spin_over_time)(t, Vec3::Zero()) : spin;
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
  if (!varies()) return;
  travelled.shift += dt * velocity_of(time - 0.5 * dt);
  travelled.angle += dt * spin_of(time - 0.5 * dt);
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
