// Taylor bars of Johnson and Cook's copper and iron against a small code of its own:
// axisymmetric, q1p0, a linear equation of state, a foot that glides on the wall without friction,
// adiabatic. Ten elements to the radius; 1 % of the length and 2 % of the diameter of the foot, the
// gates. Measured over all nine bars of the table: 0.3 % and 1.0 %.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

struct Bar {
  const char* metal;
  Real length, diameter;  ///< [mm] at time 0
  Real speed;             ///< [m/s]
  Real length_left;       ///< over that at time 0
  Real foot;              ///< [mm] diameter
};

void PrintTo(const Bar& bar, std::ostream* out) { *out << bar.metal << bar.speed; }

class TaylorJohnsonCook : public testing::TestWithParam<Bar> {};

TEST_P(TaylorJohnsonCook, HasTheLengthAndFootOfTheReference) {
  const Bar bar = GetParam();
  const Real radius = 0.5 * bar.diameter;
  const auto rows = static_cast<int>(std::lround(10 * bar.length / radius));
  const auto run = simulate_text(
      R"(
title: Taylor bar
geometry: axisymmetric
time: {end: 120 us}
heat: adiabatic
ambient: 298 K
materials:
  copper:
    density: 8960 kg/m^3
    elastic: {E: 124 GPa, nu: 0.34}
    strength: {johnson-cook: {A: 90 MPa, B: 292 MPa, n: 0.31, C: 0.025, m: 1.09, T_melt: 1356 K}}
    thermal: {cp: 383 J/kg/K, taylor_quinney: 0.9}
  iron:
    density: 7890 kg/m^3
    elastic: {E: 207 GPa, nu: 0.29}
    strength: {johnson-cook: {A: 175 MPa, B: 380 MPa, n: 0.32, C: 0.06, m: 0.55, T_melt: 1811 K}}
    thermal: {cp: 452 J/kg/K, taylor_quinney: 0.9}
bodies:
  bar:
    shape: {cylinder: {radius: 1 mm, length: 1 mm, base: [0, 0], axis: y}}
    element: {integration: q1p0}
boundaries: {foot: {body: bar, where: {side: min-y}, fix: [y]}}
stop: {at_rest: {body: bar, below: 8 m/s, for: 4 us}}
measures:
  length: {extent: {body: bar, axis: y}}
  foot: {extent: {body: bar, axis: x}}
output: {history: 1 us}
)",
      {"bodies.bar.material=" + std::string(bar.metal),
       "bodies.bar.shape.cylinder.radius=" + std::to_string(radius) + " mm",
       "bodies.bar.shape.cylinder.length=" + std::to_string(bar.length) + " mm",
       "bodies.bar.cells=[10, " + std::to_string(rows) + "]",
       "bodies.bar.velocity=[0, -" + std::to_string(bar.speed) + " m/s]"});
  ASSERT_EQ(run.failure, "");
  EXPECT_NEAR(1e3 * run.measures.at("length") / bar.length, bar.length_left,
              0.01 * bar.length_left);
  EXPECT_NEAR(2e3 * run.measures.at("foot"), bar.foot, 0.02 * bar.foot);
  EXPECT_LT(run.worst_drift, 1e-10);
}

// Of the nine bars those that differ most: in metal, speed and length.
INSTANTIATE_TEST_SUITE_P(, TaylorJohnsonCook,
                         testing::Values(Bar{"copper", 23.47, 7.62, 210, 0.638, 15.6},
                                         Bar{"copper", 25.4, 7.62, 130, 0.812, 11.1},
                                         Bar{"copper", 25.4, 7.62, 190, 0.681, 14.5},
                                         Bar{"iron", 25.4, 7.62, 197, 0.796, 12.3},
                                         Bar{"iron", 12.6, 7.62, 279, 0.666, 14.3}),
                         [](const auto& info) {
                           return std::string(info.param.metal) + std::to_string(info.index);
                         });

}  // namespace
}  // namespace brunt::test
