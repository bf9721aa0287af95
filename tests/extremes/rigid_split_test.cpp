/// Quads beside a rigid face are four triangles from a warp of half a percent on (decision 222):
/// nothing that a contact carries may go where they cross it, pulled or pressed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

// A block on a plate, held by a soft bond that its top is pulled from, the more the farther out in
// x and y: faces warp by more than a percent. Soft springs in series with the block: the force
// grows all the time, and nothing of it may be lost as faces are split.
TEST(RigidSplit, ABondGoesOn) {
  const Simulation run = simulate_text(R"(
title: A block that is pulled off a rigid plate in a slant
geometry: 3d
time: {end: 200 us}
materials:
  soft:
    density: 2700 kg/m^3
    elastic: {E: 70 GPa, nu: 0.33}
    strength: {j2: {yield: 100 MPa, hardening: 200 MPa}}
bodies:
  block:
    material: soft
    shape: {box: {min: [-5 mm, -5 mm, 0], max: [5 mm, 5 mm, 10 mm]}}
    cells: [5, 5, 5]
  plate:
    rigid: true
    shape: {box: {min: [-8 mm, -8 mm, -2 mm], max: [8 mm, 8 mm, 0]}}
    size: 4 mm
boundaries:
  top:
    body: block
    where: {box: {min: [-6 mm, -6 mm, 9.9 mm], max: [6 mm, 6 mm, 10.1 mm]}}
    velocity: [2, 0, '= 6 * (1 + x / 0.0025) * (y / 0.005)']
contact:
  pairs:
    glue:
      {between: [block, plate], friction: 0.3, cohesion: 1 GPa, tension: 1 GPa, stiffness: 0.02}
output: {every: 1 s, history: 8 us}
)");
  EXPECT_EQ(run.failure, "");
  EXPECT_LT(run.created, 1e-3);
  const auto force = run.column("contact.glue.force.z");
  ASSERT_GT(force.size(), 20U);
  EXPECT_GT(force.back(), 2000);
  for (std::size_t k = 3; k < force.size(); ++k) EXPECT_GT(force[k], force[k - 1] - 20) << k;
}

// A sheet that a ball draws into a die, with friction: the small jumps at the limit come often.
// Measured: 0.15 % of the energy.
TEST(RigidSplit, ASheetThatIsFormedLosesLittle) {
  const Simulation run = simulate_text(R"(
title: A thin sheet is drawn into a rigid die by a ball
geometry: 3d
time: {end: 400 us}
materials:
  steel:
    density: 7850 kg/m^3
    elastic: {E: 200 GPa, nu: 0.3}
    strength: {j2: {yield: 250 MPa, hardening: 500 MPa}}
bodies:
  sheet:
    material: steel
    shape: {box: {min: [-20 mm, -20 mm, 0], max: [20 mm, 20 mm, 1 mm]}}
    cells: [20, 20, 1]
    element: {integration: q1p0}
  ball:
    rigid: true
    shape: {sphere: {center: [0.3 mm, 0.2 mm, 9.05 mm], radius: 8 mm}}
    size: 2 mm
    motion: {velocity: [0, 0, -20 m/s]}
  left:
    rigid: true
    shape: {box: {min: [-22 mm, -22 mm, -5 mm], max: [-12 mm, 22 mm, 0]}}
    size: 5 mm
  right:
    rigid: true
    shape: {box: {min: [12 mm, -22 mm, -5 mm], max: [22 mm, 22 mm, 0]}}
    size: 5 mm
contact: {default: {friction: 0.15}}
output: {every: 1 s, history: 4 us}
)");
  EXPECT_EQ(run.failure, "");
  EXPECT_LT(run.created, 2e-3);
  const auto pairs = run.column("energy.contact.pairs"), internal = run.column("energy.internal");
  EXPECT_GT(internal.back(), 5);  // [J]
  for (const Real lost : pairs) EXPECT_LT(std::fabs(lost), 2e-3 * internal.back());
}

}  // namespace
}  // namespace brunt::test
