#include "sph/neighbour_rows.hpp"

#include <algorithm>
#include <utility>

#include "sph/pair_passes.hpp"

namespace brunt {

namespace {
/// Where rows are written out, of each thread.
LocalIndex* room_for(int n) {
  thread_local std::vector<LocalIndex> room;
  const std::size_t needed = slot_of(n) + slot_of(kSingleLanes) + slot_of(kByte);
  if (room.size() < needed) room.resize(2 * needed);
  return room.data();
}

/// Fills a row of `found` up by i, to whole packs of either precision.
void pad(LocalIndex* row, int found, LocalIndex i) {
  while (found % kSingleLanes != 0) row[found++] = i;
}

std::size_t whole_packs(int n, int lanes) { return slot_of((n + lanes - 1) / lanes * lanes); }
}  // namespace

template <int Dim>
void NeighbourRows<Dim>::assign(NeighbourList list) {
  list_ = std::move(list);
  const std::size_t n = list_.offset.size() - 1;
  count_.assign(n, 0);
  if (!kKeepsRows) {
    inside_.assign(slot_of(list_.offset[n]) / kByte + n + 1, 0);
    return;
  }
  first_.resize(n);
  std::int64_t next = 0;
  for (std::size_t i = 0; i < n; ++i) {
    first_[i] = next;
    constexpr auto most = kSingleLanes;
    next += (list_.offset[i + 1] - list_.offset[i] + most - 1) / most * most;
  }
  near_.resize(slot_of(next));
  weight_.resize(slot_of(next));
}

template <int Dim>
void NeighbourRows<Dim>::merge_copies(std::span<const GlobalId> id, LocalIndex n_owned) {
  const auto before = [&](LocalIndex a, LocalIndex b) { return id[a] < id[b]; };
  const auto all = list_.neighbour.begin();
  for (std::size_t i = 0; i + 1 < list_.offset.size(); ++i) {
    const auto begin = all + list_.offset[i], end = all + list_.offset[i + 1];
    if (begin == end || *(end - 1) < n_owned) continue;
    std::inplace_merge(begin, std::lower_bound(begin, end, n_owned), end, before);
  }
}

template <int Dim>
template <class P>
std::span<const LocalIndex> NeighbourRows<Dim>::refresh(
    const MotionRecord<Dim, typename P::Stored>* records, LocalIndex i) {
  const LocalIndex* candidate = candidates(i);
  const int n = n_candidates(i);
  LocalIndex* out = kKeepsRows ? near_.data() + first_[i] : room_for(n);
  std::uint8_t* byte = kKeepsRows ? nullptr : inside_.data() + first_byte(i);
  const int found = select_neighbours<Dim, P>(records, i, candidate, n, out, byte);
  count_[slot_of(i)] = found;
  pad(out, found, i);
  return {out, whole_packs(found, P::kLanes)};
}

template <int Dim>
template <class P>
std::span<const LocalIndex> NeighbourRows<Dim>::row(LocalIndex i) const {
  const std::size_t size = whole_packs(count_[slot_of(i)], P::kLanes);
  if constexpr (kKeepsRows) return {near_.data() + first_[i], size};
  const int n = n_candidates(i);
  LocalIndex* out = room_for(n);
  const std::uint8_t* bits = inside_.data() + first_byte(i);
  pad(out, expand_bits<P>(i, candidates(i), n, bits, out), i);
  return {out, size};
}

#define BRUNT_ROWS(Dim, P)                                             \
  template std::span<const LocalIndex> NeighbourRows<Dim>::refresh<P>( \
      const MotionRecord<Dim, P::Stored>*, LocalIndex);                \
  template std::span<const LocalIndex> NeighbourRows<Dim>::row<P>(LocalIndex) const;
template class NeighbourRows<2>;
template class NeighbourRows<3>;
BRUNT_ROWS(2, DoublePairs)
BRUNT_ROWS(3, DoublePairs)
BRUNT_ROWS(2, WidePairs)
BRUNT_ROWS(3, WidePairs)
BRUNT_ROWS(2, SinglePairs)
BRUNT_ROWS(3, SinglePairs)
#undef BRUNT_ROWS
}  // namespace brunt
// Tested by tests/unit/sph/particles_lists_test.cpp.
