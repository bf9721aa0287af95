/// Volumes about nodes, of elements whose pressure is of them (docs/theory/elements.md, section 8).
#include <algorithm>

#include "fe/finite_elements.hpp"
#include "fe/initial_stress.hpp"

namespace brunt {
namespace {
[[maybe_unused]] constexpr int kVolumesWorthThreads = 256;  // tiles; of some 0.3 us each

template <int Dim>
bool averages(const ElementBlock<Dim>& block) {
  return block.formulation->averages_volumes();
}
}  // namespace

template <int Dim>
void FiniteElements<Dim>::start_volumes() {
  averages_volumes_ =
      averages_volumes_ || std::any_of(blocks_.begin(), blocks_.end(), averages<Dim>);
  if (!averages_volumes_) return;
  node_ratio_.assign(points_.x.size(), 1.0);
  corner_volume_.assign(n_corners_, 0.0);
  for (const auto& block : blocks_) {
    if (!averages(block)) continue;
    Real* out = corner_volume_.data() + block.first_corner;
    for (int t = 0; t < block.n_tiles(); ++t) {
      block.formulation->write_corner_volumes(block, t, points_.x.data(), out);
    }
  }
  std::vector<Vec<1>> sum(points_.x.size(), Vec<1>::Zero());
  gather_.template add<1>(corner_volume_.data(), sum);
  start_volume_.clear();
  for (const auto& volume : sum) start_volume_.push_back(volume[0]);
  for (const auto& block : blocks_) {
    if (averages(block) && block.stress != nullptr) find_node_ratios(points_, block, node_ratio_);
  }
  for (std::size_t i = 0; i < start_volume_.size(); ++i) start_volume_[i] /= node_ratio_[i];
}

/// The sums are over all elements about a node, by ascending id: the same on any rank that owns it.
template <int Dim>
void FiniteElements<Dim>::update_volumes() {
  for (const auto& block : blocks_) {
    if (!averages(block)) continue;
    Real* out = corner_volume_.data() + block.first_corner;
    const int n = block.n_tiles();
#pragma omp parallel for schedule(static) if (n > kVolumesWorthThreads)
    for (int t = 0; t < n; ++t) {
      block.formulation->write_corner_volumes(block, t, points_.x.data(), out);
    }
  }
  node_volume_.assign(points_.x.size(), Vec<1>::Zero());
  gather_.template add<1>(corner_volume_.data(), node_volume_);
  for (std::size_t i = 0; i < points_.owned(); ++i) {
    if (start_volume_[i] > 0) node_ratio_[i] = node_volume_[i][0] / start_volume_[i];
  }
}

template <int Dim>
void FiniteElements<Dim>::refresh_state() {
  if (!averages_volumes_ || ranks_ == nullptr) return;
  refresh_ghosts(
      *ranks_, ghosts_, 1, [&](std::size_t i, Real* out) { *out = node_ratio_[i]; },
      [&](std::size_t i, const Real* in) { node_ratio_[i] = *in; });
}

template void FiniteElements<2>::start_volumes();
template void FiniteElements<3>::start_volumes();
template void FiniteElements<2>::update_volumes();
template void FiniteElements<3>::update_volumes();
template void FiniteElements<2>::refresh_state();
template void FiniteElements<3>::refresh_state();

}  // namespace brunt
// Tested by tests/unit/fe/tet4_test.cpp.
