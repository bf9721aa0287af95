#pragma once
/// The state of a material point as values of a row.
#include "core/materials/material.hpp"
#include "core/state.hpp"

namespace brunt {

/// Hands all that point k of a state carries to row.
template <class Row, class State>
void visit_material_point(Row& row, State& state, std::size_t k) {
  for (auto& component : state.deviator) row(component[k]);
  row(state.pressure[k]);
  row(state.bulk[k]);
  for (auto* field :
       {&state.eps_p, &state.strain_rate, &state.temperature, &state.heat, &state.compression_heat,
        &state.energy, &state.plastic_volume, &state.opening, &state.damage_index, &state.damage,
        &state.softening_work, &state.softening_limit, &state.length}) {
    if (!field->empty()) row((*field)[k]);
  }
}

/// The optional fields of a state, for the name of a table: states with the same text have rows of
/// the same columns.
inline std::string fields_of(const MaterialState& state) {
  std::string text;
  if (!state.eps_p.empty()) text += ".plastic";
  if (!state.temperature.empty()) text += ".temperature";
  if (!state.heat.empty()) text += ".heat";
  if (!state.compression_heat.empty()) text += ".compression";
  if (!state.energy.empty()) text += ".energy";
  if (!state.plastic_volume.empty()) text += ".volume";
  if (!state.damage.empty()) text += ".damage";
  if (!state.length.empty()) text += ".softening";
  return text;
}

}  // namespace brunt
// Tested by tests/unit/core/state_test.cpp.
