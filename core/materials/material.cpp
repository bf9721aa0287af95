#include "core/materials/material.hpp"

#include <algorithm>

#include "core/materials/compression_heat.hpp"
#include "core/materials/damage.hpp"
#include "core/materials/tile_rows.hpp"
#include "core/simd_math.hpp"

namespace brunt {

namespace {

/// Work of the deviator of a tile in this step [J/m^3 reference].
void find_deviatoric_work(const MaterialTile& tile, const DeviatorRows& before, Real* work) {
  for (int i = 0; i < tile.count; i += kLanes) store(work + i, deviatoric_work(tile, before, i));
}

/// Holds the pressure above minus the cut-off. The equation of state has booked the work of the
/// pressure before that; its energy gets the difference.
void cut_off(MaterialTile& tile, Real cutoff) {
  MaterialState& state = *tile.state;
  for (int i = 0; i < tile.count; i += kLanes) {
    const std::size_t at = tile.first + slot_of(i);
    const Pack p = load(state.pressure.data() + at);
    const Pack held = vmax(p, broadcast<Pack>(-cutoff));
    store(state.pressure.data() + at, held);
    if (state.energy.empty()) continue;
    const Pack change = load(tile.ratio + i) - load(tile.ratio_old + i);
    const Pack energy = load(state.energy.data() + at) - (0.5 * (held - p)) * change;
    store(state.energy.data() + at, energy);
  }
}

/// Sets `elastic` to volume ratios over the plastic volume and the opening of the state.
void divide_by_plastic(const MaterialTile& tile, const Row& whole, Real* elastic) {
  for (int i = 0; i < tile.count; i += kLanes) {
    const std::size_t at = tile.first + slot_of(i);
    const Pack plastic =
        load(tile.state->plastic_volume.data() + at) * load(tile.state->opening.data() + at);
    store(elastic + i, load(whole.at + i) / plastic);
  }
}

/// Adds the work of the pressure on what the volume has changed besides the elastic one [J/m^3].
/// elastic_old, whole_old, whole  volume ratios; the tile has the new elastic one
void add_plastic_volume_work(const MaterialTile& tile, const Row& elastic_old, const Row& whole_old,
                             const Row& whole, const Row& pressure_old, Real* work) {
  for (int i = 0; i < tile.count; i += kLanes) {
    const Real* pressure = tile.state->pressure.data() + tile.first + i;
    const Pack mean = 0.5 * (load(pressure_old.at + i) + load(pressure));
    const Pack change = load(whole.at + i) - load(whole_old.at + i);
    const Pack elastic = load(tile.ratio + i) - load(elastic_old.at + i);
    store(work + i, load(work + i) - mean * (change - elastic));
  }
}

/// The ratios of a tile become those over the volume free of stress, before the step and at the
/// temperatures that the points have now, which the state keeps. Returns by how much that volume
/// grows in the step.
/// alpha [1/K] linear expansion; tile.fixed_temperature is that of time 0 where the state has none
Row divide_by_expansion(MaterialTile& tile, Real alpha) {
  MaterialState& state = *tile.state;
  Row grown;
  const bool varies = !state.start_temperature.empty();
  for (int i = 0; i < tile.count; i += kLanes) {
    const std::size_t at = tile.first + slot_of(i);
    const Pack start = varies ? load(state.start_temperature.data() + at)
                              : broadcast<Pack>(tile.fixed_temperature);
    const Pack stretch = 1.0 + alpha * (load(state.temperature.data() + at) - start);
    const Pack before = load(state.expansion.data() + at), now = stretch * stretch * stretch;
    store(tile.ratio_old + i, load(tile.ratio_old + i) / before);
    store(tile.ratio + i, load(tile.ratio + i) / now);
    store(grown.at + i, now - before);
    store(state.expansion.data() + at, now);
  }
  return grown;
}

/// Books p J_e d(theta), means of the step; the tile has J_e.
void add_expansion_work(const MaterialTile& tile, const Row& pressure_old, const Row& grown) {
  MaterialState& state = *tile.state;
  for (int i = 0; i < tile.count; i += kLanes) {
    const std::size_t at = tile.first + slot_of(i);
    const Pack pressure = 0.5 * (load(pressure_old.at + i) + load(state.pressure.data() + at));
    const Pack elastic = 0.5 * (load(tile.ratio_old + i) + load(tile.ratio + i));
    const Pack work = pressure * elastic * load(grown.at + i);
    store(state.expansion_work.data() + at, load(state.expansion_work.data() + at) + work);
  }
}

}  // namespace

MaterialState Material::initial_state(std::size_t n, Real temperature, bool adiabatic) const {
  const std::size_t size = (n + kTile - 1) / kTile * kTile;
  MaterialState state;
  for (auto& component : state.deviator) component.assign(size, 0.0);
  state.pressure.assign(size, eos->initial_pressure());
  state.bulk.assign(size, eos->bulk_modulus());
  if (yields()) {
    state.eps_p.assign(size, 0.0);
    state.strain_rate.assign(size, 0.0);
  }
  if (adiabatic && thermal) {
    state.temperature.assign(size, temperature);
    if (yields()) state.heat.assign(size, 0.0);
    if (heats_by_compression()) state.compression_heat.assign(size, 0.0);
    if (expansion != 0) {
      state.expansion.assign(size, 1.0);
      state.expansion_work.assign(size, 0.0);
    }
  }
  if (eos->needs_energy()) state.energy.assign(size, eos->initial_energy());
  if (strength->changes_volume()) {
    state.plastic_volume.assign(size, 1.0);
    state.opening.assign(size, 1.0);
  }
  if (damage != nullptr) {
    state.damage_index.assign(size, 0.0);
    state.damage.assign(size, 0.0);
    if (damage->regularised()) {
      state.softening_work.assign(size, 0.0);
      state.softening_limit.assign(size, 0.0);
      state.softening_energy.assign(size, 0.0);
      state.length.assign(size, 1.0);
    }
  }
  strength->add_fields(state, size);
  return state;
}

void Material::update(MaterialTile& tile, Real dt) const {
  if (tile.state->expansion.empty()) return update_unexpanded(tile, dt);
  const RatioRows given(tile);
  const Row pressure_old = copied(tile.state->pressure.data() + tile.first, tile.count);
  const Row grown = divide_by_expansion(tile, expansion);
  update_unexpanded(tile, dt);
  add_expansion_work(tile, pressure_old, grown);
  given.show(tile);
}

void Material::update_unexpanded(MaterialTile& tile, Real dt) const {
  BeforeHeating before_heating;
  if (!tile.state->compression_heat.empty()) keep_before_heating(tile, before_heating);
  if (damage == nullptr) {
    find_stress(tile, dt, nullptr);
  } else {
    BeforeDamage before;
    damage->begin(tile, before);
    find_stress(tile, dt, &before);
    damage->end(tile, before);
  }
  if (!tile.state->compression_heat.empty()) add_compression_heat(tile, before_heating);
}

void Material::find_stress(MaterialTile& tile, Real dt, const BeforeDamage* before) const {
  if (strength->sees_pressure()) {
    find_stress_after_pressure(tile, dt, before);
    return;
  }
  alignas(32) Real work[kTile];
  if (eos->needs_energy()) {
    const DeviatorRows deviator = copied_deviator(tile);
    strength->update(tile, dt);
    find_deviatoric_work(tile, deviator, work);
  } else {
    strength->update(tile, dt);
  }
  if (before != nullptr) damage->scale_heat(tile, *before);
  eos->update(tile, work);
  if (tensile_cutoff < kInfinity) cut_off(tile, tensile_cutoff);
}

void Material::find_stress_after_pressure(MaterialTile& tile, Real dt,
                                          const BeforeDamage* before_damage) const {
  if (strength->gives_pressure()) {
    strength->update(tile, dt);
    return;
  }
  const RatioRows given(tile);
  MaterialState& state = *tile.state;
  const bool energetic = eos->needs_energy(), plastic = strength->changes_volume();
  Real* const pressure = state.pressure.data() + tile.first;
  const Row whole_old = copied(tile.ratio_old, tile.count), whole = copied(tile.ratio, tile.count);
  DeviatorRows before;
  Row work, pressure_old = copied(pressure, tile.count), energy_old, elastic_old;
  if (energetic) {
    energy_old = copied(state.energy.data() + tile.first, tile.count);
    before = copied_deviator(tile);
    find_deviatoric_work(tile, before, work.at);  // of the old deviator, for the time being
  }
  if (plastic) {
    divide_by_plastic(tile, whole_old, tile.ratio_old);
    divide_by_plastic(tile, whole, tile.ratio);
    elastic_old = copied(tile.ratio_old, tile.count);
  }
  eos->update(tile, work.at);
  if (!plastic && tensile_cutoff < kInfinity) cut_off(tile, tensile_cutoff);
  given.show(tile);
  strength->update(tile, dt);
  if (before_damage != nullptr) damage->scale_heat(tile, *before_damage);
  if (!plastic && !energetic) return;  // the state has its pressure
  if (energetic) find_deviatoric_work(tile, before, work.at);
  const Row of_deviator = work;
  if (plastic) {
    std::copy_n(elastic_old.at, tile.count, tile.ratio_old);
    divide_by_plastic(tile, whole, tile.ratio);
  }
  // The work on the plastic volume needs the new pressure, which the strength has to first order
  // only: once more.
  for (int pass = 0; pass < (plastic && energetic ? 2 : 1); ++pass) {
    if (energetic && plastic) {
      work = of_deviator;
      add_plastic_volume_work(tile, elastic_old, whole_old, whole, pressure_old, work.at);
    }
    if (energetic) std::copy_n(energy_old.at, tile.count, state.energy.data() + tile.first);
    std::copy_n(pressure_old.at, tile.count, pressure);
    eos->update(tile, work.at);
  }
  if (tensile_cutoff < kInfinity) cut_off(tile, tensile_cutoff);
  given.show(tile);
}

}  // namespace brunt
