/// Nanoseconds a point and step of the material update: elastic, J2, Johnson-Cook where all points
/// yield and where none does, with the linear and the shock equation of state.
#include <benchmark/benchmark.h>

#include "core/materials/catalog.hpp"

namespace {

using namespace brunt;

constexpr std::size_t kPoints = 4096;

StrengthLaw copper() {
  JohnsonCook law;
  law.A = 90e6, law.B = 292e6, law.n = 0.31, law.C = 0.025;
  law.m = 1.09, law.T_melt = 1356, law.T_ref = 298;
  return law;
}
StrengthLaw steel() {
  J2 law;
  law.yield = 400e6;
  Varying hardening;
  hardening.constant = 1e9;
  law.hardening = hardening;
  return law;
}

Material material(const StrengthLaw& strength, const EosLaw& eos) {
  Material made;
  made.density = 8960, made.shear = 46e9, made.bulk = 139e9;
  made.thermal = true, made.specific_heat = SpecificHeat(383);
  made.strength =
      make_strength(strength, {made.shear, made.density * made.specific_heat.at(298), 0.9});
  made.eos = make_eos(eos, {made.density, made.bulk});
  return made;
}

/// Shears all points to and fro at 1e4/s; strain: of one step, so that none or all yield.
void run(benchmark::State& bench, const StrengthLaw& strength, const EosLaw& eos, Real strain) {
  const Material made = material(strength, eos);
  MaterialState state = made.initial_state(kPoints, 298, true);
  constexpr Real dt = 2e-8;
  MaterialTile tile;
  tile.state = &state;
  tile.count = kTile;
  tile.adiabatic = true;
  std::fill_n(tile.ratio_old, kTile, 1.0);
  std::fill_n(tile.ratio, kTile, 1.0);
  std::fill_n(tile.viscous_work, kTile, 0.0);
  int step = 0;
  for (auto _ : bench) {
    const Real sign = step++ / 50 % 2 == 0 ? 1 : -1;
    for (std::size_t first = 0; first < kPoints; first += kTile) {
      for (auto& component : tile.strain) std::fill_n(component, kTile, 0.0);
      for (int i = 0; i < kTile; ++i) tile.strain[xy][i] = sign * strain * (1.0 + 0.01 * i);
      tile.first = first;
      made.update(tile, dt);
    }
    if (step % 1000 == 0) {  // before heat has melted all
      bench.PauseTiming();
      state = made.initial_state(kPoints, 298, true);
      bench.ResumeTiming();
    }
  }
  bench.SetItemsProcessed(static_cast<std::int64_t>(bench.iterations() * kPoints));
  bench.counters["s/point"] = benchmark::Counter(
      kPoints, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

constexpr Real kElastic = 1e-8, kPlastic = 2e-4;
const MieGruneisen kShock{3940, 1.489, 1.96};

BENCHMARK_CAPTURE(run, elastic, StrengthLaw{NoStrength{}}, EosLaw{LinearEos{}}, kPlastic);
BENCHMARK_CAPTURE(run, elastic_shock, StrengthLaw{NoStrength{}}, EosLaw{kShock}, kPlastic);
BENCHMARK_CAPTURE(run, j2_elastic, steel(), EosLaw{LinearEos{}}, kElastic);
BENCHMARK_CAPTURE(run, j2_plastic, steel(), EosLaw{LinearEos{}}, kPlastic);
BENCHMARK_CAPTURE(run, johnson_cook_elastic, copper(), EosLaw{LinearEos{}}, kElastic);
BENCHMARK_CAPTURE(run, johnson_cook_plastic, copper(), EosLaw{LinearEos{}}, kPlastic);
BENCHMARK_CAPTURE(run, johnson_cook_shock, copper(), EosLaw{kShock}, kPlastic);

}  // namespace

BENCHMARK_MAIN();
