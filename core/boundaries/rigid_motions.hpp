#pragma once
#include <set>
#include <vector>

#include "core/ledger.hpp"
#include "core/rigid/rigid_surfaces.hpp"

namespace brunt {

/// Rigid bodies that are held or have a prescribed motion, and the work that this takes.
template <int Dim>
class RigidMotions {
 public:
  /// Points of rigid bodies, without mass; free  bodies among them that are not held or moved here
  /// (core/rigid/free_bodies.hpp)
  void add(Points<Dim>& points, std::vector<RigidMotion<Dim>> motions, std::set<Label> free = {});
  /// From now on what acted on `old` points acts on those of them that `now` owns, the same ids.
  void follow(const Points<Dim>& old, Points<Dim>& now);

  /// Gives points their velocities at time 0.
  void start();
  /// After predict: overrides x and v of points; time is that of the end of the step.
  void impose(Real time, Real dt);
  /// After all forces: takes what points carry; books 1/2 (R(n) + R(n+1)).dx.
  void take_reactions(Real dt);
  /// Column boundary: minus the work done on the scene.
  void add_totals(Totals<Dim>& totals) const;
  /// Reactions and work of the owned points.
  void save_state(std::vector<StateTable>& tables) const;
  /// Throws StateError where a row is missing.
  void load_state(const StateTables& tables);

  /// Of one group.
  struct Group {
    Points<Dim>* points;
    std::vector<RigidMotion<Dim>> motions;     // by label; absent: held
    std::set<Label> free;                      // bodies that somebody else moves
    std::set<Label> bodies;                    // all others, of all ranks
    std::vector<std::size_t> motion_of_point;  // kFree: somebody else moves it
    std::vector<Vec<Dim>> reaction;            // [N] at the last full step
    std::vector<Real> work;                    // [J] done on the scene

    template <class AnyGroup, class F>
    static void visit_fields(AnyGroup& group, const F& f) {
      f(group.reaction, kSaved);
      f(group.work, kSaved);
    }
  };
  const std::vector<Group>& all() const { return groups_; }

 private:
  static constexpr auto kFree = static_cast<std::size_t>(-1);
  static void name_motions(Group& rigid);

  std::vector<Group> groups_;
};

}  // namespace brunt
// Tested by tests/unit/core/rigid_motions_test.cpp.
