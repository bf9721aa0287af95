#pragma once
#include <vector>

#include "contact/contacts/face_tractions.hpp"

namespace brunt {

/// What contacts remember from one evaluation to the next: how they met, what their friction was,
/// and which of them did not hold. The friction of the last evaluation stays with its records until
/// the next step begins.
template <int Dim>
class ContactMemory {
 public:
  /// Makes the frictions of the last evaluation the past of a step of dt [s], whose motion nodes.v
  /// is.
  void begin_step(const Records<Dim>& records, const ContactNodes<Dim>& nodes, Real dt);
  /// Takes in how the contacts of an evaluation at `time` [s], after a step dt [s], met, what it
  /// has lost, and what is deep now.
  void end_step(const Records<Dim>& records, const Entities<Dim>& entities, Real dt, Real time);
  /// What faces that have gone in this step kept goes with them. died  their ids, ascending
  void bury(const std::vector<GlobalId>& died);
  /// The same at time 0, where nothing was before.
  void begin(const Records<Dim>& records) {
    records.collect_touches(touches_);
    records.collect_ties(ties_);
  }
  /// The same of the last evaluation, repeated.
  void take_repeated(const Records<Dim>& records);

  /// How the next evaluation finds what it knows, as of TouchStep.
  TouchStep step(bool time_zero = false, bool again = false) const {
    return {&touches_, time_zero, again, &ties_, &closures_};
  }
  const FirstTouches& touches() const { return touches_; }
  const TiePoints& ties() const { return ties_; }
  const JointClosures& closures() const { return closures_; }
  const LostContacts<Dim>& lost() const { return lost_; }
  /// Ids of the faces that have gone in the step under way, ascending.
  const std::vector<GlobalId>& died() const { return died_; }
  /// Friction as it was before the step under way.
  FrictionHistory<Dim>& past() { return past_; }
  const FrictionHistory<Dim>& past() const { return past_; }

  /// Mixed bits of all that changes forces, in any order.
  std::uint64_t hash(const Records<Dim>& records) const;
  void save(const Records<Dim>& records, const Entities<Dim>& entities,
            std::vector<StateTable>& tables) const;
  /// What an evaluation needs first; the last one is repeated with it.
  void load(const Entities<Dim>& entities, const StateTables& tables);

 private:
  void keep_lost(const Records<Dim>& records, const Entities<Dim>& entities, Real dt, Real time);

  FrictionHistory<Dim> past_;
  FirstTouches touches_;                 // as the last evaluation left them
  TiePoints ties_;                       // that held in it
  JointClosures closures_;               // since time 0
  LostContacts<Dim> lost_;               // since time 0
  std::vector<DeepParticle<Dim>> deep_;  // of the last evaluation
  std::vector<GlobalId> died_;           // faces, in the step under way
};

/// Gives the records of a repeated evaluation, which has no past, the frictions of a saved state.
template <int Dim>
void load_friction(const Entities<Dim>& entities, const StateTables& tables, Records<Dim>& records);

}  // namespace brunt
// Tested by tests/unit/contact/lost_test.cpp.
