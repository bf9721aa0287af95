// A bar that rings in its first mode for a million steps without any damping:
// what it has in motion and strain stays to 1e-6, the gate, and to rounding here. Steps are even,
// by max_step: where elements bound them they follow its strain, and velocity Verlet gains 6e-9 of
// its energy a step by that at a strain of 2e-4, which stands in energy.integration.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

TEST(RingingBar, KeepsItsEnergyForAMillionSteps) {
  const auto run = simulate_text(R"deck(
title: A bar that rings
geometry: plane-strain
time: {end: 8 s, max_step: 8 us}
materials: {m: {density: 7850 kg/m^3, elastic: {E: 200 GPa, nu: 0}}}
bodies:
  bar:
    material: m
    shape: {box: {min: [0, 0], max: [200 mm, 50 mm]}}
    cells: [4, 1]
    velocity: ["= cos(pi*x/0.2)", 0]
    element: {bulk_viscosity: {linear: 0, quadratic: 0}}
output: {history: 0.4 s}
)deck");
  ASSERT_EQ(run.failure, "");
  EXPECT_EQ(run.steps, 1000000);
  const Real start = run.first("energy.kinetic");
  for (std::size_t row = 0; row < run.rows.size(); ++row) {
    Real sum = 0;
    for (const char* column : {"energy.kinetic", "energy.internal", "energy.hourglass"}) {
      sum += run.column(column)[row];
    }
    // The last step is shorter by what rounding added to a million others, 8e-6 of one.
    EXPECT_NEAR(sum, start, (row + 1 < run.rows.size() ? 1e-12 : 1e-6) * start) << row;
  }
  const auto kinetic = run.column("energy.kinetic");
  EXPECT_GT(*std::max_element(kinetic.begin() + 1, kinetic.end()), 0.5 * start);
  EXPECT_LT(*std::min_element(kinetic.begin(), kinetic.end()), 0.5 * start);
  EXPECT_LT(run.worst_drift, 1e-10);
}

}  // namespace
}  // namespace brunt::test
