/// A plate that is held at one end starts with the velocity of its first mode, an expression of the
/// place (Gray, Monaghan & Swift 2001): L 0.2, H 0.02 m, K 3.25 MPa, G 0.715 MPa,
/// rho 1000 kg/m^3. The thin plate's period in plane strain is 0.2541 s; shear and rotary inertia
/// make it 1 to 3 % longer at H/L = 0.1, and a deflection of a tenth of L a little more:
/// 0 to 8 % is the gate.
///   v = a (cosh kx - cos kx - 0.7341 (sinh kx - sin kx))/2, k L = 1.8751, a = 0.01 sqrt(K/rho)
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

Simulation swinging_plate(const std::string& body) {
  return simulate_text(R"deck(
title: A plate that swings
geometry: plane-strain
time: {end: 0.3 s}
materials:
  rubber: {density: 1000 kg/m^3, elastic: {K: 3.25 MPa, G: 0.715 MPa}}
bodies:
  plate:
    material: rubber
    shape: {box: {min: [0, -10 mm], max: [200 mm, 10 mm]}}
    velocity:
      - 0
      - "= 0.285 * (cosh(9.3755*x) - cos(9.3755*x) - 0.7341 * (sinh(9.3755*x) - sin(9.3755*x)))"
    )deck" + body + R"deck(
boundaries:
  held: {body: plate, where: {side: min-x}, fix: [x, y]}
probes:
  tip: {body: plate, at: [199.9 mm, 0], fields: [displacement.y, velocity.y]}
output: {every: 1 s, history: 0.5 ms}
)deck");
}

TEST(OscillatingPlate, StartsWithAVelocityOfThePlace) {
  const auto run = swinging_plate("cells: [40, 4]");
  EXPECT_EQ(run.failure, "");
  EXPECT_NEAR(run.first("probe.tip.velocity.y"), 0.570, 0.003);
  const auto deflection = run.column("probe.tip.displacement.y");
  Real period = 0;
  for (std::size_t k = 10; k + 1 < deflection.size() && period == 0; ++k) {
    if (deflection[k] < 0 && deflection[k + 1] >= 0) {
      period = 5e-4 * (static_cast<Real>(k) - deflection[k] / (deflection[k + 1] - deflection[k]));
    }
  }
  EXPECT_GT(period / 0.2541, 1.0);
  EXPECT_LT(period / 0.2541, 1.08);
  EXPECT_LT(run.worst_drift, 1e-9);
}

}  // namespace
}  // namespace brunt::test
