/// Planes of symmetry: a quarter of a bar that hits a wall is the bar. Energies are a quarter, and
/// places the same, to what sums in another order leave.
#include <gtest/gtest.h>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

Simulation mirrored(const std::string& box, const std::string& more) {
  return simulate_text(R"(
title: A square bar hits a wall
geometry: 3d
time: {end: 20 us}
materials:
  copper: {density: 8960 kg/m^3, elastic: {E: 124 GPa, nu: 0.34}, strength: {j2: {yield: 200 MPa}}}
bodies:
  bar:
    material: copper
    shape: {box: {)" + box +
                       R"(}}
    size: 1 mm
    velocity: [0, 0, -150 m/s]
  wall: {rigid: true, shape: {plane: {origin: [0, 0, 0], normal: z, extent: 30 mm}}}
contact: {default: {friction: 0}}
measures:
  length: {extent: {body: bar, axis: z}}
  strain: {max: {body: bar, field: eps_p}}
output: {every: 1 s, history: 1 us}
)" + more);
}

TEST(Symmetry, AQuarterIsTheWhole) {
  const auto whole = mirrored("min: [-3 mm, -3 mm, 0.2 mm], max: [3 mm, 3 mm, 12.2 mm]", "");
  const auto quarter =
      mirrored("min: [0, 0, 0.2 mm], max: [3 mm, 3 mm, 12.2 mm]", "symmetry: {x: 0, y: 0}\n");
  EXPECT_EQ(whole.failure, "");
  EXPECT_EQ(quarter.failure, "");
  EXPECT_EQ(whole.steps, quarter.steps);
  for (const char* const column : {"energy.kinetic", "energy.internal"}) {
    EXPECT_NEAR(4 * quarter.last(column) / whole.last(column), 1, 1e-6) << column;
  }
  EXPECT_NEAR(quarter.measures.at("length"), whole.measures.at("length"), 1e-9);
  EXPECT_NEAR(quarter.measures.at("strain"), whole.measures.at("strain"), 1e-6);
  EXPECT_LT(quarter.worst_drift, 1e-9);
}

}  // namespace
}  // namespace brunt::test
