#include "core/materials/eos_linear.hpp"

#include "core/simd.hpp"

namespace brunt {

void LinearEquation::update(MaterialTile& tile, const Real*) const {
  for (int i = 0; i < tile.count; i += kLanes) {
    const std::size_t at = tile.first + slot_of(i);
    const Pack relative_density = 1.0 / load(tile.ratio + i);
    store(tile.state->pressure.data() + at, bulk_ * (relative_density - 1.0));
    store(tile.state->bulk.data() + at, bulk_ * relative_density);
  }
}

}  // namespace brunt
// Tested by tests/unit/core/eos_test.cpp.
