#include "sph/neighbour_rows.hpp"

#include <algorithm>
#include <utility>

#include "core/simd_float.hpp"

namespace brunt {

namespace {
constexpr int kByte = 8;  // candidates of which a byte tells

/// Where rows are written out, of each thread.
LocalIndex* room_for(int n) {
  thread_local std::vector<LocalIndex> room;
  const std::size_t needed = slot_of(n) + slot_of(kSingleLanes) + slot_of(kByte);
  if (room.size() < needed) room.resize(2 * needed);
  return room.data();
}

/// Appends those of n candidates, four or eight, whose bits are set; writes n places.
template <int n>
BRUNT_INLINE int append(LocalIndex* out, const LocalIndex* candidate, unsigned bits) {
  const unsigned low = bits & 15U, high = bits >> 4;
  store_permuted(out, candidate, kCompression.lane[low]);
  const int found = kCompression.count[low];
  if constexpr (n == kLanes) return found;
  store_permuted(out + found, candidate + kLanes, kCompression.lane[high]);
  return found + kCompression.count[high];
}

/// The last candidates of a row, fewer than eight, filled up by i.
struct Rest {
  LocalIndex candidate[kByte];
  Rest(const LocalIndex* from, int n, LocalIndex i) {
    std::fill(candidate, candidate + kByte, i);
    std::copy_n(from, n, candidate);
  }
};

/// Fills a row of `found` up by i, to whole packs of either precision.
void pad(LocalIndex* row, int found, LocalIndex i) {
  while (found % kSingleLanes != 0) row[found++] = i;
}

std::size_t whole_packs(int n, int lanes) { return slot_of((n + lanes - 1) / lanes * lanes); }
}  // namespace

template <int Dim>
void NeighbourRows<Dim>::assign(NeighbourList list, bool keeps_weights) {
  list_ = std::move(list);
  const std::size_t n = list_.offset.size() - 1;
  count_.assign(n, 0);
  if (!kKeepsRows) inside_.assign(slot_of(list_.offset[n]) / kByte + n + 1, 0);
  if (!kKeepsRows && !keeps_weights) return;
  first_.resize(n);
  std::int64_t next = 0;
  for (std::size_t i = 0; i < n; ++i) {
    first_[i] = next;
    constexpr auto most = kSingleLanes;
    next += (list_.offset[i + 1] - list_.offset[i] + most - 1) / most * most;
  }
  if (kKeepsRows) near_.resize(slot_of(next));
  weight_.resize(slot_of(next));
}

/// Which pairs (i, j) of a pack interact, a bit a lane.
template <int Dim, class P>
BRUNT_INLINE unsigned inside_support(const MotionRecord<Dim, P>* records,
                                     const typename P::Number* own, const LocalIndex* j) {
  PairPack<Dim, P> pairs;
  set_arms(records, own, j, pairs);
  return mask_bits(pairs.q2 < number_of<typename P::Pack>(P::kSupport));
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
std::span<const LocalIndex> NeighbourRows<Dim>::refresh(const MotionRecord<Dim, P>* records,
                                                        LocalIndex i) {
  const LocalIndex* candidate = candidates(i);
  const int n = n_candidates(i);
  const auto* own = records[i].data;
  LocalIndex* out = kKeepsRows ? near_.data() + first_[i] : room_for(n);
  std::uint8_t* byte = kKeepsRows ? nullptr : inside_.data() + first_byte(i);
  constexpr int kStep = kKeepsRows ? P::kLanes : kByte;
  int found = 0;
  const auto take = [&](const LocalIndex* some, unsigned among) {
    unsigned bits = inside_support<Dim, P>(records, own, some);
    if constexpr (kStep > P::kLanes) {
      bits |= inside_support<Dim, P>(records, own, some + P::kLanes) << P::kLanes;
    }
    bits &= among;
    if constexpr (!kKeepsRows) *byte++ = static_cast<std::uint8_t>(bits);
    found += append<kStep>(out + found, some, bits);
  };
  int c = 0;
  for (; c + kStep <= n; c += kStep) take(candidate + c, (1U << kStep) - 1U);
  if (c < n) take(Rest(candidate + c, n - c, i).candidate, (1U << (n - c)) - 1U);
  count_[slot_of(i)] = found;
  pad(out, found, i);
  return {out, whole_packs(found, P::kLanes)};
}

template <int Dim>
std::span<const LocalIndex> NeighbourRows<Dim>::row(LocalIndex i, int lanes) const {
  const std::size_t size = whole_packs(count_[slot_of(i)], lanes);
  if constexpr (kKeepsRows) return {near_.data() + first_[i], size};
  const LocalIndex* candidate = candidates(i);
  const int n = n_candidates(i);
  const std::uint8_t* byte = inside_.data() + first_byte(i);
  LocalIndex* out = room_for(n);
  int found = 0, c = 0;
  for (; c + kByte <= n; c += kByte) {
    found += append<kByte>(out + found, candidate + c, *byte++);
  }
  if (c < n) found += append<kByte>(out + found, Rest(candidate + c, n - c, i).candidate, *byte);
  pad(out, found, i);
  return {out, size};
}

template class NeighbourRows<2>;
template class NeighbourRows<3>;
template std::span<const LocalIndex> NeighbourRows<2>::refresh(const MotionRecord<2, DoublePairs>*,
                                                               LocalIndex);
template std::span<const LocalIndex> NeighbourRows<3>::refresh(const MotionRecord<3, DoublePairs>*,
                                                               LocalIndex);
template std::span<const LocalIndex> NeighbourRows<2>::refresh(const MotionRecord<2, SinglePairs>*,
                                                               LocalIndex);
template std::span<const LocalIndex> NeighbourRows<3>::refresh(const MotionRecord<3, SinglePairs>*,
                                                               LocalIndex);

}  // namespace brunt
// Tested by tests/unit/sph/particles_lists_test.cpp.
