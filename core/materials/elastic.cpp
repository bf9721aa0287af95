#include "core/materials/elastic.hpp"

namespace brunt {

void ElasticStrength::update(MaterialTile& tile, Real) const {
  for (int i = 0; i < tile.count; i += kLanes) {
    const Pack third =
        (load(tile.strain[xx] + i) + load(tile.strain[yy] + i) + load(tile.strain[zz] + i)) *
        (1.0 / 3.0);
    for (std::size_t c = 0; c < 6; ++c) {
      Real* stress = tile.state->deviator[c].data() + tile.first + i;
      const Pack mean = c < 3 ? third : Pack{};
      store(stress, trial_stress(load(stress), load(tile.strain[c] + i), mean, shear_));
    }
  }
}

}  // namespace brunt
// Tested by tests/unit/core/material_test.cpp.
