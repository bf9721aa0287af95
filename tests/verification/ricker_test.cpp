// A plane pulse of rock, (1 - 2 a) exp(-a), a = (pi f (t - t0))^2 (Ricker 1953), of which one
// wavelength c/f is 20 elements: it passes 50 m on at t0 + 50 m/c as it left, to 1 % of the time
// and 3 % of its height, the gate (measured 0.15 % and 1.8 %: the mesh disperses what is shorter).
// c^2 = E (1 - nu)/((1 + nu)(1 - 2 nu) rho).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

TEST(Ricker, APlanePulseKeepsItsTimeAndHeight) {
  const auto run = simulate_text(R"deck(
title: A pulse in rock
geometry: plane-strain
time: {end: 22 ms}
materials: {rock: {density: 2650 kg/m^3, elastic: {E: 60 GPa, nu: 0.25}}}
bodies:
  rock:
    material: rock
    shape: {box: {min: [0, 0], max: [100 m, 1 m]}}
    size: 0.5 m
    element: {bulk_viscosity: {linear: 0}}
boundaries:
  across: {body: rock, where: all, fix: [y]}
  source:
    body: rock
    where: {side: min-x}
    velocity: ["= (1 - 2*(pi*500*(t - 0.004))^2)*exp(-(pi*500*(t - 0.004))^2)", 0]
    to: 8 ms
  far: {body: rock, where: {side: max-x}, nonreflecting: true}
probes:
  on: {body: rock, at: [50 m, 0.5 m], fields: [velocity.x]}
output: {history: 20 us}
)deck");
  ASSERT_EQ(run.failure, "");
  const Real speed = std::sqrt(60e9 * 0.75 / (1.25 * 0.5 * 2650));
  const auto v = run.column("probe.on.velocity.x"), time = run.column("time");
  const auto top = std::max_element(v.begin(), v.end()) - v.begin();
  EXPECT_NEAR(time[static_cast<std::size_t>(top)] - 0.004, 50 / speed, 0.01 * 50 / speed);
  EXPECT_NEAR(v[static_cast<std::size_t>(top)], 1, 0.03);
  for (std::size_t k = 0; k < time.size(); ++k) {
    if (time[k] < 0.008 + 50 / speed) continue;
    EXPECT_LT(std::fabs(v[k]), 1e-3) << time[k];
  }
  EXPECT_LT(run.worst_drift, 1e-10);
}

}  // namespace
}  // namespace brunt::test
