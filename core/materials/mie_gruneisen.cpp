#include "core/materials/mie_gruneisen.hpp"

#include <utility>

#include "core/materials/compression_heat.hpp"

namespace brunt {

namespace {
constexpr Real kLargest = 0.95;  // of s eta, and of eta
}  // namespace

MieGruneisenEquation::MieGruneisenEquation(const MieGruneisen& law, Real density)
    : law_(law),
      bulk_(density * law.c0 * law.c0),
      densest_ratio_(1.0 - kLargest / vmax(law.s, 1.0)) {}

void MieGruneisenEquation::update(MaterialTile& tile, const Real* deviatoric_work) const {
  for (int i = 0; i < tile.count; i += kLanes) {
    const std::size_t at = tile.first + slot_of(i);
    Real* pressure = tile.state->pressure.data() + at;
    Real* energy = tile.state->energy.data() + at;
    const Pack ratio = load(tile.ratio + i), change = ratio - load(tile.ratio_old + i);
    const ColdPressure<Pack> cold = cold_pressure(ratio);
    const Pack known = load(energy) + load(deviatoric_work + i) + load(tile.viscous_work + i) -
                       (0.5 * load(pressure)) * change;
    const Pack e = (known - (0.5 * cold.pressure) * change) / (1.0 + (0.5 * law_.gamma0) * change);
    const Pack p = cold.pressure + law_.gamma0 * e;
    store(energy, e);
    store(pressure, p);
    // rho c^2 = rho (dp/drho)_e + (p/rho) (dp/de)_rho. In tension the second part is negative and
    // could swallow the first: there it counts as 0, on the safe side of the time step.
    const Pack thermal = law_.gamma0 * vmax(p, Pack{});
    const Pack held = vmax(ratio, broadcast<Pack>(densest_ratio_));
    store(tile.state->bulk.data() + at, held * (cold.slope + thermal));
  }
}

void MieGruneisenEquation::isentropic_heating(const MaterialTile& tile, Real cutoff,
                                              Real* logarithm) const {
  const Pack densest = broadcast<Pack>(densest_ratio_);
  for (int i = 0; i < tile.count; i += kLanes) {
    Pack before = vmax(load(tile.ratio_old + i), densest),
         now = vmax(load(tile.ratio + i), densest);
    if (cutoff < kInfinity) {
      // p = K (V0/V - 1) + gamma0 E = -cutoff
      const Pack energy = load(tile.state->energy.data() + tile.first + slot_of(i));
      const Pack compression = 1.0 - (1.0 / bulk_) * (cutoff + law_.gamma0 * energy);
      const auto opens = Pack{} < compression;
      const Pack loosest = vmax(1.0 / select(opens, compression, broadcast<Pack>(1.0)), densest);
      before = select(opens, vmin(before, loosest), before);
      now = select(opens, vmin(now, loosest), now);
    }
    store(logarithm + i, law_.gamma0 * (before - now));
  }
}

void MieGruneisenEquation::held_ratio(Real tension, const Real* ratio, const Real* energy,
                                      int count, Real* held) const {
  for (int i = 0; i < count; i += kLanes) {
    const Pack thermal = law_.gamma0 * load(energy + i);
    store(held + i, held_ratio_of(load(ratio + i), tension, [&](Pack at) {
            const ColdPressure<Pack> cold = cold_pressure(at);
            return std::pair{cold.pressure + thermal, cold.slope};
          }));
  }
}

}  // namespace brunt
// Tested by tests/unit/core/eos_test.cpp.
