#include "sph/neighbour_rows.hpp"

#include <algorithm>
#include <utility>

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
  near_.resize(static_cast<std::size_t>(next));
}

template <int Dim>
void NeighbourRows<Dim>::sort_by(std::span<const GlobalId> id) {
  const auto before = [&](LocalIndex a, LocalIndex b) {
    return id[static_cast<std::size_t>(a)] < id[static_cast<std::size_t>(b)];
  };
  const auto begin = list_.neighbour.begin();
  for (std::size_t i = 0; i + 1 < list_.offset.size(); ++i) {
    std::sort(begin + list_.offset[i], begin + list_.offset[i + 1], before);
  }
}

template <int Dim>
void NeighbourRows<Dim>::refresh(const MotionRecord<Dim>* records, LocalIndex i) {
  constexpr int inverse = MotionRecord<Dim>::kInverse;
  const auto k = static_cast<std::size_t>(i);
  const LocalIndex* candidate = list_.neighbour.data() + list_.offset[k];
  const auto n = static_cast<int>(list_.offset[k + 1] - list_.offset[k]);
  const Real* own = records[i].data;
  LocalIndex* out = near_.data() + first_[k];
  int found = 0, c = 0;
  for (; c + kLanes <= n; c += kLanes) {
    const PackMask inside = SquaredRatio<Dim>(records, own, candidate + c).q2 < 4.0;
    for (int lane = 0; lane < kLanes; ++lane) {
      out[found] = candidate[c + lane];
      found -= static_cast<int>(inside[lane]);  // an inside lane is -1
    }
  }
  for (; c < n; ++c) {
    const Real* other = records[candidate[c]].data;
    Real r2 = (other[0] - own[0]) * (other[0] - own[0]);
    for (int d = 1; d < Dim; ++d) r2 = r2 + (other[d] - own[d]) * (other[d] - own[d]);
    const Real inverse_h = 0.5 * (other[inverse] + own[inverse]);
    if (r2 * (inverse_h * inverse_h) < 4.0) out[found++] = candidate[c];
  }
  count_[k] = found;
  while (found % kLanes != 0) out[found++] = i;
}

template class NeighbourRows<2>;
template class NeighbourRows<3>;

}  // namespace brunt
