// A thin elastic disc that is set spinning at once, without stress: it breathes about the radius
// that it would have at rest under its centrifugal forces. Plane stress (Timoshenko & Goodier,
// Theory of Elasticity, art. 32):
//   u(R) = (1 - nu) rho w^2 R^3/(4 E)
// The first mode has the period 2 pi R/(2.049 c), c^2 = E/(rho (1 - nu^2)): 2.049 is the root of
// x J0(x) = (1 - nu) J1(x), nu = 0.3. Its mean over eight periods is u, to the 3 % of the gate;
// other modes, which a sudden start has too, and 20 elements to a radius leave 0.1 %.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

TEST(SpinningDisc, GrowsByItsCentrifugalForces) {
  const auto run = simulate_text(R"(
title: A disc that spins
geometry: 3d
time: {end: 0.47 ms}
materials: {steel: {density: 7850 kg/m^3, elastic: {E: 200 GPa, nu: 0.3}}}
bodies:
  disc:
    material: steel
    shape: {cylinder: {radius: 100 mm, length: 5 mm, base: [0, 0, 0], axis: z}}
    size: 5 mm
    spin: {axis: z, rate: 1000 rad/s}
probes:
  rim: {body: disc, at: [100 mm, 0, 2.5 mm], fields: [displacement.x, displacement.y]}
output: {history: 1 us}
)");
  ASSERT_EQ(run.failure, "");
  constexpr Real kE = 200e9, kNu = 0.3, kRho = 7850, kR = 0.1, kSpin = 1000;
  const Real speed = std::sqrt(kE / kRho / (1 - kNu * kNu));
  const Real periods = 8 * 2 * kPi * kR / (2.049 * speed);
  const auto time = run.column("time"), x = run.column("probe.rim.displacement.x");
  const auto y = run.column("probe.rim.displacement.y");
  Real sum = 0, last = 0;
  for (std::size_t k = 1; k < time.size() && time[k] <= periods; ++k) {
    sum += (std::hypot(kR + x[k], y[k]) - kR) * (time[k] - time[k - 1]);
    last = time[k];
  }
  const Real grown = (1 - kNu) * kRho * kSpin * kSpin * kR * kR * kR / (4 * kE);
  EXPECT_NEAR(last, periods, 2e-6);
  EXPECT_NEAR(sum / last, grown, 0.01 * grown);
  EXPECT_LT(run.worst_drift, 1e-12);
}

}  // namespace
}  // namespace brunt::test
