// Heat conduction against closed forms (Carslaw & Jaeger 1959), in
// finite elements and particles. Steel: k = 44.5 W/m/K, rho = 7850 kg/m^3, cp = 475 J/kg/K,
// alpha = k/(rho cp) = 11.93 mm^2/s.
//   Half space whose surface is brought to T0 + 100 K:  T = T0 + 100 erfc(x/(2 sqrt(alpha t)))
//   Tube, inner and outer surface held, steady:  T = T1 + (T2 - T1) ln(r/r1)/ln(r2/r1)
//   Rod, one end held, the other in a fluid, steady:  q = (T1 - Tf)/(L/k + 1/h)
//   Small hot body that radiates into the cold:  T^-3 = T0^-3 + 3 e sigma A t/C
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

constexpr Real kConductivity = 44.5, kDensity = 7850, kCapacity = 475;
constexpr Real kDiffusivity = kConductivity / (kDensity * kCapacity);

std::string steel() {
  return "materials: {steel: {density: 7850, elastic: {E: 200 GPa, nu: 0.3}, "
         "thermal: {cp: 475 J/kg/K, k: 44.5 W/m/K}}}\n";
}

/// Calls f(place, temperature) for each point of a body at the end.
template <class F>
void for_points(const Simulation& run, const std::string& body, F f) {
  const BodyView& view = run.bodies.at(body);
  for (const auto& field : view.point_fields) {
    if (field.name != "temperature") continue;
    for (std::size_t i = 0; i < field.values.size(); ++i) {
      f(Vec3(view.position[3 * i], view.position[3 * i + 1], view.position[3 * i + 2]),
        field.values[i]);
    }
  }
}

/// Heat is lost nowhere: what bodies store came through boundaries, to rounding.
void expect_balance(const Simulation& run) {
  ASSERT_EQ(run.failure, "");
  for (const Real drift : run.column("heat.drift")) EXPECT_LT(std::fabs(drift), 1e-12);
}

struct Rod {
  const char* geometry;
  const char* method;
  const char* shape;
  Real tolerance;  ///< [K] of a step of 100 K
};
void PrintTo(const Rod& rod, std::ostream* out) { *out << rod.geometry << ' ' << rod.method; }

class HalfSpace : public testing::TestWithParam<Rod> {};

// Elements of 1 mm err by h^2/(12 (2 sqrt(alpha t))^2) of the step, here 2e-4; particles by the
// layer at the surface, where half of the neighbours are missing: some hundredths of a spacing.
TEST_P(HalfSpace, FollowsTheErrorFunction) {
  const Rod& rod = GetParam();
  const bool flat = rod.geometry != std::string("3d");
  const std::string text =
      std::string("geometry: ") + rod.geometry +
      "\ntime: {end: 8 s}\ncontact: {default: {ignore: true}}\n" + steel() +
      "bodies: {rod: {method: " + rod.method +
      (rod.method == std::string("sph") ? ", smoothing: 1.2" : "") +
      ", material: steel, size: 1 mm, temperature: 300 K, shape: {" + rod.shape +
      "}}}\nboundaries:\n  still: {body: rod, where: all, fix: " + (flat ? "[x, y]" : "[x, y, z]") +
      "}\n  hot: {body: rod, where: {side: " +
      (rod.geometry == std::string("axisymmetric") ? "min-y" : "min-x") +
      "}, temperature: 400 K}\noutput: {history: 1 s}\n";
  const auto run = simulate_text(text);
  expect_balance(run);
  EXPECT_LT(run.steps, 500);  // the step is that of heat, not that of sound
  Real worst = 0;
  for_points(run, "rod", [&](const Vec3& at, Real T) {
    const Real depth = rod.geometry == std::string("axisymmetric") ? at[1] : at[0];
    const Real exact = 300 + 100 * std::erfc(depth / (2 * std::sqrt(kDiffusivity * 8)));
    worst = std::max(worst, std::fabs(T - exact));
    EXPECT_GE(T, 300 - 1e-9);  // no new extremes
    EXPECT_LE(T, 400 + 1e-9);
  });
  EXPECT_GT(worst, 0);
  EXPECT_LT(worst, rod.tolerance);
  testing::Test::RecordProperty("worst_K", std::to_string(worst));
  std::printf("%s %s: worst error %.3f K of 100 K\n", rod.geometry, rod.method, worst);
}

INSTANTIATE_TEST_SUITE_P(
    Conduction, HalfSpace,
    testing::Values(
        Rod{"3d", "fe", "box: {min: [0, 0, 0], max: [50 mm, 3 mm, 3 mm]}", 0.1},
        Rod{"plane-strain", "fe", "box: {min: [0, 0], max: [50 mm, 3 mm]}", 0.1},
        Rod{"axisymmetric", "fe", "cylinder: {radius: 4 mm, length: 50 mm, base: [0, 0]}", 0.1},
        Rod{"3d", "sph", "box: {min: [-0.5 mm, 0, 0], max: [49.5 mm, 6 mm, 6 mm]}", 2},
        Rod{"plane-strain", "sph", "box: {min: [-0.5 mm, 0], max: [49.5 mm, 6 mm]}", 2}),
    [](const auto& info) {
      std::string name = std::string(info.param.geometry) + "_" + info.param.method;
      for (auto& c : name) c = c == '-' ? '_' : c;
      return name;
    });

TEST(Conduction, SteadyTubeHasALogarithmicProfile) {
  const std::string text =
      "geometry: axisymmetric\ntime: {end: 60 s}\n" + steel() +
      "bodies: {tube: {material: steel, size: 1 mm, temperature: 300 K, shape: "
      "{tube: {inner: 10 mm, outer: 30 mm, length: 4 mm, base: [0, 0]}}}}\n"
      "boundaries:\n"
      "  still: {body: tube, where: all, fix: [x, y]}\n"
      "  hot: {body: tube, where: {side: min-x}, temperature: 400 K}\n"
      "  cold: {body: tube, where: {side: max-x}, temperature: 300 K}\n"
      "output: {history: 1 s}\n";
  const auto run = simulate_text(text);
  expect_balance(run);
  // Elements of h = 1 mm at r = 10 mm: (h/r)^2/12 = 8e-4 of the gradient there.
  for_points(run, "tube", [](const Vec3& at, Real T) {
    EXPECT_NEAR(T, 400 - 100 * std::log(at[0] / 0.01) / std::log(3.0), 0.1);
  });
  const Real rate = 2 * kPi * kConductivity * 0.004 * 100 / std::log(3.0);
  EXPECT_NEAR(run.last("boundary.hot.heat_rate"), rate, 1e-3 * rate);
  EXPECT_NEAR(run.last("boundary.cold.heat_rate"), -rate, 1e-3 * rate);
}

// q = 100/(0.02/44.5 + 1/2000) = 105 325 W/m^2; the far end is q/h = 52.66 K warmer than the fluid.
TEST(Conduction, RodBetweenAHeldEndAndAFluid) {
  const Real q = 100 / (0.02 / kConductivity + 1.0 / 2000);
  for (const bool sph : {false, true}) {
    // The held particles are those at x = 0; the surface in the fluid is half a spacing outside of
    // the last ones.
    const std::string shape =
        sph ? "[-0.5 mm, 0, 0], max: [20 mm, 6 mm, 6 mm]" : "[0, 0, 0], max: [20 mm, 4 mm, 4 mm]";
    const auto run = simulate_text(
        "geometry: 3d\ntime: {end: 150 s}\n" + steel() +
        "bodies: {rod: {method: " + (sph ? "sph, smoothing: 1.2" : "fe") +
        ", material: steel, size: 1 mm, temperature: 300 K, shape: {box: {min: " + shape +
        "}}}}\nboundaries:\n  still: {body: rod, where: all, fix: [x, y, z]}\n"
        "  hot: {body: rod, where: {side: min-x}, temperature: 400 K}\n"
        "  fluid: {body: rod, where: {side: max-x}, convection: {h: 2000 W/m^2/K, T: 300 K}}\n"
        "output: {history: 10 s}\n");
    expect_balance(run);
    const Real area = sph ? 36e-6 : 16e-6;
    const Real tolerance = sph ? 0.02 : 1e-4;  // particles: 2 %, from the layers at the surfaces
    EXPECT_NEAR(run.last("boundary.hot.heat_rate"), q * area, tolerance * q * area) << sph;
    EXPECT_NEAR(run.last("boundary.fluid.heat_rate"), -q * area, tolerance * q * area) << sph;
  }
}

TEST(Conduction, FluxAndRadiationOfASmallBody) {
  const auto cube = [](const std::string& boundary) {
    return "geometry: 3d\ntime: {end: 20 s, max_step: 10 ms}\n" + steel() +
           "bodies: {cube: {material: steel, size: 1 mm, temperature: 1000 K, shape: {box: "
           "{min: [0, 0, 0], max: [2 mm, 2 mm, 2 mm]}}}}\nboundaries:\n"
           "  still: {body: cube, where: all, fix: [x, y, z]}\n" +
           boundary + "output: {history: 1 s}\n";
  };
  const Real capacity = kDensity * kCapacity * 8e-9;
  const auto flux = simulate_text(cube("  sun: {body: cube, where: {side: max-z}, flux: 1e4}\n"));
  expect_balance(flux);
  EXPECT_NEAR(flux.last("heat.stored"), 1e4 * 4e-6 * 20, 1e-11);
  EXPECT_NEAR(flux.last("body.cube.heat"), 1e4 * 4e-6 * 20, 1e-11);
  const auto glow = simulate_text(
      cube("  sky: {body: cube, where: surface, radiation: {emissivity: 1, T: 0}}\n"));
  expect_balance(glow);
  const Real sink = 3 * 5.670374419e-8 * 24e-6 * 20 / capacity;
  const Real exact = std::pow(1e-9 + sink, -1.0 / 3);
  // Biot number 4 sigma T^3 L/k = 5e-3 L/L: the body is uniform within 2 K; Euler's error is dt/20
  // s.
  for_points(glow, "cube", [&](const Vec3&, Real T) { EXPECT_NEAR(T, exact, 1.5); });
}

// A block of one temperature under uniform strain: its nodes get the plastic heat of elements by
// their shares of the capacity, so that they are as hot as elements are where heat stays.
TEST(Conduction, PlasticHeatGoesToNodesOnce) {
  for (const char* geometry : {"3d", "plane-strain", "axisymmetric"}) {
    const bool flat = geometry != std::string("3d");
    const auto block = [&](const std::string& heat) {
      return std::string("geometry: ") + geometry + "\nheat: " + heat +
             "\ntime: {end: 20 us}\ncontact: {default: {ignore: true}}\nmaterials: {copper: "
             "{density: 8960, elastic: {E: 124 GPa, nu: 0.34}, strength: {johnson-cook: {A: 90 "
             "MPa, B: 292 MPa, n: 0.31, C: 0.025, m: 1.09, T_melt: 1356 K}}, thermal: {cp: 383, "
             "k: 0}}}\nbodies: {block: {material: copper, size: 1 mm, temperature: 300 K, shape: "
             "{box: {min: " +
             (flat ? "[0, 0], max: [4 mm, 4 mm]" : "[0, 0, 0], max: [3 mm, 3 mm, 3 mm]") +
             "}}}}\nboundaries: {all: {body: block, where: all, velocity: " +
             (flat ? "[\"= 5e3*x\", \"= -1e4*y\"]" : "[\"= 5e3*x\", \"= 5e3*y\", \"= -1e4*z\"]") +
             "}}\noutput: {history: 1 us}\n";
    };
    const auto stays = simulate_text(block("adiabatic")), flows = simulate_text(block("conduct"));
    expect_balance(flows);
    const BodyView& cold = stays.bodies.at("block");
    for (const auto& field : cold.cell_fields) {
      if (field.name != "temperature") continue;
      EXPECT_GT(field.values.front(), 310);
      for_points(flows, "block", [&](const Vec3&, Real T) {
        EXPECT_NEAR(T, field.values.front(), 1e-8 * (T - 300)) << geometry;
      });
    }
    const Real heat = stays.last("energy.plastic_heat");
    EXPECT_NEAR(flows.last("energy.plastic_heat"), heat, 1e-9 * heat);
    EXPECT_NEAR(flows.last("heat.stored"), heat, 1e-9 * heat);
    EXPECT_NEAR(flows.last("body.block.heat"), heat, 1e-9 * heat);
    EXPECT_NEAR(stays.last("body.block.heat"), heat, 1e-9 * heat);
  }
}

// Bars at 190 m/s that conduct: heat is what plastic work and the shock gave, and the
// energy closes as before.
TEST(Conduction, TaylorBarsKeepTheirHeat) {
  struct Bar {
    const char* name;
    std::vector<std::string> overrides;
  };
  const std::string thermal = "materials.copper.thermal={cp: 383 J/kg/K, k: 386 W/m/K}";
  for (const auto& [name, shorter] :
       {Bar{"taylor-bar", {thermal, "parameters.size=0.9 mm", "time.end=8 us"}},
        Bar{"taylor-bar-sph", {thermal, "parameters.spacing=0.8 mm", "time.end=8 us"}}}) {
    auto with = shorter;
    with.push_back("heat=conduct");
    const auto flows = simulate_shipped(name, with), stays = simulate_shipped(name, shorter);
    expect_balance(flows);
    EXPECT_LT(flows.worst_drift, 0.01);
    const Real heat = stays.last("energy.plastic_heat");
    EXPECT_GT(heat, 0);
    // In 8 us heat moves sqrt(alpha t) = 30 um: what differs is nodes against points, under 1 %.
    const Real compression = flows.last("heat.compression");  // of the shock, and what opens again
    EXPECT_NEAR(flows.last("heat.stored") - compression, heat, 0.01 * heat) << name;
    EXPECT_NEAR(flows.last("heat.plastic"), heat, 0.01 * heat) << name;
  }
}

}  // namespace
}  // namespace brunt::test
