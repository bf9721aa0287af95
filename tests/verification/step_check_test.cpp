// time.check_step against closed forms of the longest stable step, 2/omega of leapfrog.
//
// A bar of elements h long, nu 0, without bulk viscosity: its lumped masses swing against each
// other with omega = 2c/h, and its elements allow h/c: 1.
//
// Two layers of particles a distance d apart: omega = 2c/d, and the step limit is 0.95 d/c
// (sph/spread.hpp): at least 1, and at most 1/0.95 and what the spread about a particle of the rim
// gives away, some 2 %.
#include <gtest/gtest.h>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

constexpr const char* kBar = R"(
title: A bar that flies
geometry: 3d
time: {end: 2 us, check_step: 5}
materials:
  m: {density: 7850 kg/m^3, elastic: {E: 200 GPa, nu: 0}}
bodies:
  bar:
    material: m
    shape: {box: {min: [0, 0, 0], max: [10 mm, 1 mm, 1 mm]}}
    size: 1 mm
    velocity: [1 m/s, 0, 0]
    element: {bulk_viscosity: {linear: 0, quadratic: 0}}
output: {history: 0.2 us}
)";

TEST(StepCheck, IsOneForABarOfElements) {
  const auto run = simulate_text(kBar);
  ASSERT_EQ(run.step_margins.size(), 1U);
  EXPECT_EQ(run.step_margins[0].first, "bar");
  EXPECT_NEAR(run.step_margins[0].second, 1, 0.004);  // bisection to 0.002
}

// The end is pushed at 60 m/s: stresses of rho c v = 2.4 GPa, where it yields at 0.2.
TEST(StepCheck, ChangesNoBit) {
  const std::vector<std::string> yields = {
      "materials.m.strength={j2: {yield: 200 MPa, hardening: 1 GPa}}", "time.end=3 us",
      "time.check_step=10",
      "boundaries={end: {body: bar, where: {side: min-x}, velocity: [60 m/s, 0, 0]}}"};
  auto without = yields;
  without.emplace_back("time.check_step=0");
  for (const char* method : {"fe", "sph"}) {
    auto checked = yields, plain = without;
    if (std::string(method) == "sph") {
      for (auto* all : {&checked, &plain}) {
        all->emplace_back(
            "bodies.bar={method: sph, material: m, size: 0.5 mm, "
            "shape: {box: {min: [0, 0, 0], max: [10 mm, 1 mm, 1 mm]}}}");
      }
    }
    const auto a = simulate_text(kBar, checked), b = simulate_text(kBar, plain);
    EXPECT_EQ(a.hashes, b.hashes) << method;
    EXPECT_FALSE(a.step_margins.empty());
    EXPECT_TRUE(b.step_margins.empty());
  }
}

TEST(StepCheck, KnowsTwoLayersOfParticles) {
  const auto run = simulate_text(
      kBar, {"bodies.bar={method: sph, material: m, size: 1 mm, viscosity: {alpha: 0, beta: 0}, "
             "shape: {box: {min: [0, 0, 0], max: [10 mm, 10 mm, 2 mm]}}}",
             "time.end=0.1 us", "output.history=0.1 us"});
  ASSERT_EQ(run.step_margins.size(), 1U);
  EXPECT_GT(run.step_margins[0].second, 1);
  EXPECT_LT(run.step_margins[0].second, 1.02 / 0.95 + 0.004);
}

// Hourglass control of 2,000 times its usual stiffness is what no step limit counts with.
TEST(StepCheck, WarnsOfWhatTheStepLimitDoesNotKnow) {
  const auto run = simulate_text(kBar, {"bodies.bar.element.hourglass.stiffness=100",
                                        "time.end=0.05 us", "bodies.bar.velocity=[0, 0, 0]"});
  ASSERT_EQ(run.step_margins.size(), 1U);
  EXPECT_LT(run.step_margins[0].second, 0.5);
  ASSERT_FALSE(run.reported.empty());
  EXPECT_EQ(run.reported[0].id, "time.check_step");
}

}  // namespace
}  // namespace brunt::test
