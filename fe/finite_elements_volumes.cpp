/// Volumes about nodes, of elements whose pressure is of them (docs/theory/elements.md, section 8).
#include <algorithm>

#include "core/parallel/threads.hpp"
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
  order_corners();
  node_ratio_.assign(points_.x.size(), 1.0);
  corner_volume_.assign(n_corners_, 0.0);
  sum_volumes(points_.x);
  start_volume_.clear();
  for (const auto& volume : node_volume_) start_volume_.push_back(volume[0]);
  for (const auto& block : blocks_) {
    if (averages(block) && block.stress != nullptr) find_node_ratios(points_, block, node_ratio_);
  }
  for (std::size_t i = 0; i < start_volume_.size(); ++i) start_volume_[i] /= node_ratio_[i];
}

/// The sums are over all elements about a node, by ascending id: the same on any rank that owns it.
template <int Dim>
void FiniteElements<Dim>::sum_volumes(const std::vector<Vec<Dim>>& x) {
  for (const auto& block : blocks_) {
    if (!averages(block)) continue;
    Real* out = corner_volume_.data() + block.first_corner;
    const int n = block.n_tiles();
    for_each(n, kVolumesWorthThreads,
             [&](int t) { block.formulation->write_corner_volumes(block, t, x.data(), out); });
  }
  node_volume_.assign(points_.x.size(), Vec<1>::Zero());
  gather_.template add<1>(corner_volume_.data(), node_volume_);
}

template <int Dim>
void FiniteElements<Dim>::update_volumes() {
  sum_volumes(points_.x);
  for (std::size_t i = 0; i < points_.owned(); ++i) {
    if (start_volume_[i] > 0) node_ratio_[i] = node_volume_[i][0] / start_volume_[i];
  }
}

/// (E20): what goes does no work on what stays, so that volume ratios are those before it went. By
/// the ratio that the rest has of its own at time 0, pressures would jump, and viscosity would take
/// the jump for a rate.
template <int Dim>
void FiniteElements<Dim>::keep_ratios(const VolumesBefore& before, const std::vector<Vec<Dim>>& x) {
  if (!averages_volumes_) return;
  sum_volumes(x);
  for (std::size_t i = 0; i < points_.owned(); ++i) {
    const auto elements = [i](const std::vector<std::int64_t>& offset) {
      return offset[i + 1] - offset[i];
    };
    const bool lost = elements(gather_.offset) != elements(before.offset);
    start_volume_[i] = lost ? node_volume_[i][0] / before.ratio[i] : before.start[i];
  }
}

namespace {
constexpr const char* kVolumes = "node.volumes";
}  // namespace

template <int Dim>
void FiniteElements<Dim>::save_volumes(std::vector<StateTable>& tables) const {
  if (!averages_volumes_ || start_volume_.empty()) return;
  save_rows(
      kVolumes, points_.owned(), [&](std::size_t i) { return points_.id[i]; },
      [&](auto& row, std::size_t i) { row(start_volume_[i]), row(node_ratio_[i]); }, tables);
}

/// Every point takes its row, ghosts too, whose ratios elements ask for before they are summed
/// again.
template <int Dim>
void FiniteElements<Dim>::load_volumes(const StateTables& tables) {
  if (!averages_volumes_ || start_volume_.empty() || !tables.has(kVolumes)) return;
  load_rows(
      kVolumes, points_.x.size(), [&](std::size_t i) { return points_.id[i]; },
      [&](auto& row, std::size_t i) { row(start_volume_[i]), row(node_ratio_[i]); }, tables);
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
template void FiniteElements<2>::sum_volumes(const std::vector<Vec<2>>&);
template void FiniteElements<2>::keep_ratios(const VolumesBefore&, const std::vector<Vec<2>>&);
template void FiniteElements<2>::save_volumes(std::vector<StateTable>&) const;
template void FiniteElements<2>::load_volumes(const StateTables&);
template void FiniteElements<3>::update_volumes();
template void FiniteElements<3>::sum_volumes(const std::vector<Vec<3>>&);
template void FiniteElements<3>::keep_ratios(const VolumesBefore&, const std::vector<Vec<3>>&);
template void FiniteElements<3>::save_volumes(std::vector<StateTable>&) const;
template void FiniteElements<3>::load_volumes(const StateTables&);
template void FiniteElements<2>::refresh_state();
template void FiniteElements<3>::refresh_state();

}  // namespace brunt
// Tested by tests/unit/fe/tet4_test.cpp.
