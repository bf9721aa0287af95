#include "fe/mass_scaling.hpp"

#include <algorithm>

#include "core/exact_sum.hpp"
#include "fe/formulation.hpp"

namespace brunt {

template <int Dim>
void scale_masses(ElementBlock<Dim>& block, const ElementStep<Dim>& step) {
  const Real least = block.options.least_step;
  if (!(least > 0) || block.held) return;
  for (int t = 0; t < block.n_tiles(); ++t) {
    block.formulation->refresh_stable_steps(block, t, step);
  }
  const auto is_short = [&](Real own) { return own < least; };
  if (std::none_of(block.stable_step.begin(), block.stable_step.end(), is_short)) return;
  block.mass_scale.assign(block.mass.size(), 1.0);
  for (std::size_t e = 0; e < block.mass.size(); ++e) {
    const Real ratio = least / block.stable_step[e];
    if (!(ratio > 1)) continue;
    block.mass_scale[e] = ratio * ratio;
    block.mass[e] *= block.mass_scale[e];
  }
}

template <int Dim>
AddedMass added_mass(const std::vector<ElementBlock<Dim>>& blocks, Label body) {
  AddedMass sums;
  ExactSum added, material;
  for (const auto& block : blocks) {
    for (std::size_t e = 0; e < slot_of(block.n); ++e) {
      if (block.body[e] != body || !block.owned[e]) continue;
      const Real own = block.material_mass(e);
      ++sums.n;
      material.add(own);
      if (!(block.mass[e] > own)) continue;
      ++sums.n_scaled;
      added.add(block.mass[e] - own);
    }
  }
  sums.added = added.value(), sums.material = material.value();
  return sums;
}

template void scale_masses(ElementBlock<2>&, const ElementStep<2>&);
template void scale_masses(ElementBlock<3>&, const ElementStep<3>&);
template AddedMass added_mass(const std::vector<ElementBlock<2>>&, Label);
template AddedMass added_mass(const std::vector<ElementBlock<3>>&, Label);

}  // namespace brunt
// Tested by tests/unit/fe/mass_scaling_test.cpp.
