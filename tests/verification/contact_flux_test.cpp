// Heat that passes a contact, by the pair's column.
// Slabs: L = 10 mm of k = 50 W/m/K each, h = 1e4 W/m^2/K between them and
// dT = 100 K across: at the steady state q = dT/(L/k + 1/h + L/k) = 100/5e-4 = 2.0e5 W/m^2. The
// contact is at 60 and 40 degC.
// Half-spaces: T = (e1 T1 + e2 T2)/(e1 + e2) at the contact, e = sqrt(k rho cp),
// and q = e1 (T1 - T)/sqrt(pi t): 22.70 MW/m^2 at 10 ms, 71.8 at 1 ms.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

const char* const kSlabs = R"(
time: {end: 3 s}
ambient: 0 degC
materials:
  slab:
    density: 1000 kg/m^3
    elastic: {E: 1 GPa, nu: 0.3}
    thermal: {cp: 100 J/kg/K, k: 50 W/m/K}
contact: {default: {heat: {conductance: 1e4 W/m^2/K}}}
output: {history: 10 ms}
boundaries:
  heated: {body: hot, where: {side: min-x}, temperature: 100 degC}
  cooled: {body: cold, where: {side: max-x}, temperature: 0 degC}
)";

// The slowest mode fades by alpha (pi/2)^2/L^2 at least, alpha = 5e-4 m^2/s: in 3 s by e^-37 =
// 1e-16 of dT. Temperatures are linear then, which elements have exactly, and so does a contact of
// faces that tile its area: 1e-12 is rounding. So is 1e-13 of what was stored, the page's, for the
// balance of all heat, in all rows.
void expect_slabs(const std::string& bodies, Real area) {
  const auto run = simulate_text(std::string(kSlabs) + bodies);
  ASSERT_EQ(run.failure, "");
  const Real rate = 2.0e5 * area;
  EXPECT_NEAR(run.last("contact.hot-cold.heat_rate"), -rate, 1e-12 * rate);
  EXPECT_NEAR(run.last("boundary.heated.heat_rate"), rate, 1e-12 * rate);
  EXPECT_NEAR(run.last("boundary.cooled.heat_rate"), -rate, 1e-12 * rate);
  EXPECT_NEAR(run.last("contact.hot-cold.temperature.max"), 273.15 + 60, 1e-10);
  EXPECT_NEAR(run.last("contact.hot-cold.temperature.mean"), 273.15 + 50, 1e-10);
  // By the mean of its temperatures, 80 and 20 degC, and by what came in through the boundaries.
  const Real capacity = 1000 * 100 * 0.01 * area;
  EXPECT_NEAR(run.last("body.hot.heat"), 80 * capacity, 1e-12 * 80 * capacity);
  EXPECT_NEAR(run.last("body.cold.heat"), 20 * capacity, 1e-12 * 80 * capacity);
  EXPECT_NEAR(run.last("heat.boundary"), run.last("heat.stored"), 1e-13 * run.last("heat.stored"));
  for (const Real drift : run.column("heat.drift")) ASSERT_LT(std::fabs(drift), 1e-13);
}

TEST(Slabs, CarryTheHeatOfTheirResistancesInThePlane) {
  expect_slabs(R"(
  hot_still: {body: hot, where: all, fix: [x, y]}
  cold_still: {body: cold, where: all, fix: [x, y]}
geometry: plane-strain
bodies:
  hot: {material: slab, shape: {box: {min: [-10 mm, 0], max: [0, 9 mm]}}, cells: [4, 3]}
  cold: {material: slab, shape: {box: {min: [0, 0], max: [10 mm, 9 mm]}}, cells: [5, 4]}
)",
               9e-3);
}

TEST(Slabs, CarryTheHeatOfTheirResistancesInSpace) {
  expect_slabs(R"(
  hot_still: {body: hot, where: all, fix: [x, y, z]}
  cold_still: {body: cold, where: all, fix: [x, y, z]}
bodies:
  hot: {material: slab, shape: {box: {min: [-10 mm, 0, 0], max: [0, 9 mm, 6 mm]}}, cells: [4, 3, 2]}
  cold: {material: slab, shape: {box: {min: [0, 0, 0], max: [10 mm, 9 mm, 6 mm]}}, cells: [5, 4, 3]}
)",
               54e-6);
}

/// Half-spaces of the shipped deck, four cells or particles across: what passed in the last step
/// before t against the integral of q over it.
void expect_flux(const std::vector<std::string>& methods, Real t, Real tolerance) {
  // The first cells' own error fades with h^2/(alpha t): of 0.1 mm it is 2.4 % at 1 ms and 0.2 % at
  // 10 ms. That of particles fades with h/sqrt(alpha t), as if the contact were 0.06 spacings
  // nearer: 1.7 % at 10 ms. Hence half the size at 1 ms, and of particles a quarter. The hotter
  // half is six times the depth sqrt(4 alpha t) long, and half a space to rounding.
  const bool late = t > 2e-3, particles = !methods.empty();
  const Real size = late ? 0.1e-3 : (particles ? 0.025e-3 : 0.05e-3);
  std::vector<std::string> overrides = methods;
  overrides.insert(overrides.end(), {"parameters.size=" + std::to_string(1e3 * size) + " mm",
                                     "parameters.width=" + std::to_string(4e3 * size) + " mm",
                                     late ? "parameters.length=12 mm" : "parameters.length=4 mm",
                                     "time.end=" + std::to_string(t), "measures=null"});
  const auto run = simulate_shipped("half-spaces", overrides);
  ASSERT_EQ(run.failure, "");
  const Real e1 = std::sqrt(237.0 * 2700 * 900), e2 = std::sqrt(44.5 * 7850 * 475);
  const Real between = (e1 * 500 + e2 * 20) / (e1 + e2), dt = run.last("dt");
  const Real heat = e1 * (500 - between) * 2 / std::sqrt(kPi) * (std::sqrt(t) - std::sqrt(t - dt));
  const Real rate = heat / dt * 16 * size * size;
  EXPECT_NEAR(run.last("contact.hot-cold.heat_rate"), -rate, tolerance * rate) << t;
  EXPECT_LT(std::fabs(run.last("heat.drift")), 1e-12);
}

TEST(HalfSpaces, HexesPassTheFluxBetween) {
  expect_flux({}, 10e-3, 0.01);
  expect_flux({}, 1e-3, 0.01);
}

TEST(ParticleHeat, ParticlesPassTheFluxBetweenHalfSpaces) {
  expect_flux({"bodies.hot.method=sph", "bodies.cold.method=sph"}, 10e-3, 0.02);
  expect_flux({"bodies.hot.method=sph", "bodies.cold.method=sph"}, 1e-3, 0.02);
}

TEST(ParticleHeat, ParticlesAndHexesPassTheFluxBetweenHalfSpaces) {
  for (const char* of_particles : {"bodies.hot.method=sph", "bodies.cold.method=sph"}) {
    expect_flux({of_particles}, 10e-3, 0.02);
    expect_flux({of_particles}, 1e-3, 0.02);
  }
}

}  // namespace
}  // namespace brunt::test
