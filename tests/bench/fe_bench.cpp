/// Cost of the element kernels, ns an element-step, nodes included: forces on 24^3 hexahedra or
/// 120^2 quadrilaterals moving by hand, elastic or flowing plastically (Johnson-Cook).
#include <benchmark/benchmark.h>

#include <cmath>
#include <numeric>

#include "core/materials/catalog.hpp"
#include "fe/finite_elements.hpp"

namespace brunt {
namespace {

Material copper(bool plastic) {
  Material material;
  material.name = "copper";
  material.density = 8960;
  material.shear = 46e9;
  material.bulk = 129e9;
  material.thermal = true;
  material.specific_heat = SpecificHeat(383);
  JohnsonCook law;
  law.A = 90e6, law.B = 292e6, law.n = 0.31, law.C = 0.025, law.m = 1.09;
  law.T_melt = 1356;
  const StrengthInputs inputs{material.shear, 8960.0 * 383, 0.9};
  material.strength = plastic ? make_strength(law, inputs) : make_strength(NoStrength{}, inputs);
  material.eos = make_eos(LinearEos{}, {material.density, material.bulk});
  return material;
}

template <int Dim>
std::unique_ptr<FiniteElements<Dim>> block(const Material& material, Integration integration,
                                           Geometry geometry) {
  const int n = Dim == 3 ? 24 : 120, layers = Dim == 3 ? n : 0;
  const auto index = [n](int i, int j, int k) { return (k * (n + 1) + j) * (n + 1) + i; };
  Points<Dim> points;
  points.resize((n + 1) * (n + 1) * (layers + 1));
  ElementSet<Dim> set;
  set.material = &material;
  set.options.integration = integration;
  set.adiabatic = true;
  constexpr int kCube[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                               {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  for (int k = 0; k <= layers; ++k) {
    for (int j = 0; j <= n; ++j) {
      for (int i = 0; i <= n; ++i) {
        const int at[3] = {i, j, k};
        for (int c = 0; c < Dim; ++c) points.x[index(i, j, k)][c] = 1e-3 * at[c];
        if (i == n || j == n || (Dim == 3 && k == n)) continue;
        std::array<LocalIndex, Shape<Dim>::kCorners> corners;
        for (int I = 0; I < Shape<Dim>::kCorners; ++I) {
          corners[I] = index(i + kCube[I][0], j + kCube[I][1], k + kCube[I][2]);
        }
        set.corners.push_back(corners);
      }
    }
  }
  set.id.resize(set.corners.size());
  std::iota(set.id.begin(), set.id.end(), GlobalId{0});
  set.body.assign(set.id.size(), 0);
  set.piece.assign(set.id.size(), 0);
  return std::make_unique<FiniteElements<Dim>>(std::move(points), std::vector{set}, geometry, 1.0);
}

/// Shear and stretch to and fro: every step strains by 1e-3 (plastic) or 1e-7 (elastic).
template <int Dim, Integration kIntegration, bool kPlastic>
void element_step(benchmark::State& state) {
  const Material material = copper(kPlastic);
  const Geometry geometry = Dim == 3 ? Geometry::three_d : Geometry::axisymmetric;
  auto body = block<Dim>(material, kIntegration, geometry);
  Points<Dim>& points = body->points();
  const Real dt = 1e-7, rate = kPlastic ? 1e4 : 1;
  int count = 0;
  for (auto _ : state) {
    const Real sign = count++ / 20 % 2 == 0 ? 1 : -1;
    for (LocalIndex k = 0; k < points.size(); ++k) {
      points.v[k] = (sign * rate) * points.x_start[k];
      points.v[k][0] += 0.5 * sign * rate * points.x_start[k][1];
      points.x[k] += dt * points.v[k];
      points.f[k].setZero();
    }
    body->add_internal_forces(dt);
    benchmark::DoNotOptimize(body->stable_step());
  }
  state.counters["ns_per_element_step"] = benchmark::Counter(
      static_cast<double>(body->n_elements()) * 1e-9,
      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

BENCHMARK_TEMPLATE(element_step, 3, Integration::one_point, false);
BENCHMARK_TEMPLATE(element_step, 3, Integration::one_point, true);
BENCHMARK_TEMPLATE(element_step, 3, Integration::q1p0, false);
BENCHMARK_TEMPLATE(element_step, 3, Integration::q1p0, true);
BENCHMARK_TEMPLATE(element_step, 2, Integration::one_point, false);
BENCHMARK_TEMPLATE(element_step, 2, Integration::one_point, true);
BENCHMARK_TEMPLATE(element_step, 2, Integration::q1p0, false);
BENCHMARK_TEMPLATE(element_step, 2, Integration::q1p0, true);

}  // namespace
}  // namespace brunt

BENCHMARK_MAIN();
