#pragma once
/// The fields that a body shows of the state of its material.
#include <cmath>

#include "core/materials/material.hpp"
#include "core/view_fields.hpp"

namespace brunt {

/// [Pa] sqrt(3/2 s:s) of a point of a state.
inline Real von_mises(const MaterialState& state, std::size_t point) {
  Real sum = 0;
  for (std::size_t i = 0; i < 6; ++i) {
    const Real s = state.deviator[i][point];
    sum += (i < 3 ? 1.0 : 2.0) * (s * s);
  }
  return std::sqrt(1.5 * sum);
}

/// [Pa] The deviator, and the pressure behind it, of a point of a state.
inline std::array<Real, 7> stress_parts(const MaterialState& state, std::size_t point) {
  std::array<Real, 7> parts;
  for (std::size_t i = 0; i < 6; ++i) parts[i] = state.deviator[i][point];
  parts[6] = state.pressure[point];
  return parts;
}

/// Adds stress, pressure and what else the material has.
/// n       entities of the body
/// of      of(k, value): what the k-th shows of value(state, point), numbers or arrays of them, of
///         its material points
/// there   there(member): whether all of them have this variable of MaterialState
/// heats   the temperature is the material's
template <class Of, class There>
void add_state_fields(FieldAdder& fields, std::size_t n, const Of& of, const There& there,
                      bool heats) {
  const auto pressure = [](const MaterialState& s, std::size_t p) { return s.pressure[p]; };
  fields.add("stress", n, [of](std::size_t k) {
    const std::array<Real, 7> parts = of(k, stress_parts);
    std::array<Real, 6> stress;
    for (std::size_t i = 0; i < 6; ++i) stress[i] = i < 3 ? parts[i] - parts[6] : parts[i];
    return stress;
  });
  fields.add("pressure", n, [of, pressure](std::size_t k) { return of(k, pressure); });
  fields.add("von_mises", n, [of](std::size_t k) { return of(k, von_mises); });
  const auto add = [&](const char* name, std::vector<Real> MaterialState::*member) {
    if (!there(member)) return;
    fields.add(name, n, [of, member](std::size_t k) {
      return of(k, [member](const MaterialState& s, std::size_t p) { return (s.*member)[p]; });
    });
  };
  add("eps_p", &MaterialState::eps_p);
  add("strain_rate", &MaterialState::strain_rate);
  add("plastic_volume", &MaterialState::plastic_volume);
  add("opening", &MaterialState::opening);
  add("damage", &MaterialState::damage);
  add("porosity", &MaterialState::porosity);
  add("tensile_strength", &MaterialState::tensile_strength);
  if (heats) add("temperature", &MaterialState::temperature);
}

}  // namespace brunt
// Tested by tests/unit/core/view_fields_test.cpp.
