#pragma once
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "core/rigid/free_bodies.hpp"

namespace brunt {

/// What acts on all that is free: gravity and mass-proportional damping, each with its work.
template <int Dim>
class Loads {
 public:
  using GravityOverTime = std::function<Vec<Dim>(Real time)>;  ///< [m/s^2] at a time [s]
  void gravity(const Vec<Dim>& g) { gravity_ = last_gravity_ = g, has_gravity_ = true; }
  void gravity(GravityOverTime g) { over_time_ = std::move(g), has_gravity_ = true; }
  void damp(Real rate, Real until) { rate_ = rate, until_ = until; }  ///< [1/s], [s]
  void act_on(Points<Dim>& points);      ///< a group whose points feel gravity and damping
  void act_on(FreeBodies<Dim>& bodies);  ///< they feel both as a whole
  /// From now on what acted on `old` points acts on those of them that `now` owns, the same ids.
  void follow(const Points<Dim>& old, Points<Dim>& now);
  bool empty() const { return !has_gravity_ && rate_ == 0; }

  /// Adds forces at the end of the step; books 1/2 (f(n) + f(n+1)).dx to boundary and damping.
  void add_forces(Real time, Real dt);
  StepLimit stable_step(Real time) const;
  void add_totals(Totals<Dim>& totals) const;
  /// The same of rigid bodies, which every rank has: one of them adds it.
  void add_rigid_totals(Totals<Dim>& totals) const;
  /// Work of the owned points that loads act on, and the forces that the next step starts with.
  void save_state(std::vector<StateTable>& tables) const;
  /// Throws StateError where a row is missing.
  void load_state(const StateTables& tables);

 private:
  struct Body {
    Points<Dim>* points;
    std::vector<Vec<Dim>> last_damping;  // [N] at the last full step
    std::vector<Real> load_work, damping_work;
    bool fresh = true;
  };
  struct Rigid {
    FreeBodies<Dim>* bodies;
    std::vector<Vec3> last_drag,
        last_torque;  // [N], [N m] of damping at the last full step
    std::vector<Real> load_work, damping_work;
    bool fresh = true;
  };
  void push_rigid(Real time, Real dt);
  bool has_gravity_ = false;
  GravityOverTime over_time_;  // empty: constant
  // [m/s^2] at the end of this step, and at its start
  Vec<Dim> gravity_ = Vec<Dim>::Zero(), last_gravity_ = Vec<Dim>::Zero();
  Real rate_ = 0, until_ = kInfinity;
  std::vector<Body> bodies_;
  std::optional<Rigid> rigid_;
};

}  // namespace brunt
