// Gas that meets gas, in units of 1 kg/m^3, 1 m/s, 1 m.
//   Sod 1978: gamma = 1.4; rho, p = 1, 1 on the left, 0.125, 0.1 on the right. Between rarefaction
// and shock p = 0.30313, u = 0.92745, rho = 0.42632 and 0.26557 (Toro 2009, ch. 4). 2 %, the gate:
// left of the contact the first cells are too hot for good.
//   Noh 1987: cold gas of gamma = 5/3 flies at a wall, or its axis, with u = 1: the shock goes out
// at 1/3, and behind it rho is 4, or 16 about the axis. 3 and 5 %, between a quarter and nine
// tenths of what the shock has passed: the cells that it began in are too hot and too thin.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

TEST(Gas, InSodsTubeHasThePlateausOfRiemann) {
  const auto run = simulate_text(R"(
title: Sod's tube
geometry: plane-strain
time: {end: 0.2 s}
materials:
  left: {density: 1 kg/m^3, eos: {ideal-gas: {gamma: 1.4, pressure: 1 Pa}}}
  right: {density: 0.125 kg/m^3, eos: {ideal-gas: {gamma: 1.4, pressure: 0.1 Pa}}}
bodies:
  left: {material: left, shape: {box: {min: [-0.5, 0], max: [0, 0.005]}}, cells: [200, 2]}
  right: {material: right, shape: {box: {min: [0, 0], max: [0.5, 0.005]}}, cells: [200, 2]}
boundaries:
  left: {body: left, where: all, fix: [y]}
  right: {body: right, where: all, fix: [y]}
  one_end: {body: left, where: {side: min-x}, fix: [x]}
  other_end: {body: right, where: {side: max-x}, fix: [x]}
contact: {default: {tied: true}}
measures:
  p_left: {point: {body: left, at: [-0.03, 0.0025], field: pressure}}
  p_right: {point: {body: right, at: [0.09, 0.0025], field: pressure}}
  rho_left: {point: {body: left, at: [-0.03, 0.0025], field: density}}
  rho_right: {point: {body: right, at: [0.09, 0.0025], field: density}}
  u: {point: {body: right, at: [0.09, 0.0025], field: velocity.x}}
output: {history: 0.02}
)");
  ASSERT_EQ(run.failure, "");
  EXPECT_NEAR(run.measures.at("p_left"), 0.30313, 0.02 * 0.30313);
  EXPECT_NEAR(run.measures.at("p_right"), 0.30313, 0.02 * 0.30313);
  EXPECT_NEAR(run.measures.at("rho_left"), 0.42632, 0.02 * 0.42632);
  EXPECT_NEAR(run.measures.at("rho_right"), 0.26557, 0.02 * 0.26557);
  EXPECT_NEAR(run.measures.at("u"), 0.92745, 0.02 * 0.92745);
  EXPECT_LT(run.worst_drift, 1e-12);
}

/// Mean density by volume of what stands between 0.25 and 0.9 of the shock's place t/3.
Real density_behind(const Simulation& run, bool about_axis) {
  const auto& view = run.bodies.at("gas");
  const auto& density = field_named(view.cell_fields, "density")->values;
  Real sum = 0, volume = 0;
  for (std::size_t e = 0; e < density.size(); ++e) {
    Real low = kInfinity, high = -kInfinity;
    for (std::size_t c = 0; c < 4; ++c) {
      const Real x = view.position[3 * static_cast<std::size_t>(view.connectivity[4 * e + c])];
      low = std::min(low, x), high = std::max(high, x);
    }
    const Real x = 0.5 * (low + high), weight = (about_axis ? x : 1) * (high - low);
    if (x < 0.25 * 0.2 || x > 0.9 * 0.2) continue;
    sum += weight * density[e], volume += weight;
  }
  return sum / volume;
}

Simulation noh(const std::string& geometry, const std::string& more) {
  return simulate_text(R"(
title: Cold gas that is stopped
geometry: )" + geometry +
                       R"(
time: {end: 0.6 s}
materials: {gas: {density: 1 kg/m^3, eos: {ideal-gas: {gamma: 1.6666666667, pressure: 1e-6}}}}
bodies:
  gas:
    material: gas
    shape: {box: {min: [0, 0], max: [1, 0.01]}}
    cells: [200, 2]
    velocity: ["= x > 0 ? -1 : 0", 0]
boundaries:
  across: {body: gas, where: all, fix: [y]}
)" + more + "output: {history: 0.1}\n");
}

TEST(Gas, OfNohIsFourTimesAsDenseBeforeAWall) {
  const auto run = noh("plane-strain", "  wall: {body: gas, where: {side: min-x}, fix: [x]}\n");
  ASSERT_EQ(run.failure, "");
  EXPECT_NEAR(density_behind(run, false), 4, 0.03 * 4);
  EXPECT_LT(run.worst_drift, 1e-7);
}

TEST(Gas, OfNohIsSixteenTimesAsDenseAboutTheAxis) {
  const auto run = noh("axisymmetric", "");
  ASSERT_EQ(run.failure, "");
  EXPECT_NEAR(density_behind(run, true), 16, 0.05 * 16);
  EXPECT_LT(run.worst_drift, 1e-7);
}

}  // namespace
}  // namespace brunt::test
