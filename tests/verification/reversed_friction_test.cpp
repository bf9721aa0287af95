// Friction has no side: a block on a floor that is shaken to and fro moves as on
// one that is shaken fro and to, mirrored. It sticks where the floor turns and slips between. Both
// sum in another order, and the block chatters as its weight comes on: what rounding leaves is
// 5e-13 of the largest speed (measured), a hundred roundings.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/materials.hpp"
#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

const std::string kDeck = kRubber + R"deck(
title: a floor shaken under a block
geometry: plane-strain
parameters: {speed: 2 m/s}
time: {end: 30 ms}
bodies:
  block:
    material: rubber
    shape: {box: {min: [-10 mm, 0], max: [10 mm, 20 mm]}}
    size: 5 mm
  floor:
    rigid: true
    shape: {box: {min: [-60 mm, -10 mm], max: [60 mm, 0]}}
    size: 20 mm
    motion: {velocity: ["= $speed*sin(2*pi*100*t)", 0]}
gravity: [0, -9.81 m/s^2]
contact: {default: {friction: 0.3}}
output: {history: 0.1 ms}
)deck";

TEST(ReversedFriction, IsTheMirrorOfFriction) {
  for (const char* method : {"fe", "sph"}) {
    SCOPED_TRACE(method);
    const std::string key = "bodies.block.method=" + std::string(method);
    const auto to = simulate_text(kDeck, {key});
    const auto fro = simulate_text(kDeck, {key, "parameters.speed=-2 m/s"});
    ASSERT_EQ(to.failure + fro.failure, "");
    ASSERT_EQ(to.rows.size(), fro.rows.size());
    const auto v = to.column("body.block.velocity.x"),
               mirrored = fro.column("body.block.velocity.x");
    Real largest = 0, left = 0;
    for (std::size_t k = 0; k < v.size(); ++k) {
      largest = std::max(largest, std::fabs(v[k]));
      left = std::max(left, std::fabs(v[k] + mirrored[k]));
    }
    EXPECT_GT(largest, 1e-2);  // mu g over half a period: 15 mm/s
    EXPECT_LT(left, 5e-12 * largest);
  }
}

}  // namespace
}  // namespace brunt::test
