#pragma once
#include <array>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/ledger.hpp"
#include "core/rigid/rigid_surfaces.hpp"

namespace brunt {

/// Velocity of one component as a function of time and of the place at time 0 (absolute).
using PrescribedVelocity = std::function<Real(Real t, const Vec3& start)>;

/// One boundary condition that prescribes velocity components of chosen points with mass.
template <int Dim>
struct Constraint {
  std::string name;
  Points<Dim>* points = nullptr;
  std::vector<LocalIndex> chosen;
  std::array<std::optional<PrescribedVelocity>, Dim> velocity;  ///< empty: the component is free
  Real from = 0, to = kInfinity;                                ///< [s] when it acts
  std::vector<Vec<Dim>> reaction;                               ///< [N] at the last full step
  std::vector<Real> work;                                       ///< [J] done on the scene
};

/// All that holds points or prescribes their motion, and the work that this takes.
template <int Dim>
class Supports {
 public:
  explicit Supports(Vec<Dim> origin) : origin_(std::move(origin)) {}
  /// Points of rigid bodies, without mass; free  bodies among them that are not held or moved here
  /// (core/rigid/free_bodies.hpp)
  void move_rigid(Points<Dim>& points, std::vector<RigidMotion<Dim>> motions,
                  std::set<Label> free = {});
  void constrain(Constraint<Dim> constraint);
  /// From now on what acted on `old` points acts on those of them that `now` owns, the same ids.
  void follow(const Points<Dim>& old, Points<Dim>& now);

  /// Gives constrained points their velocities at time 0, before the first energy is taken.
  void start();
  /// After predict: overrides x and v of held, moving and rigid points; time is that of the end of
  /// the step. The acceleration at its start becomes the one that makes the prescribed velocity.
  void impose(Real time, Real dt);
  /// After all forces: takes what held points carry; books 1/2 (R(n) + R(n+1)).dx.
  void take_reactions(Real time, Real dt);
  /// Column boundary: minus the work done on the scene.
  void add_totals(Totals<Dim>& totals) const;
  /// Reactions and work of the owned points that are held.
  void save_state(std::vector<StateTable>& tables) const;
  /// Throws StateError where a row is missing.
  void load_state(const StateTables& tables);
  const std::vector<Constraint<Dim>>& constraints() const { return constraints_; }

  /// Rigid surfaces that are held or in prescribed motion.
  struct Rigid {
    Points<Dim>* points;
    std::vector<RigidMotion<Dim>> motions;     // by label; absent: held
    std::set<Label> free;                      // bodies that somebody else moves
    std::set<Label> bodies;                    // all others, of all ranks
    std::vector<std::size_t> motion_of_point;  // kFree: somebody else moves it
    std::vector<Vec<Dim>> reaction;
    std::vector<Real> work;
  };
  const std::vector<Rigid>& rigid() const { return rigid_; }

 private:
  static constexpr auto kFree = static_cast<std::size_t>(-1);
  static void name_motions(Rigid& rigid);
  void impose_rigid(Rigid& rigid, Real time, Real dt);
  void impose_constraint(Constraint<Dim>& constraint, Real time, Real dt);

  Vec<Dim> origin_;
  std::vector<Rigid> rigid_;
  std::vector<Constraint<Dim>> constraints_;
};

}  // namespace brunt
