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
    next += (list_.offset[i + 1] - list_.offset[i] + kLanes - 1) / kLanes * kLanes;
  }
  near_.resize(slot_of(next));
  weight_.resize(slot_of(next));
}

/// Which of four pairs (i, j) interact.
template <int Dim>
BRUNT_INLINE PackMask inside_support(const MotionRecord<Dim>* records, const Real* own,
                                     const LocalIndex* j) {
  FourPairs<Dim> pairs;
  set_arms(records, own, j, pairs);
  return pairs.q2 < 4.0;
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
void NeighbourRows<Dim>::refresh(const MotionRecord<Dim>* records, LocalIndex i) {
  const auto k = slot_of(i);
  const LocalIndex* candidate = list_.neighbour.data() + list_.offset[k];
  const auto n = static_cast<int>(list_.offset[k + 1] - list_.offset[k]);
  const Real* own = records[i].data;
  LocalIndex* out = near_.data() + first_[k];
  int found = 0;
  const auto take = [&](const LocalIndex* four, unsigned among) {
    const unsigned set = mask_bits(inside_support(records, own, four)) & among;
    store_permuted(out + found, four, kCompression.lane[set]);  // never past the padded row
    found += kCompression.count[set];
  };
  int c = 0;
  for (; c + kLanes <= n; c += kLanes) take(candidate + c, 15U);
  if (c < n) {
    LocalIndex rest[kLanes] = {i, i, i, i};
    std::copy(candidate + c, candidate + n, rest);
    take(rest, (1U << (n - c)) - 1U);
  }
  count_[k] = found;
  while (found % kLanes != 0) out[found++] = i;
}

template class NeighbourRows<2>;
template class NeighbourRows<3>;

}  // namespace brunt
// Tested by tests/unit/sph/particles_lists_test.cpp.
