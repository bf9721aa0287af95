// Gravity that grows from 0 to 40 m/s^2 in 10 ms and stays for 10 ms. What falls freely has
//   v = 40 (0.005 + 0.01) = 0.6 m/s, and has come 40 0.01^2 (1/6 + 1/2 + 1/2) = 14/3 mm.
// A sine of half a wave in 20 ms, 40 sin(pi t/T): v = 40 2 T/pi = 0.509296 m/s. Elements,
// particles and a rigid body fall alike. Rows may lag by half a step of 50 us, 1 mm/s at 40 m/s^2
// or 1.7e-3 of 0.6 m/s. The work of the weight is m v^2/2; the kinetic energy of the ledger, of v
// +- a dt/2, is less by (a dt/2 v)^2 = 2.8e-6 of it.
//   What is held carries the weight of each moment, R = -m g, and the moment of that about the
// origin, c x R, c its centre of mass.
//   A floor that a box rests on feels its weight: 50 ms after gravity has come to its full value
// damping has left exp(-300 0.05/2) = 6e-4 of any swing; 1 %.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

const std::string kFalling = R"(
title: Three bodies fall
time: {end: 20 ms, max_step: 50 us}
materials: {foam: {density: 1000 kg/m^3, elastic: {E: 10 MPa, nu: 0.3}}}
bodies:
  elements: {material: foam, size: 10 mm,
    shape: {box: {min: [0, 0, 0], max: [30 mm, 20 mm, 20 mm]}}}
  particles: {method: sph, material: foam, size: 10 mm,
    shape: {box: {min: [100 mm, 0, 0], max: [130 mm, 30 mm, 30 mm]}}}
  rigid: {rigid: true, material: foam,
    shape: {box: {min: [200 mm, 0, 0], max: [220 mm, 20 mm, 20 mm]}}}
gravity: [0, 0, {table: [[0, 0], [10 ms, -40 m/s^2]], over: time}]
output: {history: 1 ms}
)";

void expect_fall(const Simulation& run, Real speed, Real way) {
  ASSERT_EQ(run.failure, "");
  for (const std::string body : {"elements", "particles", "rigid"}) {
    const std::string at = "body." + body + ".";
    EXPECT_NEAR(run.last(at + "velocity.z") / -speed, 1, 2e-3) << body;
    if (way > 0) {
      const Real fallen = run.first(at + "position.z") - run.last(at + "position.z");
      EXPECT_NEAR(fallen / way, 1, 1e-3) << body;
    }
  }
  EXPECT_NEAR(run.last("energy.boundary") / -run.last("energy.kinetic"), 1, 3e-6);
  EXPECT_LT(run.worst_drift, 1e-10);
}

TEST(GravityOverTime, FallsByATable) { expect_fall(simulate_text(kFalling), 0.6, 14e-3 / 3); }

TEST(GravityOverTime, FallsByAnExpression) {
  const Real way = 0;
  expect_fall(simulate_text(kFalling, {"gravity=[0, 0, \"= -40*sin(pi*t/0.02)\"]"}),
              80 * 0.02 / kPi, way);
}

TEST(GravityOverTime, GoesOnFromACheckpoint) {
  const auto whole = simulate_text(kFalling);
  RunVariation variation;
  variation.split_at = 150, variation.threads = 2;
  const auto split = simulate_text(kFalling, {}, variation);
  EXPECT_EQ(split.hashes, whole.hashes);
  EXPECT_EQ(split.rows, whole.rows);
}

TEST(GravityOverTime, AConstantOneHasTheSameBitsAsATableOfIt) {
  const auto constant = simulate_text(kFalling, {"gravity=[0, 0, -9.81 m/s^2]"});
  const auto table = simulate_text(
      kFalling, {"gravity=[0, 0, {table: [[0, -9.81 m/s^2], [1 s, -9.81 m/s^2]], over: time}]"});
  for (const std::string body : {"elements", "particles", "rigid"}) {
    EXPECT_EQ(table.column("body." + body + ".velocity.z"),
              constant.column("body." + body + ".velocity.z"));
  }
  EXPECT_EQ(table.column("energy.boundary"), constant.column("energy.boundary"));
}

TEST(GravityOverTime, IsCarriedByWhatHoldsABodyAndSoIsItsMoment) {
  const auto run = simulate_text(R"deck(
title: A block that is held
time: {end: 20 ms, max_step: 50 us}
materials: {foam: {density: 1000 kg/m^3, elastic: {E: 10 MPa, nu: 0.3}}}
bodies:
  block: {material: foam, size: 10 mm,
    shape: {box: {min: [10 mm, 40 mm, 0], max: [40 mm, 60 mm, 20 mm]}}}
boundaries: {all: {body: block, where: all, fix: [x, y, z]}}
gravity: [0, "= 30*cos(100*t)", {table: [[0, 0], [10 ms, -40 m/s^2]], over: time}]
output: {history: 1 ms}
)deck");
  ;
  ASSERT_EQ(run.failure, "");
  const Real mass = 1000 * 0.03 * 0.02 * 0.02;
  const Vec3 center(0.025, 0.05, 0.01);
  for (std::size_t k = 1; k < run.rows.size(); ++k) {
    const auto at = [&](const std::string& column) { return run.rows[k][run.index(column)]; };
    const Real t = at("time");
    const Vec3 weight = mass * Vec3(0, 30 * std::cos(100 * t), -40 * std::min(1.0, t / 0.01));
    const Vec3 moment = center.cross(-weight);
    for (int c = 0; c < 3; ++c) {
      const std::string axis = std::string(".") + "xyz"[c];
      EXPECT_NEAR(at("boundary.all.reaction" + axis), -weight[c], 1e-12) << t;
      EXPECT_NEAR(at("boundary.all.torque" + axis), moment[c], 1e-13) << t;
    }
  }
  EXPECT_LT(run.worst_drift, 1e-10);
}

TEST(GravityOverTime, PressesOnWhatABodyRestsOn) {
  const auto run = simulate_text(R"(
title: A box on a floor
geometry: plane-strain
time: {end: 100 ms}
materials: {foam: {density: 1000 kg/m^3, elastic: {E: 1 MPa, nu: 0.3}}}
bodies:
  box: {material: foam, shape: {box: {min: [0, 0], max: [40 mm, 20 mm]}}, size: 10 mm}
  floor: {rigid: true, shape: {plane: {origin: [20 mm, 0], normal: y, extent: 100 mm}}}
gravity: [0, {table: [[0, 0], [50 ms, -10 m/s^2]], over: time}]
contact: {default: {damping: 1}}
damping: {rate: 300 1/s}
output: {history: 1 ms}
)");
  ASSERT_EQ(run.failure, "");
  const Real mass = 1000 * 0.04 * 0.02;
  EXPECT_NEAR(run.last("contact.box-floor.force.y") / (mass * 10), 1, 0.01);
  EXPECT_LT(run.worst_drift, 1e-8);
}

}  // namespace
}  // namespace brunt::test
