/// docs/theory/heat.md (H4) to (H6), (H10).
#include "fe/conduction.hpp"

#include <algorithm>

namespace brunt {
namespace {

/// Adds the heat [J] of a group of elements from that of their material points [J/m^3 reference],
/// the first of which is `first`; none where there is none.
template <int Dim>
BRUNT_INLINE void add_heat_of(const ElementBlock<Dim>& block, std::size_t first,
                              const std::vector<Real>& by_point, Real (&heat)[kGroup]) {
  if (by_point.empty()) return;
  Real sum[kGroup] = {};
  for (std::size_t p = first; p < first + slot_of(kGroup * block.gauss); p += kGroup) {
    for (std::size_t k = 0; k < kGroup; ++k) {
      sum[k] += block.reference_volume[p + k] * by_point[p + k];
    }
  }
  for (std::size_t k = 0; k < kGroup; ++k) heat[k] += sum[k];
}

}  // namespace

template <int Dim>
void give_mechanical_heat(ElementBlock<Dim>& block, std::size_t e, Real inverse_dt, Real* rate) {
  const std::size_t first = block.point(static_cast<LocalIndex>(e), 0);
  Real heat[kGroup] = {};
  add_heat_of(block, first, block.state.heat, heat);
  add_heat_of(block, first, block.state.compression_heat, heat);
  Real* const given = block.heat_given.data() + e;
  for (std::size_t k = 0; k < kGroup; ++k) {
    rate[k] = (heat[k] - given[k]) * inverse_dt;
    given[k] = heat[k];
  }
}

template <int Dim>
void add_mechanical_heat(ElementBlock<Dim>& block, std::size_t e, const ConductionStep<Dim>& step) {
  if (!(step.inverse_dt > 0) || block.heat_given.empty()) return;
  Real rate[kGroup];
  give_mechanical_heat(block, e, step.inverse_dt, rate);
  const auto n = slot_of(block.corners);
  for (std::size_t k = 0; k < kGroup; ++k) {
    if (rate[k] == 0) continue;
    for (std::size_t I = (e + k) * n; I < (e + k + 1) * n; ++I) {
      step.corner_heat[2 * I] += rate[k] * block.heat_share[I];
    }
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
