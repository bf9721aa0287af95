// Sharp rigid bodies of oak, free, fall at 2 m/s without friction on a floor point first, or on
// another of their kind whose edge crosses theirs. What they hit is held, so that they come back
// as they came: their energy is kept (1 %), and while they turn no deeper into it than their edge.
//
// A point of half angle a has no side that opposes a floor better than sin(a), and edges that
// cross have none better than sin(a) sin(b): faces that oppose each other by less than a box's
// edges do, 1/2, must count where bodies are sharp (FacingRamp). tests/cases/chisel-4 and knives-12
// ask for 1 mm at most.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

Simulation fall(const std::string& name, Real half_angle) {
  const Real half_width = 0.05 * std::tan(half_angle * kPi / 180);
  const std::string w = std::to_string(half_width), less = "-" + w;
  std::vector<std::string> overrides;
  if (name == "chisel-4") {
    overrides = {"bodies.up.shape.polygon.points=[[0, 0.001], [" + w + ", 0.051], [" + less +
                 ", 0.051]]"};
  } else {
    const std::string points = "=[[" + less + ", -0.05], [" + w + ", -0.05], [0, 0]]";
    overrides = {"bodies.low.shape.polygon.points" + points,
                 "bodies.up.shape.polygon.points" + points};
  }
  return simulate(
      load_deck(std::string(BRUNT_SOURCE_DIR) + "/tests/cases/" + name + ".yaml", overrides));
}

/// deepest  [m] of the point, which starts 1 mm above
void expect_return(const Simulation& run, Real deepest) {
  ASSERT_EQ(run.failure, "");
  const auto height = run.column("body.up.position.y");
  EXPECT_GT(*std::min_element(height.begin(), height.end()), height.front() - 0.001 - deepest);
  EXPECT_GT(run.last("body.up.velocity.y"), 0);
  EXPECT_LT(std::fabs(run.last("energy.contact.pairs")), 1e-4 * run.first("energy.kinetic"));
}

TEST(Sharp, ChiselsComeBackFromAFloor) {
  for (const Real angle : {2, 4, 12, 30}) {
    SCOPED_TRACE(angle);
    expect_return(fall("chisel-4", angle), 0.001);
  }
}

TEST(Sharp, KnivesThatCrossComeBack) {
  expect_return(fall("knives-12", 12), 0.001);
  for (const Real angle : {17, 30, 45}) {  // heavier, on the same spring
    SCOPED_TRACE(angle);
    expect_return(fall("knives-12", angle), 0.0025);
  }
}

}  // namespace
}  // namespace brunt::test
