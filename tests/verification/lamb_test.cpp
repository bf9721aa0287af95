// Lamb's problem (Lamb 1904): a line force Q(t) on the surface of a half-space, nu = 0.25, sends a
// Rayleigh wave along it that neither spreads nor changes:
//   u_x = H/mu Q(t - x/c_R), |H| = 0.12500, c_R = 0.9194 c_s.
// c_R is the root of F, and H its residue, all over the wavenumber of the Rayleigh wave:
//   F(s) = (2 s^2 - k^2)^2 - 4 s^2 sqrt(s^2 - h^2) sqrt(s^2 - k^2),  k = c_R/c_s, h = c_R/c_p,
//   H = -(2 - k^2 - 2 sqrt(1 - h^2) sqrt(1 - k^2))/F'(1).
// The pulse is Ricker's of 100 Hz, 27 elements to its wave. 1 % of the arrival and 3 % of the
// amplitude, the gates; elements of 2 m err by 1.6 % and 12 %, of 1 m by 0.5 % and 1 %.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

constexpr Real kMu = 24e9, kDensity = 2650;

/// Rayleigh's function of s, k and h over the wavenumber.
Real rayleigh(Real s, Real k, Real h) {
  const Real a = 2 * s * s - k * k;
  return a * a - 4 * s * s * std::sqrt(s * s - h * h) * std::sqrt(s * s - k * k);
}

/// c_R over c_s, by bisection, lambda = mu.
Real speed_over_shear() {
  Real low = 0.5, high = 0.99;
  for (int i = 0; i < 60; ++i) {
    const Real middle = 0.5 * (low + high);
    const bool beyond = rayleigh(1, middle, middle / std::sqrt(3.0)) < 0;
    (beyond == (rayleigh(1, low, low / std::sqrt(3.0)) < 0) ? low : high) = middle;
  }
  return low;
}

TEST(Lamb, ASurfaceWaveHasItsSpeedAndItsAmplitude) {
  const auto run = simulate_text(R"deck(
title: A line force on rock
geometry: plane-strain
time: {end: 85 ms}
materials: {rock: {density: 2650 kg/m^3, elastic: {E: 60 GPa, nu: 0.25}}}
bodies:
  rock:
    material: rock
    shape: {box: {min: [0, -90 m], max: [200 m, 0]}}
    size: 1 m
    element: {bulk_viscosity: {linear: 0}}
symmetry: {x: 0}
boundaries:
  source:
    body: rock
    where: {box: {min: [-0.1, -0.1], max: [0.1, 0.1]}}
    force: [0, "= -5e8*(1 - 2*(pi*100*(t - 0.015))^2)*exp(-(pi*100*(t - 0.015))^2)"]
  bottom: {body: rock, where: {side: min-y}, nonreflecting: true}
  far: {body: rock, where: {side: max-x}, nonreflecting: true}
probes:
  near: {body: rock, at: [120 m, 0], fields: [displacement.x]}
  far: {body: rock, at: [170 m, 0], fields: [displacement.x]}
output: {history: 50 us}
)deck");
  ASSERT_EQ(run.failure, "");
  const Real k = speed_over_shear(), h = k / std::sqrt(3.0), d = 1e-5;
  const Real slope = (rayleigh(1 + d, k, h) - rayleigh(1 - d, k, h)) / (2 * d);
  const Real H = -(2 - k * k - 2 * std::sqrt(1 - h * h) * std::sqrt(1 - k * k)) / slope;
  ASSERT_NEAR(k, 0.9194, 1e-4);
  ASSERT_NEAR(H, 0.125, 1e-4);
  const Real speed = k * std::sqrt(kMu / kDensity), height = H * 1e9 / kMu;
  const auto time = run.column("time");
  for (const auto& [name, x] : {std::pair{"near", 120.0}, std::pair{"far", 170.0}}) {
    const auto u = run.column(std::string("probe.") + name + ".displacement.x");
    const auto peak = std::min_element(u.begin(), u.end()) - u.begin();
    EXPECT_NEAR(time[static_cast<std::size_t>(peak)] - 0.015, x / speed, 0.01 * x / speed) << name;
    EXPECT_NEAR(-u[static_cast<std::size_t>(peak)], height, 0.03 * height) << name;
  }
  EXPECT_LT(run.worst_drift, 1e-7);  // of what the force puts in and takes out again, 30 times more
}

}  // namespace
}  // namespace brunt::test
