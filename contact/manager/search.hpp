#pragma once
#include "contact/manager/setup.hpp"
#include "contact/search/candidates.hpp"
#include "contact/search/near_bodies.hpp"

namespace brunt {

/// What an evaluation looks ahead to.
struct LookAhead {
  StepLimit longest;  ///< the longest step that may follow: that of the springs, and growth
  Real time = 0;      ///< [s] how far ahead speed limits look: the same on all ranks
};

/// Where the tables of a new search come from.
enum class Tables {
  anew,       ///< the surfaces
  inherited,  ///< the surfaces; what is booked stays with the ids of points
  kept        ///< those that are there: no facet or particle came or went
};

/// Tables of what can touch, with what other ranks show of theirs, and lists of what may.
template <int Dim>
class ContactSearch {
 public:
  /// setup  outlives it. Collective.
  explicit ContactSearch(const ContactSetup<Dim>& setup);

  const Entities<Dim>& entities() const { return entities_; }
  Entities<Dim>& entities() { return entities_; }
  const Candidates<Dim>& candidates() const { return candidates_; }
  const ContactImports<Dim>& imports() const { return imports_; }
  /// True where bodies are near enough to touch soon.
  bool any_near() const { return near_.any(); }

  /// Tables anew with what the setup has learned of free rigid bodies. Collective.
  void take_rigid();
  /// Tables anew where facets or particles have come or gone. Collective.
  void take_surfaces();
  /// Brings motion and planes up to date. Collective among neighbours.
  void refresh_motion();
  /// Brings up to date what friction needs to know of faces and materials at the start of a step.
  /// Collective among neighbours.
  void refresh_friction();
  /// The longest step that may follow one of dt [s], 0 for the first: that of the springs, and some
  /// times dt where particles must look ahead.
  StepLimit longest_after(Real dt) const;
  /// Collective.
  LookAhead look_ahead(Real dt) const;
  /// Lists anew at the motion of a step of dt [s] where they may miss a contact, or other bodies
  /// are near; what is booked stays with the nodes. Collective.
  LookAhead renew_if_needed(Real dt);
  /// Lists, and tables but for Tables::kept, at the positions of time 0. Collective.
  LookAhead begin(Tables tables);
  /// Lists anew at the present positions. with_motion  velocities are those of the step under way,
  /// else of the last evaluation. Collective.
  void renew(Real ahead, Tables tables, bool with_motion);
  /// What was born in the step has met what it overlaps: it is like all else from now on.
  void end_births();
  /// Sums what each face carries, from the records of all ranks. Collective among neighbours.
  void sum_tractions(const Records<Dim>& records);

  void save_state(std::vector<StateTable>& tables) const { near_.save_state(tables); }
  void load_state(const StateTables& tables) { near_.load_state(tables); }

 private:
  bool take_changes();
  bool find_near_bodies(Real ahead);

  const ContactSetup<Dim>& setup_;
  Entities<Dim> entities_;
  ContactImports<Dim> imports_;
  NearBodies<Dim> near_;
  Candidates<Dim> candidates_;
};

}  // namespace brunt
// Tested by tests/unit/contact/rebuild_test.cpp.
