#pragma once
/// How plastic work heats the points of a tile. V: Real or Pack.
#include "core/materials/material.hpp"
#include "core/simd.hpp"

namespace brunt {

/// What a strength takes from its material.
struct StrengthInputs {
  Real shear = 0;           ///< [Pa] G
  Real heat_capacity = 0;   ///< [J/m^3/K reference] rho0 c_p; 0: plastic work heats nothing
  Real taylor_quinney = 0;  ///< [1] part of plastic work that becomes heat
  /// Where it varies with temperature, which heat_capacity then is not read for; outlives the
  /// strength.
  const SpecificHeat* specific_heat = nullptr;
  Real density = 0;                 ///< [kg/m^3] rho0, where the specific heat varies
  Real tensile_cutoff = kInfinity;  ///< [Pa] for strengths that see the pressure
};

/// Heat [J/m^3 reference] per plastic work of the current volume [J/m^3].
template <class V>
BRUNT_INLINE V heat_factor(const StrengthInputs& inputs, const MaterialTile& tile, int i) {
  return (0.5 * inputs.taylor_quinney) *
         (load_as<V>(tile.ratio_old + i) + load_as<V>(tile.ratio + i));
}
inline bool heats(const StrengthInputs& inputs, const MaterialTile& tile) {
  return !tile.state->heat.empty() && inputs.heat_capacity > 0;
}

/// Temperature [K] of heat [J/m^3 reference], to first order at T [K].
template <class V>
V heating_at(const StrengthInputs& inputs, V T, V factor) {
  if (inputs.specific_heat == nullptr) return factor * (1.0 / inputs.heat_capacity);
  V per_heat{};
  for (int lane = 0; lane < lanes_of<V>; ++lane) {
    set_lane(per_heat, lane, 1.0 / (inputs.density * inputs.specific_heat->at(lane_of(T, lane))));
  }
  return factor * per_heat;
}

/// T [K] after heat [J/m^3 reference]: rho0 (h(after) - h(T)) is that heat.
template <class V>
V heated(const StrengthInputs& inputs, V T, V heat) {
  if (inputs.specific_heat == nullptr) return T + heat * (1.0 / inputs.heat_capacity);
  const SpecificHeat& cp = *inputs.specific_heat;
  for (int lane = 0; lane < lanes_of<V>; ++lane) {
    const Real per_mass = lane_of(heat, lane) / inputs.density, before = lane_of(T, lane);
    // What takes up no heat keeps its bits.
    if (per_mass == 0) continue;
    set_lane(T, lane, cp.temperature(cp.enthalpy(before) + per_mass));
  }
  return T;
}

/// Books the plastic work of the points from i of a tile [Pa, per current volume] as heat; the
/// state has a field of it.
template <class V>
BRUNT_INLINE void add_plastic_heat(const StrengthInputs& inputs, MaterialTile& tile, int i,
                                   V work) {
  MaterialState& state = *tile.state;
  const std::size_t at = tile.first + slot_of(i);
  const V heat = heat_factor<V>(inputs, tile, i) * work;
  store(state.heat.data() + at, load_as<V>(state.heat.data() + at) + heat);
  if (tile.adiabatic && heats(inputs, tile) && !state.temperature.empty()) {
    Real* T = state.temperature.data() + at;
    store(T, heated(inputs, load_as<V>(T), heat));
  }
}

}  // namespace brunt
// Tested by tests/unit/core/radial_return_test.cpp.
