#pragma once
/// The state of a material point as values of a row.
#include "core/field_use.hpp"
#include "core/materials/material.hpp"
#include "core/state.hpp"

namespace brunt {

/// Hands all that point k of a state carries to f(value, use); what is empty is not there.
/// of_particles  use of what particles hash and elements do not
template <class State, class F>
void visit_material_point(State& state, std::size_t k, FieldUse of_particles, const F& f) {
  const auto optional = [&](auto& field, FieldUse use) {
    if (!field.empty()) f(field[k], use);
  };
  for (auto& component : state.deviator) f(component[k], kState);
  f(state.pressure[k], kState);
  f(state.bulk[k], of_particles);
  optional(state.eps_p, kState);
  optional(state.strain_rate, kState);  // the return begins from it
  optional(state.temperature, kState);
  optional(state.heat, of_particles);
  optional(state.compression_heat, kState);
  optional(state.energy, kState);
  optional(state.expansion, kSaved);
  optional(state.expansion_work, kSaved);
  optional(state.start_temperature, kSaved);
  optional(state.plastic_volume, kState);
  optional(state.opening, kState);
  for (auto* field : {&state.damage_index, &state.damage, &state.softening_work}) {
    optional(*field, kState);
  }
  optional(state.softening_limit, kSaved);
  optional(state.softening_energy, kSaved);
  optional(state.length, kSaved);
  optional(state.porosity, kSaved);
  optional(state.tensile_strength, kSaved);
  for (auto& variable : state.own) optional(variable, kState);
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
  if (!state.expansion.empty()) text += ".expansion";
  if (!state.start_temperature.empty()) text += ".start";
  if (!state.plastic_volume.empty()) text += ".volume";
  if (!state.damage.empty()) text += ".damage";
  if (!state.softening_work.empty()) text += ".softening";
  if (!state.own.empty()) text += ".own" + std::to_string(state.own.size());
  return text;
}

}  // namespace brunt
// Tested by tests/unit/core/state_test.cpp.
