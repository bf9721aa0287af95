// Cost of a particle-step: corrected gradients, viscosity, artificial stress, Johnson-Cook copper
// in plastic flow, lists rebuilt as they must. Items are particle-steps.
#include <benchmark/benchmark.h>
#include <omp.h>

#include <cmath>

#include "../unit/sph/sample.hpp"

namespace brunt {
namespace {

/// A cube of n^3 that is hit on one face: a mix of elastic and plastic, tension and compression.
void particle_step(benchmark::State& bench) {
  omp_set_num_threads(static_cast<int>(bench.range(1)));
  const auto n = static_cast<int>(bench.range(0));
  constexpr Real dp = 1e-3;
  const auto material = test::copper();
  auto points = test::lattice<3>({n, n, n}, dp, 8960 * dp * dp * dp, 0.1);
  for (std::size_t i = 0; i < points.x.size(); ++i) {
    points.v[i] = Vec3(100 * std::sin(points.x[i][1] / (3 * dp)),
                       100 * std::cos(points.x[i][2] / (4 * dp)), 200 - 4e4 * points.x[i][2] / n);
  }
  SphOptions options;
  options.smoothing = 1.22;  // 60 neighbours a particle, as the stored positions are perturbed
  auto solid = test::particles<3>(std::move(points), dp, *material, options);
  for (int k = 0; k < 10; ++k) test::step<3>(*solid, 0.9 * solid->stable_step().step);
  const auto searches = solid->n_searches();
  for (auto _ : bench) test::step<3>(*solid, 0.9 * solid->stable_step().step);
  const auto count = static_cast<std::int64_t>(solid->n_particles());
  bench.SetItemsProcessed(bench.iterations() * count);
  bench.counters["ns_per_particle"] =
      benchmark::Counter(static_cast<double>(bench.iterations() * count) * 1e-9,
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  bench.counters["steps_per_search"] =
      static_cast<double>(bench.iterations()) /
      static_cast<double>(std::max<std::int64_t>(1, solid->n_searches() - searches));
}
BENCHMARK(particle_step)->Args({32, 1})->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace brunt
