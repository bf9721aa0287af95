#include "sph/neighbour_rows.hpp"

#include <algorithm>
#include <utility>

#include "core/simd_float.hpp"

namespace brunt {

template <int Dim>
void NeighbourRows<Dim>::assign(NeighbourList list) {
  list_ = std::move(list);
  const std::size_t n = list_.offset.size() - 1;
  first_.resize(n);
  count_.assign(n, 0);
  std::int64_t next = 0;
  for (std::size_t i = 0; i < n; ++i) {
    first_[i] = next;
    constexpr auto most = kSingleLanes;
    next += (list_.offset[i + 1] - list_.offset[i] + most - 1) / most * most;
  }
  near_.resize(slot_of(next));
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
void NeighbourRows<Dim>::refresh(const MotionRecord<Dim, P>* records, LocalIndex i) {
  const auto k = slot_of(i);
  const LocalIndex* candidate = list_.neighbour.data() + list_.offset[k];
  const auto n = static_cast<int>(list_.offset[k + 1] - list_.offset[k]);
  const auto* own = records[i].data;
  LocalIndex* out = near_.data() + first_[k];
  int found = 0;
  const auto take = [&](const LocalIndex* pack, unsigned among) {
    const unsigned set = inside_support<Dim, P>(records, own, pack) & among;
    for (int four = 0; four < P::kLanes; four += kLanes) {
      const unsigned some = set >> four & 15U;
      store_permuted(out + found, pack + four, kCompression.lane[some]);  // within the padded row
      found += kCompression.count[some];
    }
  };
  int c = 0;
  for (; c + P::kLanes <= n; c += P::kLanes) take(candidate + c, (1U << P::kLanes) - 1U);
  if (c < n) {
    LocalIndex rest[P::kLanes];
    std::fill(rest, rest + P::kLanes, i);
    std::copy(candidate + c, candidate + n, rest);
    take(rest, (1U << (n - c)) - 1U);
  }
  count_[k] = found;
  while (found % kSingleLanes != 0) out[found++] = i;
}

template class NeighbourRows<2>;
template class NeighbourRows<3>;
template void NeighbourRows<2>::refresh(const MotionRecord<2, DoublePairs>*, LocalIndex);
template void NeighbourRows<3>::refresh(const MotionRecord<3, DoublePairs>*, LocalIndex);
template void NeighbourRows<2>::refresh(const MotionRecord<2, SinglePairs>*, LocalIndex);
template void NeighbourRows<3>::refresh(const MotionRecord<3, SinglePairs>*, LocalIndex);

}  // namespace brunt
// Tested by tests/unit/sph/particles_lists_test.cpp.
