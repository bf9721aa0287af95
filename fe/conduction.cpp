/// docs/theory/heat.md (H4) to (H6), (H10).
#include "fe/conduction.hpp"

#include <algorithm>

namespace brunt {
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

}  // namespace brunt
