// A strip is rolled from thickness h0 to h1 between rolls of radius R (decks/strip-rolling, its
// upper half). Von Karman's slab: the longitudinal force q(phi) = h s over the angle phi from the
// exit follows dq/dphi = -2 R p (sin phi - d mu cos phi), d = 1 before the neutral point, where
// the roll is faster, and -1 behind it; the roll's pressure p and the stress s yield together, s +
// p (1 + d mu tan phi) = k, k = 2/sqrt(3) of the yield stress. q = 0 at both ends; both branches
// meet at the neutral point. Force and torque are the integrals of p and mu p over the arc.
// Sections do not stay plane where the strip is thick (arc over thickness is 2 here), which the
// slab leaves out: 2 %, and a tenth for the exit speed, which leans on where the neutral point
// lies.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

constexpr Real kRadius = 50e-3, kBefore = 4e-3, kAfter = 3e-3;  // [m]
constexpr Real kFlow = 2 / std::numbers::sqrt3 * 100e6;         // [Pa]
constexpr int kParts = 4000;

struct Slab {
  Real force = 0;   ///< [N/m]
  Real torque = 0;  ///< [N]
};

Real thickness(Real phi) { return kAfter + 2 * kRadius * (1 - std::cos(phi)); }

/// dq/dphi; pressure  out [Pa]
Real slope(Real phi, Real q, Real d, Real mu, Real& pressure) {
  pressure = (kFlow - q / thickness(phi)) / (1 + d * mu * std::tan(phi));
  return -2 * kRadius * pressure * (std::sin(phi) - d * mu * std::cos(phi));
}

struct Branch {
  std::vector<Real> q, pressure;
};

/// From one end to the other by the midpoint rule.
Branch branch(Real from, Real to, Real d, Real mu) {
  Branch made;
  const Real step = (to - from) / kParts;
  Real q = 0;
  for (int k = 0; k <= kParts; ++k) {
    const Real phi = from + k * step;
    Real pressure = 0, unused = 0;
    const Real half = q + step / 2 * slope(phi, q, d, mu, pressure);
    made.q.push_back(q), made.pressure.push_back(pressure);
    q += step * slope(phi + step / 2, half, d, mu, unused);
  }
  return made;
}

Slab slab(Real mu) {
  const Real bite = std::acos(1 - (kBefore - kAfter) / (2 * kRadius));
  const Branch behind = branch(0, bite, -1, mu), before = branch(bite, 0, 1, mu);
  Slab sum;
  for (int k = 0; k <= kParts; ++k) {
    const auto here = static_cast<std::size_t>(k), there = static_cast<std::size_t>(kParts - k);
    // Compression grows from both ends to the neutral point: the smaller one holds.
    const bool is_before = before.q[there] > behind.q[here];
    const Real p = is_before ? before.pressure[there] : behind.pressure[here];
    const Real phi = k * bite / kParts, drag = (is_before ? mu : -mu) * p;
    const Real arc = kRadius * bite / kParts * (k == 0 || k == kParts ? 0.5 : 1);
    sum.force += arc * (p * std::cos(phi) + drag * std::sin(phi));
    sum.torque += arc * drag * kRadius;
  }
  return sum;
}

TEST(Rolling, ForceAndTorqueAreThoseOfTheSlab) {
  for (const Real mu : {0.15, 0.2}) {
    SCOPED_TRACE(mu);
    const Slab theory = slab(mu);
    const auto run = simulate_shipped("strip-rolling", {"parameters.mu=" + std::to_string(mu)});
    ASSERT_EQ(run.failure, "");
    EXPECT_LT(run.worst_drift, 1e-10);
    EXPECT_NEAR(-run.measures.at("force"), theory.force, 0.03 * theory.force);
    EXPECT_NEAR(run.measures.at("torque"), theory.torque, 0.03 * theory.torque);
    EXPECT_NEAR(run.measures.at("thinning"), kAfter / kBefore, 0.01 * kAfter / kBefore);
    // The strip leaves faster than the roll turns, and enters more slowly.
    EXPECT_GT(run.measures.at("slip"), 0.02);
    EXPECT_LT(run.measures.at("slip"), 0.06);
  }
}

/// Where friction is less than the tangent of the bite angle, 0.1415, the strip is not drawn in.
TEST(Rolling, TooLittleFrictionDoesNotBite) {
  const auto run = simulate_shipped("strip-rolling",
                                    {"parameters.mu=0.05", "measures=null", "parameters.end=6 ms"});
  ASSERT_EQ(run.failure, "");
  EXPECT_LT(run.column("body.strip.velocity.x").back(), 0.01);
}

}  // namespace
}  // namespace brunt::test
