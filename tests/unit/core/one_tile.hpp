#pragma once
#include <algorithm>

#include "core/materials/material.hpp"

namespace brunt {

/// One tile of a state, at rest, unstrained, for tests: fill in what differs.
struct OneTile {
  MaterialState state;
  MaterialTile tile;

  explicit OneTile(MaterialState start) : state(std::move(start)) {
    tile.count = kTile;
    tile.fixed_temperature = 298;
    for (auto& component : tile.strain) std::fill_n(component, kTile, 0.0);
    std::fill_n(tile.ratio_old, kTile, 1.0);
    std::fill_n(tile.ratio, kTile, 1.0);
    std::fill_n(tile.viscous_work, kTile, 0.0);
  }
  MaterialTile& at_first(std::size_t first = 0) {
    tile.state = &state;
    tile.first = first;
    return tile;
  }
};

/// Every field that a strength with heat may touch, zero, at temperature T [K].
inline MaterialState full_state(Real temperature) {
  MaterialState state;
  for (auto& component : state.deviator) component.assign(kTile, 0.0);
  for (auto* field : {&state.pressure, &state.eps_p, &state.strain_rate, &state.heat, &state.energy,
                      &state.bulk}) {
    field->assign(kTile, 0.0);
  }
  state.temperature.assign(kTile, temperature);
  return state;
}

/// Equivalent stress sqrt(3/2 s:s) of a point [Pa].
inline Real equivalent_stress(const MaterialState& state, std::size_t i) {
  Real square = 0;
  for (std::size_t c = 0; c < 6; ++c) {
    square += (c < 3 ? 1.5 : 3.0) * state.deviator[c][i] * state.deviator[c][i];
  }
  return std::sqrt(square);
}

}  // namespace brunt
