#include "fe/initial_stress.hpp"

namespace brunt {
namespace {

template <int Dim>
StressedStart start_of(const ElementBlock<Dim>& block) {
  return {*block.stress, *block.material, block.temperature, !block.state.temperature.empty()};
}

/// Stress and ratio of volumes of the material points of one element.
struct ElementStart {
  std::array<PlacedStress, kMostCorners> at;
  std::array<Real, kMostCorners> ratio{};
};

/// One ratio for all points of an element. Where the pressure is of the element it is the mean of
/// those at its points; where it is of volumes about nodes, the ratio is the mean of theirs.
/// node_ratio [1] by node; empty unless the block averages volumes
template <int Dim>
void share_ratio(const ElementBlock<Dim>& block, LocalIndex e, const std::vector<Real>& node_ratio,
                 StressedStart& start, ElementStart& element) {
  Real ratio = 0;
  if (!node_ratio.empty()) {
    for (const LocalIndex node : block.corners_of(e)) ratio += node_ratio[slot_of(node)];
    ratio /= block.corners;
  } else {
    Real pressure = 0, volume = 0;
    for (int g = 0; g < block.gauss; ++g) {
      const Real part = block.reference_volume[block.point(e, g)];
      pressure += part * element.at[slot_of(g)].pressure(), volume += part;
    }
    for (int g = 0; g < block.gauss; ++g) {
      auto& at = element.at[slot_of(g)];
      at = at.with_pressure(pressure / volume);
    }
    ratio = start.ratio(element.at[0]);
  }
  element.ratio.fill(ratio);
}

}  // namespace

template <int Dim>
void find_node_ratios(const Points<Dim>& points, const ElementBlock<Dim>& block,
                      std::vector<Real>& ratio) {
  StressedStart start = start_of(block);
  std::vector<char> known(points.x.size(), 0);
  ratio.resize(points.x.size(), 1.0);
  for (const LocalIndex node : block.corner) {
    const auto i = slot_of(node);
    if (known[i]) continue;
    known[i] = 1;
    ratio[i] = start.ratio(block.stress->at(in_space<Dim>(points.x[i])));
  }
}

template <int Dim>
void begin_under_stress(const Points<Dim>& points, ElementBlock<Dim>& block) {
  StressedStart start = start_of(block);
  std::vector<Real> node_ratio;
  if (block.formulation->averages_volumes()) find_node_ratios(points, block, node_ratio);
  const bool shares = block.gauss == 1 || block.options.integration == Integration::q1p0;
  for (LocalIndex e = 0; e < block.n_padded; ++e) {
    const auto x = corner_positions(block, e, points);
    ElementStart element;
    for (int g = 0; g < block.gauss; ++g) {
      const Vec<Dim> place = block.formulation->material_place(x, block.gauss, g);
      element.at[slot_of(g)] = block.stress->at(in_space<Dim>(place));
      if (!shares) element.ratio[slot_of(g)] = start.ratio(element.at[slot_of(g)]);
    }
    if (shares) share_ratio(block, e, node_ratio, start, element);
    Real before = 0, after = 0, energy = 0;
    for (int g = 0; g < block.gauss; ++g) {
      Real& volume = block.reference_volume[block.point(e, g)];
      const Real ratio = element.ratio[slot_of(g)];
      before += volume;
      volume /= ratio;
      after += volume;
      energy += volume * start.begin(element.at[slot_of(g)], ratio, block.state, block.point(e, g));
    }
    const auto k = slot_of(e);
    const Real ratio = shares ? element.ratio[0] : before / after;
    block.element_volume[k] /= ratio;
    block.mass[k] /= ratio;
    block.stress_work[k] = energy;
    if (!node_ratio.empty()) block.volume_ratio[k] = ratio;
  }
}

template void find_node_ratios(const Points<2>&, const ElementBlock<2>&, std::vector<Real>&);
template void find_node_ratios(const Points<3>&, const ElementBlock<3>&, std::vector<Real>&);
template void begin_under_stress(const Points<2>&, ElementBlock<2>&);
template void begin_under_stress(const Points<3>&, ElementBlock<3>&);

}  // namespace brunt
// Tested by tests/verification/initial_stress_test.cpp.
