/// docs/theory/heat.md (H4) to (H6), (H10).
#include "fe/conduction.hpp"

#include <algorithm>

namespace brunt {
namespace {

/// Rate [W] of the plastic and compression heat that the nodes of element k do not have yet; they
/// have it then.
template <int Dim>
BRUNT_INLINE Real take_mechanical_heat(ElementBlock<Dim>& block, std::size_t k, Real inverse_dt) {
  const auto e = static_cast<LocalIndex>(k);
  const Real heat = plastic_heat(block, e) + compression_heat(block, e);
  const Real rate = (heat - block.heat_given[k]) * inverse_dt;
  block.heat_given[k] = heat;
  return rate;
}

}  // namespace

template <int Dim>
void add_mechanical_heat(ElementBlock<Dim>& block, std::size_t e, const ConductionStep<Dim>& step) {
  if (!(step.inverse_dt > 0) || block.heat_given.empty()) return;
  const auto n = slot_of(block.corners);
  for (std::size_t k = e; k < e + kGroup; ++k) {
    const Real rate = take_mechanical_heat(block, k, step.inverse_dt);
    if (rate == 0) continue;
    for (std::size_t I = k * n; I < (k + 1) * n; ++I) {
      step.corner_heat[2 * I] += rate * block.heat_share[I];
    }
  }
}

template <int Dim>
void give_mechanical_heat(ElementBlock<Dim>& block, std::size_t e, Real inverse_dt,
                          Real* corner_heat) {
  const auto n = slot_of(block.corners);
  for (std::size_t k = e; k < e + kLanes; ++k) {
    const Real rate = take_mechanical_heat(block, k, inverse_dt);
    for (std::size_t I = k * n; I < (k + 1) * n; ++I) corner_heat[I] = rate * block.heat_share[I];
  }
}

template <int Dim>
std::vector<const Material*> materials_that_vary(const std::vector<ElementBlock<Dim>>& blocks) {
  std::vector<const Material*> materials;
  for (const auto& block : blocks) {
    if (!block.conducts || !block.material->specific_heat.varies()) continue;
    if (std::find(materials.begin(), materials.end(), block.material) == materials.end()) {
      materials.push_back(block.material);
    }
  }
  return materials;
}

template std::vector<const Material*> materials_that_vary(const std::vector<ElementBlock<2>>&);
template std::vector<const Material*> materials_that_vary(const std::vector<ElementBlock<3>>&);
template void add_mechanical_heat(ElementBlock<2>&, std::size_t, const ConductionStep<2>&);
template void add_mechanical_heat(ElementBlock<3>&, std::size_t, const ConductionStep<3>&);
template void give_mechanical_heat(ElementBlock<2>&, std::size_t, Real, Real*);
template void give_mechanical_heat(ElementBlock<3>&, std::size_t, Real, Real*);

}  // namespace brunt
