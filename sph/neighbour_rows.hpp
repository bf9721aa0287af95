#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/search/pair_count.hpp"
#include "core/search/search.hpp"
#include "sph/records.hpp"

namespace brunt {

/// Candidates within the skin, and out of them the true neighbours of the present positions, in
/// rows padded to whole packs by the particle itself: sums run over the true neighbours in the
/// order of their ids, so that nothing depends on what the skin lets in. In the plane rows are
/// short and are kept. In space up to eight particles side by side share their candidates, a bit of
/// each candidate is kept of each, and rows are written out again where they are read: their bytes
/// would cost as much time.
template <int Dim>
class NeighbourRows {
 public:
  /// Of how many particles candidates are to be shared at most.
  static constexpr std::size_t kShare = Dim == 2 ? 1 : 8;

  /// Gives the room of the candidates back: new ones are sought, which takes as much.
  void forget() { shared_ = {}; }
  /// shared  candidates, ascending within a row
  void assign(SharedNeighbours shared);
  /// Puts the copies of each row among what is owned, by their ids: the row is ascending in both,
  /// one after the other.
  void merge_copies(std::span<const GlobalId> id, LocalIndex n_owned);

  /// Groups of particles that share candidates.
  std::size_t n_groups() const { return shared_.n_rows(); }
  std::span<const LocalIndex> members(std::size_t group) const { return shared_.points_of(group); }
  /// Finds j with |x_i - x_j| < 2 h_ij among the candidates, of each member i whose bit is set.
  template <class P>
  void find(const MotionRecord<Dim, typename P::Stored>* records, std::size_t group,
            unsigned wanted);
  /// The row of i, padded by i to the lanes of P, until this thread asks for another.
  template <class P = DoublePairs>
  std::span<const LocalIndex> row(LocalIndex i) const;

  /// Room for the weights of each pair of the row [1/m^2], in the plane; else null.
  Real* weights(LocalIndex i) { return weight_.empty() ? nullptr : weight_.data() + first_[i]; }
  /// True neighbours of i, as they were found last.
  int count(LocalIndex i) const;
  /// Of all particles, as they were found last.
  PairCount count_all() const;

 private:
  static constexpr bool kKeepsRows = Dim == 2;

  /// In space: every eighth byte from here on is of i.
  const std::uint8_t* bytes(LocalIndex i) const;

  SharedNeighbours shared_;
  // In space: of each group a word every eight candidates, with a byte of each member.
  std::vector<std::uint64_t> inside_;
  std::vector<std::int64_t> first_word_;  // of each group
  std::vector<std::uint8_t> member_;      // number of each particle in its group
  // In the plane.
  std::vector<int> count_;           // of true neighbours
  std::vector<std::int64_t> first_;  // start of each padded row
  std::vector<LocalIndex> near_;
  std::vector<Real> weight_;  // [1/m^2]
};

}  // namespace brunt
// Tested by tests/unit/sph/particles_lists_test.cpp.
