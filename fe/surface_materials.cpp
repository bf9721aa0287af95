/// What friction needs to know of the elements behind the facets.
#include <algorithm>

#include "core/parallel/threads.hpp"
#include "fe/finite_elements.hpp"

namespace brunt {

namespace {
[[maybe_unused]] constexpr std::size_t kFacetsWorthThreads = 1000;  // facets

/// Means over the material points of an element, as the last step left them.
template <int Dim>
SurfaceMaterial material_of(const ElementBlock<Dim>& block, LocalIndex element) {
  const MaterialState& state = block.state;
  SurfaceMaterial mean{0, 0};
  for (int g = 0; g < block.gauss; ++g) {
    const std::size_t k = block.point(element, g);
    mean.temperature += state.temperature.empty() ? block.temperature : state.temperature[k];
    mean.flow_stress += block.material->strength->flow_stress(state, k, block.temperature);
  }
  mean.temperature /= block.gauss, mean.flow_stress /= block.gauss;
  if (block.rigid) mean.flow_stress = kInfinity;
  return mean;
}
}  // namespace

template <int Dim>
void FiniteElements<Dim>::find_elements_of_facets() {
  const auto& facets = surface_.facets;  // by ascending id
  element_of_facet_.assign(facets.size(), {});
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    for (LocalIndex e = 0; e < blocks_[b].n; ++e) {
      const GlobalId id = blocks_[b].id[e];
      auto at = std::lower_bound(
          facets.begin(), facets.end(), id << 3,
          [](const Facet<Dim>& facet, GlobalId first) { return facet.id < first; });
      for (; at != facets.end() && at->id >> 3 == id; ++at) {
        element_of_facet_[at - facets.begin()] = {b, e};
      }
    }
  }
}

template <int Dim>
void FiniteElements<Dim>::update_state(Real) {
  if (averages_volumes_) update_volumes();
  if (!surface_.needs_material) return;
  // Else their laws see the temperatures where they strain.
  if (held_ && points_.conducts) interpolate_temperatures();
  if (element_of_facet_.empty()) find_elements_of_facets();
  auto& shown = surface_.facet_material;
  shown.resize(surface_.facets.size());
  for_each(shown.size(), kFacetsWorthThreads, [&](std::size_t f) {
    const auto& [block, element] = element_of_facet_[f];
    shown[f] = material_of(blocks_[block], element);
  });
}

template void FiniteElements<2>::update_state(Real);
template void FiniteElements<3>::update_state(Real);

}  // namespace brunt
