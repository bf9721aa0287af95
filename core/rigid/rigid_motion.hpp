#pragma once
#include <array>
#include <optional>
#include <vector>

#include "core/boundaries/function.hpp"
#include "core/field_use.hpp"
#include "core/types.hpp"

namespace brunt {

/// How far a rigid body has come since time 0.
template <int Dim>
struct RigidPose {
  Vec<Dim> shift = Vec<Dim>::Zero();  ///< [m] of the centre of its spin
  Real angle = 0;                     ///< [rad] about the axis
};

/// A rate of a prescribed motion that is not constant: a table over time or an expression of it.
struct DrivenRate {
  FunctionOfTimeAndPlace value;  ///< [m/s] or [rad/s]; the place says nothing
  std::vector<Real> kinks;       ///< [s] ascending times at which a table bends

  Real at(Real t) const { return value(t, Vec3::Zero()); }
  /// Its integral from a to b: exact for tables, to 1e-12 of itself for expressions that are
  /// smooth.
  Real over(Real a, Real b) const;
};
/// Of a value of the deck; none where it is constant.
std::optional<DrivenRate> driven_rate_of(const Varying& varying);

/// The prescribed motion of a rigid body: it shifts, and turns about a centre that goes with it,
/// at constant rates or at rates over time.
template <int Dim>
struct RigidMotion {
  Label body = 0;
  Vec<Dim> velocity = Vec<Dim>::Zero();  ///< [m/s] of the centre of the spin, at time 0
  Vec3 axis = Vec3::UnitZ();             ///< unit vector; in 2D out of the plane
  Real spin = 0;                         ///< [rad/s] about the axis, at time 0
  Vec<Dim> center = Vec<Dim>::Zero();    ///< [m] at time 0
  /// [m/s], by component, and [rad/s]: what is not constant.
  std::array<std::optional<DrivenRate>, Dim> velocity_over_time{};
  std::optional<DrivenRate> spin_over_time{};
  /// Of what is not constant, by the end of the last step: part of the state.
  RigidPose<Dim> travelled{};
  Real last_spin = 0;  ///< [rad/s] then, where it is not constant

  bool varies() const;
  bool turns() const { return spin != 0 || spin_over_time; }
  Vec<Dim> velocity_of(Real t) const;  ///< [m/s] of the centre of the spin at a time
  Real spin_of(Real t) const;          ///< [rad/s]
  /// [rad/s] as the last step ended.
  Real spin_now() const { return spin_over_time ? last_spin : spin; }
  /// Where it is at the end of the last step, which is time t.
  RigidPose<Dim> pose(Real t) const;
  /// A step of dt that ends at a time: what is not constant goes on by its integral.
  void advance(Real time, Real dt);
  /// Position of a point that was at `start` at time 0.
  Vec<Dim> position(const Vec<Dim>& start, const RigidPose<Dim>& at) const;
  /// [m/s] its velocity at the end of the last step, which is time t.
  Vec<Dim> velocity_at(const Vec<Dim>& start, Real t) const;
};

/// Of some things those whose motion is not constant; motion_of(thing)  its RigidMotion
template <class Things, class MotionOf>
auto varying_of(Things& things, const MotionOf& motion_of) {
  std::vector<decltype(&things.front())> found;
  for (auto& thing : things) {
    if (motion_of(thing).varies()) found.push_back(&thing);
  }
  return found;
}

/// Hands what a motion at rates over time carries from step to step to f(value, use).
template <class AnyMotion, class F>
void visit_motion(AnyMotion& motion, const F& f) {
  f(motion.travelled.shift, kSaved), f(motion.travelled.angle, kSaved);
  f(motion.last_spin, kSaved);
}

}  // namespace brunt
// Tested by tests/unit/core/rigid_motions_test.cpp.
