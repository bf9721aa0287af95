// Rigid tools whose motion is prescribed over time, and those that are pushed. A trapezoid of
// velocity, up to 2 m/s in 1 ms, 2 ms long and down in 1 ms, moves by 6 mm; a rate a t turns by
// a t^2/2. Tables are integrated exactly, expressions to the fourth power of a step. A force on all
// of a body leaves it unturned; on a side it acts at the middle of it.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

const std::string kDeck = R"yaml(
geometry: 3d
time: {end: 5 ms}
materials:
  soft: {density: 1000, elastic: {E: 1 GPa, nu: 0.3}}
bodies:
  other:
    material: soft
    shape: {box: {min: [0, 0, 0], max: [10 mm, 10 mm, 10 mm]}}
    cells: [2, 2, 2]
  tool:
    rigid: true
    material: soft
    shape: {box: {min: [20 mm, 0, 0], max: [30 mm, 10 mm, 10 mm]}}
    motion:
      velocity:
        - {table: [[0, 0], [1 ms, 2 m/s], [3 ms, 2 m/s], [4 ms, 0]], over: time}
        - "= 3*sin(2*pi*100*t)"
        - 0.5 m/s
      spin: {axis: z, rate: "= 2e4*t", about: [25 mm, 5 mm, 5 mm]}
output: {history: 0.1 ms}
)yaml";

void expect_way(const Simulation& run) {
  ASSERT_EQ(run.failure, "");
  const auto time = run.column("time"), x = run.column("body.tool.position.x"),
             y = run.column("body.tool.position.y"), z = run.column("body.tool.position.z"),
             turn = run.column("body.tool.rotation.z"), spin = run.column("body.tool.spin.z"),
             vx = run.column("body.tool.velocity.x");
  const std::size_t middle = 20;
  const Real t = time[middle];
  ASSERT_NEAR(t, 2e-3, 5e-5);
  EXPECT_NEAR(x.back() - x[0], 6e-3, 1e-12);
  EXPECT_NEAR(x[middle] - x[0], 1e-3 + 2 * (t - 1e-3), 1e-12);
  EXPECT_NEAR(vx[middle], 2, 1e-9);
  EXPECT_NEAR(y[middle] - y[0], 3 / (200 * kPi) * (1 - std::cos(200 * kPi * t)), 1e-12);
  EXPECT_NEAR(z.back() - z[0], 0.5 * time.back(), 1e-12);
  EXPECT_NEAR(turn[middle], 1e4 * t * t, 1e-9);
  EXPECT_NEAR(spin[middle], 2e4 * t, 1e-9);
}

TEST(RigidMotion, FollowsTablesAndExpressionsOfTime) { expect_way(simulate_text(kDeck)); }

TEST(RigidMotion, IsThatOfTheProcessAtAnySpeed) {
  expect_way(simulate_text(kDeck, {"time.process_speed=10"}));
}

/// Moved along x it falls freely, half of a first step late, and the ledger closes.
TEST(RigidMotion, LeavesFreeComponentsToForces) {
  const auto run = simulate_text(
      kDeck, {"bodies.tool.motion.velocity=[{table: [[0, 0], [1 ms, 2 m/s]], over: time}, 0, free]",
              "gravity=[0, 0, -10]", "boundaries.hold={body: other, where: all, fix: [x, y, z]}"});
  ASSERT_EQ(run.failure, "");
  const auto x = run.column("body.tool.position.x"), z = run.column("body.tool.position.z");
  EXPECT_NEAR(x.back() - x[0], 9e-3, 1e-12);
  EXPECT_NEAR(z.back() - z[0], -0.5 * 10 * 25e-6, 1e-7);
  EXPECT_LT(run.worst_drift, 1e-10);
  // What moves it does the work of its kinetic energy: of translation, fall and turn.
  const Real mass = 1e-3, arm_square = 1e-4 / 6, spin = 2e4 * 5e-3, fall = 10 * 5e-3;
  const Real kinetic = 0.5 * mass * (4 + fall * fall + arm_square * spin * spin);
  EXPECT_NEAR(run.column("energy.kinetic").back(), kinetic, 1e-5 * kinetic);
}

/// 3 N on 1 g: a t^2/2 of 37.5 mm in 5 ms, without a turn; its work is the kinetic energy.
TEST(RigidMotion, AForceOnAllActsAtTheCentre) {
  const auto run =
      simulate_text(kDeck, {"bodies.tool.motion=null", "contact.default.ignore=true",
                            "boundaries.push={body: tool, where: all, force: [0, 0, 3 N]}"});
  ASSERT_EQ(run.failure, "");
  const auto time = run.column("time"), z = run.column("body.tool.position.z");
  EXPECT_NEAR(z.back() - z[0], 0.5 * 3000 * time.back() * time.back(), 2e-3 * 37.5e-3);
  EXPECT_NEAR(run.column("body.tool.rotation.z").back(), 0, 1e-12);
  EXPECT_NEAR(run.column("body.tool.rotation.x").back(), 0, 1e-12);
  EXPECT_LT(run.worst_drift, 1e-10);
  const Real kinetic = run.column("energy.kinetic").back();
  EXPECT_NEAR(-run.column("energy.boundary").back(), kinetic, 1e-3 * kinetic);
}

/// 1 MPa on a side of 1 cm^2 is 100 N along x whatever pushes; off the middle it turns the body: a
/// force F on a quarter of that side has the moment F 2.5 mm about y, and about z.
TEST(RigidMotion, ForceAndPressureOnASide) {
  const std::string tool =
      "bodies.tool={rigid: true, material: soft, shape: {box: {min: [20 mm, 0, 0], max: [30 mm, "
      "10 mm, 10 mm]}}, size: 5 mm}";
  const auto end_of = [&](const std::string& boundary) {
    return simulate_text(
        kDeck, {tool, "time.end=0.1 ms", "contact.default.ignore=true", "output.history=10 us",
                "boundaries.push={body: tool, " + boundary});
  };
  const auto force = end_of("where: {side: min-x}, force: [100 N, 0, 0]}");
  const auto pressure = end_of("where: {side: min-x}, pressure: 1 MPa}");
  ASSERT_EQ(force.failure + pressure.failure, "");
  const Real v = force.column("body.tool.velocity.x").back();
  EXPECT_NEAR(v, 100 / 1e-3 * force.column("time").back(), 0.06 * v);  // half a first step less
  EXPECT_NEAR(pressure.column("body.tool.velocity.x").back(), v, 1e-9 * v);
  EXPECT_NEAR(force.column("body.tool.torque.z").back(), 0, 1e-9);
  const auto corner = end_of(
      "where: {box: {min: [19 mm, 5 mm, 5 mm], max: [21 mm, 10 mm, 10 mm]}}, force: [100 N, 0, "
      "0]}");
  ASSERT_EQ(corner.failure, "");
  EXPECT_NEAR(corner.column("body.tool.torque.y")[1], 0.25, 1e-3);
  EXPECT_NEAR(corner.column("body.tool.torque.z")[1], -0.25, 1e-3);
}

}  // namespace
}  // namespace brunt::test
