// The step that the end of a run shortens (docs/decisions/250-last-step.md). An element without
// viscosity rings about its centre: of its kinetic energy a step half as long leaves
// (dt^2 - dt_last^2)/8 m a^2, up to a quarter of all where steps are near their limit. That is no
// energy that the scheme made: none of it is left where the next step is as long as those before.
#include <gtest/gtest.h>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

TEST(LastStep, CreatesNothing) {
  const auto ring = [](const std::string& end) {
    return simulate_text(R"yaml(
title: One undamped element rings
geometry: 3d
time: {max_created: 5 %, end: )yaml" +
                         end + R"yaml(}
materials: {steel: {density: 7850 kg/m^3, elastic: {E: 200 GPa, nu: 0.3}}}
bodies:
  cube:
    material: steel
    shape: {box: {min: [0, 0, 0], max: [10 mm, 10 mm, 10 mm]}}
    size: 10 mm
    element: {bulk_viscosity: {linear: 0, quadratic: 0}}
    velocity: ["= 1000*(x-0.005)", "= 1000*(y-0.005)", "= 1000*(z-0.005)"]
output: {history: 1 us}
)yaml");
  };
  Real most = 0;
  for (const char* end : {"99 us", "99.3 us", "99.6 us", "99.9 us", "100.2 us"}) {
    const auto run = ring(end);
    EXPECT_EQ(run.failure, "") << end;
    EXPECT_LT(run.created, 0.02) << end;  // the first swing shortens the held step once
    most = std::max(most, run.last("energy.created") / run.largest_energy());
  }
  EXPECT_GT(most, 0.1);  // or the test would show nothing
}

}  // namespace
}  // namespace brunt::test
