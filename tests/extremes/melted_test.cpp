/// Bars of aluminium 6061 that are so fast that their foot melts: nothing but its volume resists
/// there, and elements between the anvil and what follows are crushed and turned inside out unless
/// something guards their shape. The length that is left is that of a rigid-plastic bar (Wilkins &
/// Guinan 1973), L/L0 = (1 - h/L0) exp(-rho v^2/(2 Y)) + h/L0 with h = 0.12 L0 and the flow stress
/// at the strain of some 0.5 that it is about, Y = A + B 0.5^n = 409 MPa: 0.54 at 478 m/s, 0.38 at
/// 603 m/s, 0.28 at 700 m/s. Their own bars were within 5 % of L0, and so are these.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

constexpr Real kLength = 25.4e-3;

/// `name`: what a test is called; else what the deck is given.
struct Bar {
  const char* name;
  const char* geometry;
  const char* integration;
  Real speed;  ///< [m/s]
  Real size;   ///< [mm]
};

std::string deck_of(const Bar& bar) {
  const bool space = std::string(bar.geometry) == "3d";
  const std::string axis = space ? "z" : "y", zeros = space ? "0, 0, " : "0, ";
  return R"(
title: A bar that melts at its foot
time: {end: 50 us}
heat: adiabatic
materials:
  aluminium:
    density: 2703 kg/m^3
    elastic: {E: 68.9 GPa, nu: 0.33}
    strength:
      johnson-cook: {A: 324 MPa, B: 114 MPa, n: 0.42, C: 0.002, m: 1.34, T_melt: 925 K}
    eos: {mie-gruneisen: {c0: 5240 m/s, s: 1.40, gamma0: 1.97}}
    thermal: {cp: 896 J/kg/K, k: 167 W/m/K}
contact: {default: {friction: 0}}
output: {every: 1 s, history: 1 us}
geometry: )" +
         std::string(bar.geometry) + R"(
bodies:
  bar:
    material: aluminium
    shape: {cylinder: {radius: 3.81 mm, length: 25.4 mm, base: [)" +
         zeros + "0], axis: " + axis + "}}\n    size: " + std::to_string(bar.size) +
         " mm\n    velocity: [" + zeros + std::to_string(-bar.speed) +
         "]\n    element: {integration: " + bar.integration + R"(}
  anvil:
    rigid: true
    shape: {plane: {origin: [)" +
         (space ? "0, 0, " : "30 mm, ") + "0], normal: " + axis + R"(, extent: 60 mm}}
measures:
  length: {extent: {body: bar, axis: )" +
         axis + "}}\n";
}

Real length_of_theory(Real speed) {
  const Real flow_stress = 324e6 + 114e6 * std::pow(0.5, 0.42), hard = 0.12;
  return kLength * ((1 - hard) * std::exp(-2703 * speed * speed / (2 * flow_stress)) + hard);
}

void expect_bar(const Bar& bar) {
  const Simulation run = simulate_text(deck_of(bar));
  EXPECT_EQ(run.failure, "");
  EXPECT_LT(run.created, 0.01);
  EXPECT_NEAR(run.measures.at("length"), length_of_theory(bar.speed), 0.05 * kLength);
  // It stays before the anvil, and in one piece: no corner is farther out than mass could go, the
  // speed of the blow for the time of the run.
  const BodyView& view = run.bodies.at("bar");
  const std::size_t up = std::string(bar.geometry) == "3d" ? 2 : 1;
  for (std::size_t i = 0; i < view.position.size(); i += 3) {
    EXPECT_GT(view.position[i + up], -1e-3 * bar.size);
    EXPECT_LT(std::hypot(view.position[i], up == 2 ? view.position[i + 1] : 0.0),
              3.81e-3 + bar.speed * 50e-6);
  }
}

class Melted : public testing::TestWithParam<Bar> {};
TEST_P(Melted, FeetGoOnToTheEnd) { expect_bar(GetParam()); }
INSTANTIATE_TEST_SUITE_P(Rings, Melted,
                         testing::Values(Bar{"q1p0", "axisymmetric", "q1p0", 478, 1.27},
                                         Bar{"one_point", "axisymmetric", "one-point", 603, 1.27}),
                         [](const auto& info) { return info.param.name; });

class LongMelted : public testing::TestWithParam<Bar> {};
TEST_P(LongMelted, FeetGoOnToTheEnd) { expect_bar(GetParam()); }
INSTANTIATE_TEST_SUITE_P(Bars, LongMelted,
                         testing::Values(Bar{"rings_q1p0_603", "axisymmetric", "q1p0", 603, 0.9},
                                         Bar{"rings_one_point_478", "axisymmetric", "one-point",
                                             478, 0.6},
                                         Bar{"q1p0_478", "3d", "q1p0", 478, 1.3},
                                         Bar{"q1p0_603", "3d", "q1p0", 603, 1.3},
                                         Bar{"one_point_478", "3d", "one-point", 478, 1.3},
                                         Bar{"one_point_603", "3d", "one-point", 603, 1.3},
                                         Bar{"one_point_700", "3d", "one-point", 700, 1.3}),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace brunt::test
