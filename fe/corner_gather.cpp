#include "fe/corner_gather.hpp"

#include <algorithm>
#include <utility>

#include "core/parallel/threads.hpp"

namespace brunt {
namespace {
constexpr LocalIndex kNodesWorthThreads = 2048;  // nodes
}

template <int W>
void CornerGather::add(const Real* value, std::vector<Vec<W>>& out) const {
  const auto n = static_cast<LocalIndex>(offset.size()) - 1;
  for_each(n, kNodesWorthThreads, [&](LocalIndex node) {
    Real sum[W] = {};
    for (std::int64_t k = offset[node]; k < offset[node + 1]; ++k) {
      const Real* from = value + slot_of(place[k]) * W;
      for (int i = 0; i < W; ++i) sum[i] += from[i];
    }
    for (int i = 0; i < W; ++i) out[node][i] += sum[i];
  });
}

template <int Dim>
CornerGather make_corner_gather(const std::vector<ElementBlock<Dim>>& blocks, LocalIndex n_nodes) {
  CornerGather gather;
  gather.offset.assign(slot_of(n_nodes) + 1, 0);
  std::vector<std::pair<GlobalId, std::pair<LocalIndex, LocalIndex>>> order;  // id, block, element
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    for (LocalIndex e = 0; e < blocks[b].n; ++e) {
      order.push_back({blocks[b].id[e], {static_cast<LocalIndex>(b), e}});
      for (const LocalIndex node : blocks[b].corners_of(e)) {
        if (node < n_nodes) ++gather.offset[node + 1];
      }
    }
  }
  std::sort(order.begin(), order.end());
  for (LocalIndex k = 0; k < n_nodes; ++k) gather.offset[k + 1] += gather.offset[k];
  gather.place.resize(slot_of(gather.offset.back()));
  std::vector<std::int64_t> next(gather.offset.begin(), gather.offset.end() - 1);
  for (const auto& [id, where] : order) {
    const ElementBlock<Dim>& block = blocks[where.first];
    const auto n = slot_of(block.corners);
    for (std::size_t I = 0; I < n; ++I) {
      const std::size_t corner = slot_of(where.second) * n + I;
      const LocalIndex node = block.corner[corner];
      if (node >= n_nodes) continue;
      gather.place[next[node]++] = static_cast<LocalIndex>(block.first_corner + corner);
    }
  }
  return gather;
}

template void CornerGather::add<1>(const Real*, std::vector<Vec<1>>&) const;
template void CornerGather::add<2>(const Real*, std::vector<Vec<2>>&) const;
template void CornerGather::add<3>(const Real*, std::vector<Vec<3>>&) const;
template CornerGather make_corner_gather(const std::vector<ElementBlock<2>>&, LocalIndex);
template CornerGather make_corner_gather(const std::vector<ElementBlock<3>>&, LocalIndex);

}  // namespace brunt
// Tested by tests/unit/fe/finite_elements_test.cpp.
