#include "core/materials/material.hpp"

#include "core/simd_math.hpp"

namespace brunt {

namespace {

using Tensors = Real[6][kTile];

void copy_deviator(const MaterialTile& tile, Tensors& copy) {
  for (std::size_t c = 0; c < 6; ++c) {
    const Real* component = tile.state->deviator[c].data() + tile.first;
    std::copy_n(component, tile.count, copy[c]);
  }
}

/// Work of the deviator in this step, 1/2 (J s before + J s after) : strain, J = V/V0.
void deviatoric_work(const MaterialTile& tile, const Tensors& before, Real* work) {
  for (int i = 0; i < tile.count; i += kLanes) {
    const Pack half_old = 0.5 * load(tile.ratio_old + i), half = 0.5 * load(tile.ratio + i);
    Pack sum{};
    for (std::size_t c = 0; c < 6; ++c) {
      const Real* after = tile.state->deviator[c].data() + tile.first + i;
      const Pack mean = half_old * load(before[c] + i) + half * load(after);
      sum = sum + (c < 3 ? 1.0 : 2.0) * (mean * load(tile.strain[c] + i));
    }
    store(work + i, sum);
  }
}

/// Holds the pressure above minus the cut-off. The equation of state has booked the work of the
/// pressure before that; its energy gets the difference.
void cut_off(MaterialTile& tile, Real cutoff) {
  MaterialState& state = *tile.state;
  for (int i = 0; i < tile.count; i += kLanes) {
    const std::size_t at = tile.first + static_cast<std::size_t>(i);
    const Pack p = load(state.pressure.data() + at);
    const Pack held = vmax(p, broadcast<Pack>(-cutoff));
    store(state.pressure.data() + at, held);
    if (state.energy.empty()) continue;
    const Pack change = load(tile.ratio + i) - load(tile.ratio_old + i);
    const Pack energy = load(state.energy.data() + at) - (0.5 * (held - p)) * change;
    store(state.energy.data() + at, energy);
  }
}

}  // namespace

MaterialState Material::initial_state(std::size_t n, Real temperature, bool adiabatic) const {
  const std::size_t size = (n + kTile - 1) / kTile * kTile;
  MaterialState state;
  for (auto& component : state.deviator) component.assign(size, 0.0);
  state.pressure.assign(size, 0.0);
  state.bulk.assign(size, eos->bulk_modulus());
  if (yields()) {
    state.eps_p.assign(size, 0.0);
    state.strain_rate.assign(size, 0.0);
  }
  if (adiabatic && thermal) {
    state.temperature.assign(size, temperature);
    if (yields()) state.heat.assign(size, 0.0);
    if (warms_by_compression()) state.compression_heat.assign(size, 0.0);
  }
  if (eos->needs_energy()) state.energy.assign(size, 0.0);
  return state;
}

void Material::update(MaterialTile& tile, Real dt) const {
  alignas(32) Real work[kTile];
  if (eos->needs_energy()) {
    alignas(32) Tensors before;
    copy_deviator(tile, before);
    strength->update(tile, dt);
    deviatoric_work(tile, before, work);
  } else {
    strength->update(tile, dt);
  }
  eos->update(tile, work);
  if (tensile_cutoff < kInfinity) cut_off(tile, tensile_cutoff);
  if (!tile.state->compression_heat.empty()) warm(tile);
}

void Material::warm(MaterialTile& tile) const {
  MaterialState& state = *tile.state;
  alignas(32) Real logarithm[kTile];
  eos->isentropic_warming(tile, tensile_cutoff, logarithm);
  const bool varies = specific_heat.varies();
  const Real capacity = varies ? 1.0 : density * specific_heat.at(0);  // [J/m^3/K reference]
  for (int i = 0; i < tile.count; i += kLanes) {
    const std::size_t at = tile.first + static_cast<std::size_t>(i);
    const Pack T = load(state.temperature.data() + at), viscous = load(tile.viscous_work + i);
    const Pack half = vexp(0.5 * load(logarithm + i));
    Pack warmed = (half * T + (1.0 / capacity) * viscous) * half;
    Pack heat = capacity * (warmed - T);
    for (std::size_t lane = 0; varies && lane < kLanes; ++lane) {
      Real middle = half[lane] * T[lane];
      if (viscous[lane] != 0) {
        middle =
            specific_heat.temperature(specific_heat.enthalpy(middle) + viscous[lane] / density);
      }
      warmed[lane] = middle * half[lane];
      heat[lane] =
          density * (specific_heat.enthalpy(warmed[lane]) - specific_heat.enthalpy(T[lane]));
    }
    Real* sum = state.compression_heat.data() + at;
    store(sum, load(sum) + heat);
    if (tile.adiabatic) store(state.temperature.data() + at, warmed);
  }
}

}  // namespace brunt
