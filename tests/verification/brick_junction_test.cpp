// A steel bar, 0.2 m square, hits the joint between two bricks of one course above the middle of a
// brick below, at 60.6 m/s along itself and 35 m/s down. Its flanks, 0.1 m from the joint, and the
// bricks' sides at the joint oppose each other from the first touch on: 0.1 m deep, the whole depth
// of an element, over as much as the bar's end has come in, some 10 mm. They must bear nothing: the
// end holds the bar ((C14) of docs/theory/contact.md), whose plane waves push it with
//   p = v_n Z1 Z2/(Z1 + Z2), Z = sqrt(rho M): 60.6 m/s * 7.4 MPa s/m = 0.45 GPa
// 0.45 GPa/(0.5 * 0.16 TPa/m) = 6 mm into springs of phi = 0.5; twice that, as waves of a bar's end
// are not plane, is allowed for. When sides faded up to rho = 16 they held 0.38 % of the energy,
// were let go at 0.1 m, with a warning, and left it in contact.pairs.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

const char* const kDeck = R"(
title: A bar on the joint of two bricks
geometry: 3d
time: {end: 1 ms}
materials:
  brick: {density: 2300 kg/m^3, elastic: {E: 30 GPa, nu: 0.2}}
  steel: {density: 7850 kg/m^3, elastic: {E: 200 GPa, nu: 0.3}}
bodies:
  below: {material: brick, shape: {box: {min: [0, -0.4, -0.4], max: [0.64, 0.4, 0]}}, size: 0.2}
  left: {material: brick, shape: {box: {min: [0, -0.8, 0], max: [0.64, 0, 0.4]}}, size: 0.2}
  right: {material: brick, shape: {box: {min: [0, 0, 0], max: [0.64, 0.8, 0.4]}}, size: 0.2}
  bar:
    material: steel
    shape: {box: {min: [-2, -0.1, -0.1], max: [-0.001, 0.1, 0.1]}}
    size: 0.1
    velocity: [60.6, 0, -35]
contact: {default: {friction: 0.6}}
output: {every: 1 s, history: 0.05 ms}
)";

TEST(BrickJunction, FlanksOfABarBearNothing) {
  const auto run = simulate_text(kDeck);
  EXPECT_EQ(run.failure, "");
  EXPECT_TRUE(run.warnings.empty()) << run.warnings.front();
  const Real energy = run.first("energy.kinetic");
  for (const Real pairs : run.column("energy.contact.pairs")) {
    EXPECT_LT(std::fabs(pairs), 5e-4 * energy);
  }
  Real deepest = 0;
  for (const char* const brick : {"below-bar", "left-bar", "right-bar"}) {
    const auto depth = run.column(std::string("contact.") + brick + ".max_penetration");
    deepest = std::max(deepest, *std::max_element(depth.begin(), depth.end()));
  }
  EXPECT_GT(deepest, 3e-3);
  EXPECT_LT(deepest, 15e-3);
  // A symmetric blow turns the bar to neither side; sums of planes are not symmetric to rounding.
  EXPECT_NEAR(run.last("body.bar.velocity.y"), 0, 1e-5 * 60.6);
}

}  // namespace
}  // namespace brunt::test
