// Rigid tools whose velocity is a table over time.
//   A floor gets from rest to 0.1 m/s in 20 ms, a = 5 m/s^2, and goes on; a block lies on it. With
// mu = 0.3 it slides, at mu g = 2.943 m/s^2: 58.9 mm/s at 20 ms, when the floor is 1 mm along, and
// that of the floor from 34 ms on. With mu = 0.6, mu g > a, it goes with the floor. 1 %: it settles
// into its springs first, as on a slope (rigid_test.cpp).
//   A press that stops squeezes an elastic column evenly: with E = 1 GPa, nu = 0, 10 mm high, from
// rest to rest in 2 ms, 0.1 mm, it pushes with E A 0.01. 1 %: waves of the column.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

const std::string kShaken = R"(
title: A block on a floor that moves
geometry: 3d
time: {end: 40 ms}
parameters: {mu: 0.3}
materials: {oak: {density: 700 kg/m^3, elastic: {E: 12 GPa, nu: 0.3}}}
bodies:
  block: {rigid: true, material: oak, shape: {box: {min: [-30 mm, -20 mm, 0],
    max: [30 mm, 20 mm, 20 mm]}}}
  floor: {rigid: true, shape: {plane: {origin: [0, 0, 0], normal: z, extent: 400 mm}},
    motion: {velocity: [{table: [[0, 0], [20 ms, 0.1 m/s]], over: time}, 0, 0]}}
gravity: [0, 0, -9.81 m/s^2]
contact: {default: {friction: $mu, damping: 1}}
output: {history: 0.5 ms}
)";

TEST(DrivenTools, AFloorThatIsShakenTakesABlockAlongByFriction) {
  const auto run = simulate_text(kShaken);
  ASSERT_EQ(run.failure, "");
  const auto time = run.column("time"), block = run.column("body.block.velocity.x");
  const auto floor = run.column("body.floor.velocity.x");
  for (std::size_t k = 0; k < time.size(); ++k) {
    const Real ground = std::min(5 * time[k], 0.1), slides = 0.3 * 9.81 * time[k];
    EXPECT_NEAR(floor[k], ground, 1e-12);
    EXPECT_NEAR(block[k], std::min(ground, slides), 0.01 * 0.1) << time[k];
  }
  const Real way = 0.05 * 0.02 + 0.1 * (run.last("time") - 0.02);
  EXPECT_NEAR(run.last("body.floor.position.x"), way, 1e-12);
  EXPECT_LT(run.worst_drift, 1e-10);
}

TEST(DrivenTools, AFloorThatIsShakenSlowlyKeepsItsBlock) {
  const auto run = simulate_text(kShaken, {"parameters.mu=0.6"});
  ASSERT_EQ(run.failure, "");
  const Real apart = run.last("body.floor.position.x") - run.last("body.block.position.x");
  EXPECT_LT(std::fabs(apart), 1e-6);  // the shear of its springs
  EXPECT_NEAR(run.last("body.block.velocity.x"), 0.1, 1e-3);
}

const std::string kPress = R"(
title: A press that comes to rest
geometry: plane-strain
time: {end: 3 ms}
materials: {foam: {density: 1000 kg/m^3, elastic: {E: 1 GPa, nu: 0}}}
bodies:
  column: {material: foam, shape: {box: {min: [0, 0], max: [5 mm, 10 mm]}}, cells: [4, 8]}
  press: {rigid: true, material: foam, shape: {box: {min: [-5 mm, 10 mm], max: [10 mm, 15 mm]}},
    motion: {velocity: [0, {table: [[0, 0], [1 ms, -0.1 m/s], [2 ms, 0]], over: time}]}}
boundaries: {foot: {body: column, where: {side: min-y}, fix: [x, y]}}
contact: {default: {stiffness: 20, friction: 0}}
output: {history: 0.05 ms}
)";

TEST(DrivenTools, APressThatStopsSqueezesByItsWay) {
  const auto run = simulate_text(kPress);
  ASSERT_EQ(run.failure, "");
  EXPECT_NEAR(run.last("body.press.position.y"), 12.4e-3, 1e-12);
  EXPECT_EQ(run.last("body.press.velocity.y"), 0);
  const Real force = 1e9 * 5e-3 * 0.1 / 10;
  EXPECT_NEAR(run.last("body.press.force.y"), force, 0.01 * force);
  EXPECT_NEAR(-run.last("energy.boundary"), 0.5 * force * 1e-4, 0.01 * 0.5 * force * 1e-4);
  EXPECT_LT(run.worst_drift, 1e-10);
}

TEST(DrivenTools, GoOnFromACheckpointAndOnThreadsWithTheSameBits) {
  const auto plain = simulate_text(kPress);
  EXPECT_EQ(simulate_text(kPress, {}, {.split_at = plain.steps / 3}).hashes, plain.hashes);
  EXPECT_EQ(simulate_text(kPress, {}, {.threads = 2, .rearrange_every_step = true}).hashes,
            plain.hashes);
}

// One component follows its forces: a block that is led across falls meanwhile.
TEST(DrivenTools, OneThatFallsIsLedByItsTable) {
  const auto run = simulate_text(R"(
title: A block that is led while it falls
geometry: 3d
time: {end: 10 ms, max_step: 0.1 ms}
materials: {oak: {density: 700 kg/m^3, elastic: {E: 12 GPa, nu: 0.3}}}
bodies:
  block: {rigid: true, material: oak, shape: {box: {min: [0, 0, 0], max: [1, 1, 1]}},
    motion: {velocity: [{table: [[2 ms, 0], [6 ms, 8 m/s]], over: time}, 0, free]}}
gravity: [0, 0, -10 m/s^2]
)");
  ASSERT_EQ(run.failure, "");
  EXPECT_NEAR(run.last("body.block.position.x"), 0.5 + 0.016 + 8 * 0.004, 1e-12);
  EXPECT_NEAR(run.last("body.block.velocity.x"), 8, 1e-9);
  const Real end = run.last("time"), first = run.column("time")[1];
  EXPECT_NEAR(run.last("body.block.position.z"), 0.5 - 5 * end * end, 10 * end * first);
  EXPECT_LT(run.worst_drift, 1e-12);
}

}  // namespace
}  // namespace brunt::test
