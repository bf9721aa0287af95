#pragma once
#include <string>
#include <vector>

#include "core/boundaries/supports.hpp"
#include "core/rigid/free_bodies.hpp"

namespace brunt {

/// A force on chosen points, in proportion to their masses; total per component [N] over time.
template <int Dim>
struct AppliedForce {
  std::string name;
  Points<Dim>* points = nullptr;
  std::vector<LocalIndex> chosen;
  std::vector<Real> share;  ///< fraction of the total that each point takes
  std::array<std::optional<PrescribedVelocity>, Dim> force;  ///< [N] as a function of time, place
  Real from = 0, to = kInfinity;
  std::vector<Vec<Dim>> last;  ///< [N] at the last full step
  std::vector<Real> work;      ///< [J] done on the scene, by chosen point
};

/// Gravity, applied forces and mass-proportional damping, each with its work.
template <int Dim>
class Loads {
 public:
  void gravity(const Vec<Dim>& g) { gravity_ = g, has_gravity_ = true; }
  void damp(Real rate, Real until) { rate_ = rate, until_ = until; }  ///< [1/s], [s]
  void apply(AppliedForce<Dim> force);
  void act_on(Points<Dim>& points);      ///< a group whose points feel gravity and damping
  void act_on(FreeBodies<Dim>& bodies);  ///< they feel both as a whole
  /// From now on what acted on `old` points acts on those of them that `now` owns, the same ids.
  void follow(const Points<Dim>& old, Points<Dim>& now);
  bool empty() const { return !has_gravity_ && rate_ == 0 && forces_.empty(); }

  /// Adds forces at the end of the step; books 1/2 (f(n) + f(n+1)).dx to boundary and damping.
  void add_forces(Real time, Real dt, const Vec<Dim>& origin);
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
    std::vector<Vec3> last_drag, last_torque;  // [N], [N m] of damping at the last full step
    std::vector<Real> load_work, damping_work;
    bool fresh = true;
  };
  void push_rigid(Real time, Real dt);
  bool has_gravity_ = false;
  Vec<Dim> gravity_ = Vec<Dim>::Zero();
  Real rate_ = 0, until_ = kInfinity;
  std::vector<Body> bodies_;
  std::optional<Rigid> rigid_;
  std::vector<AppliedForce<Dim>> forces_;
};

}  // namespace brunt
