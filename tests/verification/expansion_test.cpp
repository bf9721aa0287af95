// Thermal expansion. Temperatures are prescribed everywhere, T0 + D (1 - cos(pi t/t1))/2: slowly
// enough (t1 is 20 times as long as sound needs through the bar) that inertia leaves less than 1/(2
// t1/period)^2 = 0.2 % of oscillation.
//   A free bar is longer by alpha D everywhere and has no stress.
//   Between ends that do not move its stress along is -E alpha D, to the first order in alpha D
//   = 1.2e-3;
// in plane strain a free section has -E alpha D across the plane and (1 + nu) alpha D in it.
//   D that rises linearly from the lower to the upper side, -+D/2, bends a free bar by alpha D/h
// without stress: its middle stands alpha D L^2/8h above its ends.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

constexpr Real kAlpha = 1.2e-5, kRise = 100, kLength = 10e-3, kThick = 1.5e-3, kE = 200e9,
               kNu = 0.3;

struct Bar {
  std::string geometry = "3d", body, rise = "100", ends;
};

Simulation heated(const Bar& bar, const RunVariation& variation = {}) {
  const bool flat = bar.geometry != "3d";
  const std::string box = flat ? "{min: [-5 mm, -0.75 mm], max: [5 mm, 0.75 mm]}"
                               : "{min: [-5 mm, -0.75 mm, -0.5 mm], max: [5 mm, 0.75 mm, 0.5 mm]}";
  return simulate_text("title: A heated bar\ngeometry: " + bar.geometry + R"(
heat: conduct
time: {end: 110 us}
materials:
  steel:
    density: 7850 kg/m^3
    elastic: {E: 200 GPa, nu: 0.3}
    thermal: {cp: 450, k: 20, expansion: 1.2e-5 1/K}
bodies:
  bar:
    material: steel
    shape: {box: )" + box + "}\n    " +
                           bar.body + R"(
    temperature: 300 K
boundaries:
  heat: {body: bar, where: all, temperature: "= 300 + 0.5*(1 - cos(pi*min(1, t/100e-6)))*)" +
                           bar.rise + "\"}\n" + bar.ends + "output: {every: 1 s, history: 1 us}\n",
                       {}, variation);
}

/// Mean over points of a body, weighted by how far along x they lie: the stretch along x less 1.
Real stretch_of(const BodyView& view) {
  const auto& u = field_named(view.point_fields, "displacement")->values;
  Real sum = 0, square = 0;
  for (std::size_t i = 0; i < view.position.size(); i += 3) {
    const Real x = view.position[i] - u[i];
    sum += u[i] * x, square += x * x;
  }
  return sum / square;
}

Real largest(const BodyView& view, const char* name) {
  const Field* field = field_named(view.cell_fields, name);
  if (field == nullptr) field = field_named(view.point_fields, name);
  Real found = 0;
  for (const Real value : field->values) found = std::max(found, std::abs(value));
  return found;
}

Real mean_stress(const BodyView& view, std::size_t component) {
  const Field* field = field_named(view.cell_fields, "stress");
  if (field == nullptr) field = field_named(view.point_fields, "stress");
  Real sum = 0;
  for (std::size_t k = component; k < field->values.size(); k += 6) sum += field->values[k];
  return 6 * sum / static_cast<Real>(field->values.size());
}

const char* const kElements[] = {"one-point", "q1p0", "full"};
std::string hexes(const std::string& integration, const std::string& cells = "[12, 4, 2]") {
  return "cells: " + cells + "\n    element: {integration: " + integration + "}";
}

TEST(Expansion, AFreeBarGrowsWithoutStress) {
  std::vector<Bar> bars{{"3d", "cells: [12, 4, 2]\n    element: {type: tet4}", "100", ""},
                        {"3d", "method: sph\n    size: 0.25 mm", "100", ""}};
  for (const auto* const kind : kElements) bars.push_back({"3d", hexes(kind), "100", ""});
  for (const Bar& bar : bars) {
    SCOPED_TRACE(bar.body);
    const auto run = heated(bar);
    ASSERT_EQ(run.failure, "");
    const BodyView& view = run.bodies.at("bar");
    // Particles near the surface see half of their neighbours.
    EXPECT_NEAR(stretch_of(view) / (kAlpha * kRise), 1, 0.005);
    EXPECT_LT(largest(view, "von_mises"), 0.02 * kE * kAlpha * kRise);
    EXPECT_LT(run.worst_drift, 1e-9);
  }
}

TEST(Expansion, BetweenEndsThatHoldABarIsPressed) {
  const std::string ends =
      "  low: {body: bar, where: {side: min-x}, fix: [x]}\n"
      "  high: {body: bar, where: {side: max-x}, fix: [x]}\n";
  for (const auto* const kind : kElements) {
    SCOPED_TRACE(kind);
    const auto run = heated({"3d", hexes(kind), "100", ends});
    const BodyView& view = run.bodies.at("bar");
    EXPECT_NEAR(mean_stress(view, 0) / (-kE * kAlpha * kRise), 1, 0.005);
    EXPECT_LT(std::abs(mean_stress(view, 1)), 0.01 * kE * kAlpha * kRise);
  }
}

TEST(Expansion, InPlaneStrainThePlaneHolds) {
  for (const auto* const kind : kElements) {
    SCOPED_TRACE(kind);
    const auto run = heated(
        {"plane-strain", "cells: [12, 4]\n    element: {integration: " + std::string(kind) + "}",
         "100", ""});
    const BodyView& view = run.bodies.at("bar");
    EXPECT_NEAR(stretch_of(view) / ((1 + kNu) * kAlpha * kRise), 1, 0.005);
    EXPECT_NEAR(mean_stress(view, 2) / (-kE * kAlpha * kRise), 1, 0.005);
  }
}

TEST(Expansion, ABarThatIsHotterAboveBends) {
  for (const auto* const kind : kElements) {
    SCOPED_TRACE(kind);
    const auto run = heated({"3d", hexes(kind, "[24, 8, 2]"), "100*y/1.5e-3", ""});
    const BodyView& view = run.bodies.at("bar");
    const auto& u = field_named(view.point_fields, "displacement")->values;
    Real ends = 0, middle = 0;
    for (std::size_t i = 0; i < u.size(); i += 3) {
      const Real x = view.position[i] - u[i];
      if (std::abs(x) > 0.499 * kLength) ends += u[i + 1] / 54;
      if (std::abs(x) < 0.001 * kLength) middle += u[i + 1] / 27;
    }
    const Real expected = kAlpha * kRise / kThick * kLength * kLength / 8;
    // An element has one temperature: of n layers the moment lacks 1/n^2, and q1p0 is as stiff
    // again.
    EXPECT_NEAR((middle - ends) / expected, 1, 0.035);
  }
}

TEST(Expansion, SaysTheSameInTwoPartsAndOnMoreThreads) {
  const Bar bar{"3d", hexes("one-point"), "100*y/1.5e-3", ""};
  const auto whole = heated(bar);
  EXPECT_EQ(heated(bar, {.split_at = 200}).hashes, whole.hashes);
  EXPECT_EQ(heated(bar, {.threads = 2}).hashes, whole.hashes);
}

// Held as a whole in the plane and heated by 20 K, a body presses with -E a dT (1 + nu) / ((1 + nu)
// (1 - 2 nu)) = -E a dT / (1 - 2 nu); a stress of time 0 adds to it.
TEST(Expansion, WhatIsFixedAsAWholePressesOnWhatHoldsIt) {
  const auto run = simulate_text(R"(title: a block that is fixed is heated
geometry: plane-strain
heat: conduct
time: {end: 20 us, max_step: 20 ns}
materials:
  m:
    density: 2700 kg/m^3
    elastic: {E: 70 GPa, nu: 0.3}
    thermal: {cp: 900, k: 200, expansion: 2e-5 1/K}
bodies:
  a:
    material: m
    shape: {box: {min: [0, 0], max: [10 mm, 10 mm]}}
    size: 1 mm
    stress: {xx: -10 MPa}
boundaries:
  hot: {body: a, where: all, temperature: {table: [[0, 298 K], [10 us, 318 K]], over: time}}
  held: {body: a, where: all, fix: [x, y]}
sections: {s: {body: a, plane: {axis: x, at: 4.5 mm}}}
output: {history: 1 us}
)");
  ASSERT_EQ(run.failure, "");
  constexpr Real kArea = 0.01;  // [m^2]
  const Real exact = -(70e9 * 2e-5 * 20 / (1 - 2 * 0.3) + 10e6) * kArea;
  // Expansion counts by volume, (1 + a dT)^3: 2 a dT = 8e-4 more.
  EXPECT_NEAR(run.last("section.s.force.x"), exact, 1e-3 * std::fabs(exact));
}

}  // namespace
}  // namespace brunt::test
