#pragma once
#include <algorithm>
#include <vector>

#include "contact/surfaces/entities.hpp"
#include "core/state.hpp"

namespace brunt {

/// Which bodies may touch another before motion has used up an allowance (docs/theory/contact.md
/// (C49)). Contact does nothing for the others: their faces have no planes, are in no list and
/// bound no step. What counts as near follows from positions and speeds of all steps so far alone,
/// not from lists, their skin, ranks or restarts: steps depend on it.
template <int Dim>
class NearBodies {
 public:
  /// Adds the way [m] that any two nodes have come in a step; true where bodies must be looked at
  /// again, since they may come `ahead` [m] before contact counts on this answer once more.
  bool needs_look(Real way, Real ahead);
  /// Compares the boxes of all bodies at their present positions. True where other bodies are near
  /// than before. Collective.
  bool look(const std::vector<Surface<Dim>*>& surfaces, const Entities<Dim>& entities,
            const PairTable& pairs, Real ahead, const Communicator& ranks);
  bool any() const {
    return near_.empty() || std::find(near_.begin(), near_.end(), 1) != near_.end();
  }
  /// By body; empty: all are near.
  const std::vector<char>& near() const { return near_; }

  void save_state(std::vector<StateTable>& tables) const;
  void load_state(const StateTables& tables);

 private:
  /// What surrounds a body on all ranks [m].
  struct Reach {
    SearchBox<Dim> box;
    Real reach = 0;  // how far from it others touch it
    void take(const Reach& other);
  };
  static std::vector<Reach> reaches(const std::vector<Surface<Dim>*>& surfaces,
                                    const Entities<Dim>& entities, std::size_t n_bodies,
                                    const Communicator& ranks);

  std::vector<char> near_;
  Real allowance_ = 0;  // [m] that any two nodes may come from the last look to the next
  Real come_ = 0;       // [m] that they have
};

}  // namespace brunt
