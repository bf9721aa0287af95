#pragma once
#include <span>
#include <vector>

#include "core/search/search.hpp"
#include "sph/records.hpp"

namespace brunt {

/// Candidates within the skin, and out of them the true neighbours of the present positions, in
/// rows padded to whole packs by the particle itself: sums run over the true neighbours in the
/// order of their ids, so that nothing depends on what the skin lets in. Room is for packs of
/// either precision.
template <int Dim>
class NeighbourRows {
 public:
  /// list  candidates, ascending within a row
  void assign(NeighbourList list);
  /// Puts the copies of each row among what is owned, by their ids: the row is ascending in both,
  /// one after the other.
  void merge_copies(std::span<const GlobalId> id, LocalIndex n_owned);
  /// Finds j with |x_i - x_j| < 2 h_ij among the candidates of i.
  template <class P>
  void refresh(const MotionRecord<Dim, P>* records, LocalIndex i);

  /// Places of the true neighbours of i, padded by i to whole packs.
  std::span<const LocalIndex> row(LocalIndex i, int lanes = kLanes) const {
    const auto k = slot_of(i);
    const auto padded = slot_of((count_[k] + lanes - 1) / lanes * lanes);
    return {near_.data() + first_[k], padded};
  }
  /// What the first pass leaves to the second of each pair of the row, beside row(i).
  Real* weights(LocalIndex i) { return weight_.data() + first_[i]; }
  int count(LocalIndex i) const { return count_[i]; }

 private:
  NeighbourList list_;
  std::vector<std::int64_t> first_;  // start of each padded row
  std::vector<LocalIndex> near_;
  std::vector<Real> weight_;  // [1/m^2]
  std::vector<int> count_;
};

}  // namespace brunt
// Tested by tests/unit/sph/particles_lists_test.cpp.
