#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/search/search.hpp"
#include "sph/records.hpp"

namespace brunt {

/// Candidates within the skin, and out of them the true neighbours of the present positions, in
/// rows padded to whole packs by the particle itself: sums run over the true neighbours in the
/// order of their ids, so that nothing depends on what the skin lets in. In the plane rows are
/// short and are kept; in space a bit of each candidate is, and rows are written out again where
/// they are read: their bytes would cost as much time.
template <int Dim>
class NeighbourRows {
 public:
  /// Gives the room of the candidates back: new ones are sought, which takes as much.
  void forget() { list_ = {}; }
  /// list  candidates, ascending within a row
  void assign(NeighbourList list);
  /// Puts the copies of each row among what is owned, by their ids: the row is ascending in both,
  /// one after the other.
  void merge_copies(std::span<const GlobalId> id, LocalIndex n_owned);
  /// Finds j with |x_i - x_j| < 2 h_ij among the candidates of i: its row, padded to the lanes of
  /// P, until this thread asks for another.
  template <class P>
  std::span<const LocalIndex> refresh(const MotionRecord<Dim, typename P::Stored>* records,
                                      LocalIndex i);
  /// The row that was found last, padded by i to the lanes of P, until this thread asks for
  /// another.
  template <class P = DoublePairs>
  std::span<const LocalIndex> row(LocalIndex i) const;

  /// Room for the weights of each pair of the row [1/m^2], in the plane; else null.
  Real* weights(LocalIndex i) { return weight_.empty() ? nullptr : weight_.data() + first_[i]; }
  int count(LocalIndex i) const { return count_[i]; }

 private:
  static constexpr bool kKeepsRows = Dim == 2;
  const LocalIndex* candidates(LocalIndex i) const {
    return list_.neighbour.data() + list_.offset[slot_of(i)];
  }
  int n_candidates(LocalIndex i) const {
    return static_cast<int>(list_.offset[slot_of(i) + 1] - list_.offset[slot_of(i)]);
  }
  /// The first byte of a row: each begins with one of its own.
  std::size_t first_byte(LocalIndex i) const {
    return slot_of(list_.offset[slot_of(i)]) / 8 + slot_of(i);
  }

  NeighbourList list_;
  std::vector<std::uint8_t> inside_;  // a bit a candidate, eight in a row to a byte
  std::vector<int> count_;            // of true neighbours
  std::vector<std::int64_t> first_;   // start of each padded row, where it is kept
  std::vector<LocalIndex> near_;
  std::vector<Real> weight_;  // [1/m^2]
};

}  // namespace brunt
// Tested by tests/unit/sph/particles_lists_test.cpp.
