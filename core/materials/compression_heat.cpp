/// What compression and viscosity do to the temperature of points: docs/theory/materials.md,
/// section 6.
#include "core/materials/compression_heat.hpp"

#include <algorithm>

#include "core/simd_math.hpp"

namespace brunt {
namespace {

bool any_damaged(const MaterialTile& tile) {
  const auto first = tile.state->damage.begin() + static_cast<std::ptrdiff_t>(tile.first);
  return std::any_of(first, first + tile.count, [](Real damage) { return damage > 0; });
}

/// Temperatures of four points, and the heat that they take up. Where the heat capacity varies with
/// temperature they follow from enthalpies, one after the other. Apart: lanes go through memory.
struct HeatedPack {
  Pack temperature = {};  ///< [K]
  Pack heat = {};         ///< [J/m^3] per reference volume

  /// half     [1] root of what compression does to temperatures
  /// viscous  [J/m^3] per reference volume
  __attribute__((noinline)) HeatedPack(const Material& material, Pack T, Pack half, Pack viscous) {
    const SpecificHeat& capacity = material.specific_heat;
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      Real middle = half[lane] * T[lane];
      if (viscous[lane] != 0) {
        middle = capacity.temperature(capacity.enthalpy(middle) + viscous[lane] / material.density);
      }
      temperature[lane] = middle * half[lane];
      heat[lane] =
          material.density * (capacity.enthalpy(temperature[lane]) - capacity.enthalpy(T[lane]));
    }
  }
};

}  // namespace

void Material::keep_before_heating(const MaterialTile& tile, BeforeHeating& before) const {
  const MaterialState& state = *tile.state;
  if (damage != nullptr) {
    before.energy = copied(state.energy.data() + tile.first, tile.count);
    before.damage = copied(state.damage.data() + tile.first, tile.count);
  }
  if (!strength->changes_volume()) return;
  for (int i = 0; i < tile.count; i += kLanes) {
    const std::size_t at = tile.first + slot_of(i);
    store(before.plastic.at + i,
          load(state.plastic_volume.data() + at) * load(state.opening.data() + at));
  }
}

/// (M48): V/V0 of what bears pressure, (1 - d) V_t + d V_0: the part that is intact, no further
/// open than the cut-off lets it, and the part that has failed, no further than without stress.
void Material::find_bearing_ratio(const Real* energy, const Real* lost, int count,
                                  Real* ratio) const {
  Row intact = copied(ratio, count), failed;
  if (tensile_cutoff < kInfinity) {
    eos->held_ratio(tensile_cutoff, ratio, energy, count, intact.at);
  }
  eos->held_ratio(0, ratio, energy, count, failed.at);
  for (int i = 0; i < count; i += kLanes) {
    const Pack d = load(lost + i);
    store(ratio + i, (1.0 - d) * load(intact.at + i) + d * load(failed.at + i));
  }
}

void Material::find_isentropic_heating(MaterialTile& tile, const BeforeHeating& before,
                                       Real* logarithm) const {
  const MaterialState& state = *tile.state;
  if (strength->changes_volume()) {
    const RatioRows given(tile);
    for (int i = 0; i < tile.count; i += kLanes) {
      const std::size_t at = tile.first + slot_of(i);
      const Pack plastic = load(state.plastic_volume.data() + at) * load(state.opening.data() + at);
      store(tile.ratio_old + i, load(tile.ratio_old + i) / load(before.plastic.at + i));
      store(tile.ratio + i, load(tile.ratio + i) / plastic);
    }
    eos->isentropic_heating(tile, kInfinity, logarithm);
    given.show(tile);
    return;
  }
  eos->isentropic_heating(tile, tensile_cutoff, logarithm);
  if (damage == nullptr || !any_damaged(tile)) return;
  const RatioRows given(tile);
  const Real *energy = state.energy.data() + tile.first, *lost = state.damage.data() + tile.first;
  find_bearing_ratio(before.energy.at, before.damage.at, tile.count, tile.ratio_old);
  find_bearing_ratio(energy, lost, tile.count, tile.ratio);
  Row bearing;
  eos->isentropic_heating(tile, kInfinity, bearing.at);
  given.show(tile);
  for (int i = 0; i < tile.count; i += kLanes) {
    const auto fails = load(lost + i) > 0.0;
    store(logarithm + i, select(fails, load(bearing.at + i), load(logarithm + i)));
  }
}

void Material::add_compression_heat(MaterialTile& tile, const BeforeHeating& before) const {
  MaterialState& state = *tile.state;
  alignas(32) Real logarithm[kTile];
  find_isentropic_heating(tile, before, logarithm);
  const bool varies = specific_heat.varies();
  const Real capacity = varies ? 1.0 : density * specific_heat.at(0);  // [J/m^3/K reference]
  for (int i = 0; i < tile.count; i += kLanes) {
    const std::size_t at = tile.first + slot_of(i);
    const Pack T = load(state.temperature.data() + at), viscous = load(tile.viscous_work + i);
    const Pack half = vexp(0.5 * load(logarithm + i));
    Pack heated = (half * T + (1.0 / capacity) * viscous) * half;
    Pack heat = capacity * (heated - T);
    if (varies) {
      const HeatedPack by_enthalpy(*this, T, half, viscous);
      heated = by_enthalpy.temperature, heat = by_enthalpy.heat;
    }
    Real* sum = state.compression_heat.data() + at;
    store(sum, load(sum) + heat);
    if (tile.adiabatic) store(state.temperature.data() + at, heated);
  }
}

}  // namespace brunt
// Tested by tests/unit/core/shock_heat_test.cpp.
