#include "sph/neighbour_rows.hpp"

#include <algorithm>
#include <bit>
#include <utility>

#include "sph/pair_passes.hpp"

namespace brunt {

namespace {
/// Where rows are written out, of each thread.
LocalIndex* room_for(int n) {
  thread_local std::vector<LocalIndex> room;
  const std::size_t needed = slot_of(n) + slot_of(kSingleLanes) + 2 * slot_of(kByte);
  if (room.size() < needed) room.resize(2 * needed);
  return room.data();
}

/// Fills a row of `found` up by i, to whole packs of either precision.
void pad(LocalIndex* row, int found, LocalIndex i) {
  while (found % kSingleLanes != 0) row[found++] = i;
}

std::int64_t whole_packs(std::int64_t n, int lanes) { return (n + lanes - 1) / lanes * lanes; }

std::int64_t words_of(std::size_t n) { return static_cast<std::int64_t>((n + kByte - 1) / kByte); }

/// A byte of ones at each bit that is set.
std::uint64_t bytes_of(unsigned bits) {
  std::uint64_t bytes = 0;
  for (int m = 0; m < kByte; ++m) {
    if ((bits >> m & 1U) != 0) bytes |= 0xFFULL << (kByte * m);
  }
  return bytes;
}
}  // namespace

template <int Dim>
void NeighbourRows<Dim>::assign(SharedNeighbours shared) {
  shared_ = std::move(shared);
  if (!kKeepsRows) shared_.list.neighbour.resize(shared_.list.neighbour.size() + kByte);  // read on
  auto& first = kKeepsRows ? first_ : first_word_;  // of rows of one in the plane
  first.resize(n_groups());
  std::int64_t next = 0;
  for (std::size_t group = 0; group < n_groups(); ++group) {
    first[group] = next;
    const std::size_t most = shared_.neighbours_of(group).size();
    next +=
        kKeepsRows ? whole_packs(static_cast<std::int64_t>(most), kSingleLanes) : words_of(most);
  }
  if (kKeepsRows) {
    count_.assign(n_groups(), 0);
    near_.resize(slot_of(next));
    weight_.resize(slot_of(next));
    return;
  }
  inside_.assign(slot_of(next), 0);
  member_.resize(shared_.row_of.size());
  for (std::size_t group = 0; group < n_groups(); ++group) {
    std::uint8_t m = 0;
    for (const LocalIndex i : members(group)) member_[slot_of(i)] = m++;
  }
}

template <int Dim>
void NeighbourRows<Dim>::merge_copies(std::span<const GlobalId> id, LocalIndex n_owned) {
  const auto before = [&](LocalIndex a, LocalIndex b) { return id[a] < id[b]; };
  const auto& offset = shared_.list.offset;
  const auto all = shared_.list.neighbour.begin();
  for (std::size_t row = 0; row + 1 < offset.size(); ++row) {
    const auto begin = all + offset[row], end = all + offset[row + 1];
    if (begin == end || *(end - 1) < n_owned) continue;
    std::inplace_merge(begin, std::lower_bound(begin, end, n_owned), end, before);
  }
}

template <int Dim>
template <class P>
void NeighbourRows<Dim>::find(const MotionRecord<Dim, typename P::Stored>* records,
                              std::size_t group, unsigned wanted) {
  const auto candidate = shared_.neighbours_of(group);
  const auto n = static_cast<int>(candidate.size());
  const auto some = members(group);
  if constexpr (kKeepsRows) {
    const LocalIndex i = some.front();
    LocalIndex* out = near_.data() + first_[i];
    count_[slot_of(i)] = select_neighbours<Dim, P>(records, i, candidate.data(), n, out);
    pad(out, count_[slot_of(i)], i);
    return;
  }
  ParticleGroup all;
  for (std::size_t m = 0; m < all.size(); ++m) all[m] = some[std::min(m, some.size() - 1)];
  const auto n_words = slot_of(words_of(candidate.size()));
  thread_local std::vector<std::uint64_t> found;
  found.resize(n_words);
  select_neighbours_of<Dim, P>(records, all, candidate.data(), n, found.data());
  const std::uint64_t taken = bytes_of(wanted);
  std::uint64_t* word = inside_.data() + first_word_[group];
  for (std::size_t w = 0; w < n_words; ++w) word[w] = (word[w] & ~taken) | (found[w] & taken);
}

template <int Dim>
const std::uint8_t* NeighbourRows<Dim>::bytes(LocalIndex i) const {
  const auto group = slot_of(shared_.row_of[slot_of(i)]);
  // Words may be read as bytes; the first is the lowest (x86, and what else brunt runs on).
  const auto* first = reinterpret_cast<const std::uint8_t*>(inside_.data() + first_word_[group]);
  return first + member_[slot_of(i)];
}

template <int Dim>
template <class P>
std::span<const LocalIndex> NeighbourRows<Dim>::row(LocalIndex i) const {
  const auto padded = [](int found) { return slot_of(whole_packs(found, P::kLanes)); };
  if constexpr (kKeepsRows) return {near_.data() + first_[i], padded(count_[slot_of(i)])};
  const auto candidate = shared_.neighbours_of(slot_of(shared_.row_of[slot_of(i)]));
  const auto n = static_cast<int>(candidate.size());
  LocalIndex* out = room_for(n);
  const int found = expand_bits<P>(candidate.data(), n, bytes(i), out);
  pad(out, found, i);
  return {out, padded(found)};
}

template <int Dim>
int NeighbourRows<Dim>::count(LocalIndex i) const {
  if (kKeepsRows) return count_[slot_of(i)];
  const std::size_t n = shared_.neighbours_of(slot_of(shared_.row_of[slot_of(i)])).size();
  const std::uint8_t* byte = bytes(i);
  int all = 0;
  for (std::size_t c = 0; c < n; c += kByte) all += std::popcount(byte[c]);
  return all;
}

template <int Dim>
PairCount NeighbourRows<Dim>::count_all() const {
  PairCount all;
  for (std::size_t group = 0; group < n_groups(); ++group) {
    const auto some = members(group);
    all.compared += static_cast<std::int64_t>(some.size() * shared_.neighbours_of(group).size());
    for (const LocalIndex i : some) all.in_support += count(i);
  }
  return all;
}

#define BRUNT_ROWS(Dim, P)                                                                    \
  template void NeighbourRows<Dim>::find<P>(const MotionRecord<Dim, P::Stored>*, std::size_t, \
                                            unsigned);                                        \
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
