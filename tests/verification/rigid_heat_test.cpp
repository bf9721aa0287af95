// Rigid bodies and heat. A rod of which one half is rigid: what it conducts
// is what the elements of a half that is fixed conduct. A rigid surface without material is held
// at its temperature: q = dT/(L/k + 1/h), and all of it leaves the scene.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

const std::vector<std::string> kRigidSteel = {"bodies.steel.rigid=true",
                                              "bodies.steel.motion={velocity: [0, 0, 0]}",
                                              "boundaries.steel_still=null"};

std::vector<std::string> with(std::vector<std::string> overrides, const std::string& more) {
  overrides.push_back(more);
  return overrides;
}

// The same elements at the same temperatures: the same numbers to rounding, and 0.5 % of the rod's
// flux as for any.
TEST(RigidHeat, ARigidHalfConductsLikeAFixedOne) {
  const auto rigid = simulate_shipped("composite-rod", kRigidSteel);
  const auto fixed = simulate_shipped("composite-rod");
  ASSERT_EQ(rigid.failure, "");
  const Real flux = 100 / (0.05 / 237 + 1e-4 + 0.05 / 44.5);
  EXPECT_NEAR(rigid.last("contact.aluminium-steel.heat_rate"), -flux * 25e-6, 5e-3 * flux * 25e-6);
  EXPECT_NEAR(rigid.measures.at("behind"), fixed.measures.at("behind"), 1e-6);
  EXPECT_NEAR(rigid.last("body.steel.heat"), fixed.last("body.steel.heat"),
              1e-6 * fixed.last("body.steel.heat"));
  EXPECT_LT(std::fabs(rigid.last("heat.drift")), 1e-12);
  EXPECT_EQ(rigid.last("body.steel.mass"), 0);
}

TEST(RigidHeat, AMotionHoldsItsTemperature) {
  const auto held = simulate_shipped(
      "composite-rod", {"bodies.steel={rigid: true, motion: {temperature: 0 degC}, shape: {box: "
                        "{min: [0, 0, 0], max: [$length, $width, $width]}}, size: $size}",
                        "boundaries.steel_still=null", "boundaries.cold=null",
                        "materials.steel=null", "measures.behind=null"});
  ASSERT_EQ(held.failure, "");
  const Real rate = 100 / (0.05 / 237 + 1e-4) * 25e-6;
  EXPECT_NEAR(held.last("contact.aluminium-steel.heat_rate"), -rate, 5e-3 * rate);
  EXPECT_NEAR(held.last("boundary.steel.motion.heat_rate"), -rate, 5e-3 * rate);
  EXPECT_LT(std::fabs(held.last("heat.drift")), 1e-12);
  // What would conduct is held as a whole, which is as if its surface were.
  const auto whole = simulate_shipped(
      "composite-rod", {"bodies.steel.rigid=true", "bodies.steel.motion={temperature: 0 degC}",
                        "boundaries.steel_still=null", "boundaries.cold=null"});
  ASSERT_EQ(whole.failure, "");
  EXPECT_NEAR(whole.last("contact.aluminium-steel.heat_rate"), -rate, 5e-3 * rate);
}

// A block slides over a rigid steel block that has a prescribed motion and conducts: friction heats
// both, and heat adds up. Bits are those of any threads, skin and restart.
TEST(RigidHeat, AMovingToolIsWarmedByFriction) {
  const auto overrides =
      with({"time.end=20 us", "materials.aluminium.strength=null", "bodies.plate.rigid=true",
            "bodies.plate.motion={velocity: [-5 m/s, 0, 1 m/s]}", "measures=null"},
           "bodies.plate.size=2 mm");
  const auto run = simulate_shipped("hot-block", overrides, {.threads = 1});
  ASSERT_EQ(run.failure, "");
  EXPECT_GT(run.last("heat.friction"), 0);
  EXPECT_NEAR(run.last("heat.friction"), run.last("energy.contact.friction"),
              1e-10 * run.last("energy.contact.friction"));
  EXPECT_GT(run.last("body.plate.heat"), 0);
  for (const Real drift : run.column("heat.drift")) EXPECT_LT(std::fabs(drift), 1e-12);
  EXPECT_LT(run.worst_drift, 1e-9);
  const auto split = simulate_shipped("hot-block", overrides, {.threads = 2, .split_at = 30});
  EXPECT_EQ(split.rows, run.rows);
  EXPECT_EQ(split.hashes, run.hashes);
  EXPECT_EQ(simulate_shipped("hot-block", with(overrides, "contact.skin=3 mm")).hashes, run.hashes);
}

}  // namespace
}  // namespace brunt::test
