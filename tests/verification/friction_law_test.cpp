// Friction that depends on temperature, flow stress, pressure and speed, in closed form: the block
// of decks/block-on-incline on level ground, at v = 1 m/s, m g its weight, h its height, rho its
// density. Its weight swings on its springs, which 1e-3 of a speed or a way is for. The springs are
// damped, or it leaves the ground for moments, and books of friction that ends and begins anew are
// 0.6 % of its energy.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

constexpr Real kGravity = 9.81, kSpeed = 1, kHeight = 0.04, kDensity = 1000;

std::vector<std::string> level(const std::string& friction, const std::string& end,
                               std::vector<std::string> more = {}) {
  more.insert(more.end(), {"parameters.angle=0 deg", "parameters.end=" + end, "measures=null",
                           "parameters.mu=null", "contact.default.damping=0.5",
                           "contact.default.friction=" + friction});
  return more;
}

void expect_balance(const Simulation& run) {
  ASSERT_EQ(run.failure, "");
  EXPECT_LT(run.worst_drift, 1e-10);
  EXPECT_LT(std::fabs(run.last("energy.contact.pairs")), 1e-3 * run.largest_energy());
}

Real way(const Simulation& run) {
  return run.last("body.block.position.x") - run.first("body.block.position.x");
}

// mu over the mean temperature of both surfaces, 400 K and 300 K: mu(350 K) = 0.25, and s = v t -
// mu g t^2 / 2. Elements and particles.
TEST(FrictionLaw, BlockIsSlowedByTheFrictionOfItsTemperature) {
  for (const char* method : {"fe", "sph"}) {
    const auto run = simulate_shipped(
        "block-on-incline",
        level("{table: [[300 K, 0.1], [400 K, 0.4]], over: temperature}", "0.2 s",
              {std::string("bodies.block.method=") + method, "bodies.block.temperature=400 K",
               "bodies.incline.temperature=300 K"}));
    expect_balance(run);
    const Real expected = kSpeed * 0.2 - 0.25 * kGravity * 0.04 / 2;
    EXPECT_NEAR(way(run), expected, 1e-3 * expected) << method;
  }
}

// mu = a + b v: v' = -g (a + b v), so v = (v0 + a/b) exp(-b g t) - a/b.
TEST(FrictionLaw, BlockIsSlowedByFrictionOfItsSpeed) {
  const auto run = simulate_shipped("block-on-incline", level("'= 0.1 + 0.2 * v'", "0.2 s"));
  expect_balance(run);
  const Real a = 0.1, b = 0.2;
  const Real expected = (kSpeed + a / b) * std::exp(-b * kGravity * 0.2) - a / b;
  EXPECT_NEAR(run.last("body.block.velocity.x"), expected, 2e-3 * expected);
}

// mu = c/p: a traction c whatever presses, so v' = -c/(rho h).
TEST(FrictionLaw, BlockIsSlowedByAConstantTraction) {
  const auto run = simulate_shipped("block-on-incline", level("'= 100 / p'", "0.2 s"));
  expect_balance(run);
  const Real expected = kSpeed - 100 / (kDensity * kHeight) * 0.2;
  EXPECT_NEAR(run.last("body.block.velocity.x"), expected, 2e-3 * expected);
}

// mu falls by b = 1 %/K of the mean of both surfaces, from mu0 = 0.3, and all heat of friction goes
// to the block, whose conductivity keeps it at one temperature: T - T0 = (v0^2 - v^2)/(2 cp). The
// plate stays at T0. With c = b/(4 cp) and A = 1 - c v0^2
//   v' = -g mu0 (A + c v^2),  v = sqrt(A/c) tan(atan(v0 sqrt(c/A)) - g mu0 sqrt(A c) t).
// Its surface is warmer than its mean by q h/(3 k) = 0.03 K of 50 K.
TEST(FrictionLaw, FrictionThatWarmsItselfFalls) {
  const auto run = simulate_shipped(
      "block-on-incline",
      level("{table: [[293.15 K, 0.3], [393.15 K, 0]], over: temperature}", "0.3 s",
            {"heat=conduct", "ambient=293.15 K",
             "materials.rubber.thermal={cp: 0.005 J/kg/K, k: 50 W/m/K}"}));
  expect_balance(run);
  const Real c = 0.01 / (4 * 0.005), A = 1 - c * kSpeed * kSpeed;
  const Real v = std::sqrt(A / c) * std::tan(std::atan(kSpeed * std::sqrt(c / A)) -
                                             kGravity * 0.3 * std::sqrt(A * c) * 0.3);
  EXPECT_NEAR(run.last("body.block.velocity.x"), v, 5e-3 * v);
  EXPECT_NEAR(run.last("heat.friction"), run.last("energy.contact.friction"),
              1e-10 * run.last("energy.contact.friction"));
  EXPECT_LT(std::fabs(run.last("heat.drift")), 1e-12);
}

// decks/sliding-blocks: elements and particles on a plate that carries yield/sqrt(3) and no more,
// exactly, as soon as all of the block's area is pressed; friction over temperature as above.
TEST(FrictionLaw, ASoftPlateCarriesItsShearStrength) {
  for (const char* method : {"sph", "fe"}) {
    const auto run = simulate_shipped(
        "sliding-blocks", {std::string("bodies.limited.method=") + method, "parameters.end=6 ms"});
    expect_balance(run);
    const Real limit = 10e3 / std::sqrt(3.0) * 0.08 * 0.04;
    EXPECT_NEAR(run.last("contact.limited.force.x"), -limit, 1e-3 * limit) << method;
    // Elements lift an edge of the block now and then, and with it part of the area.
    EXPECT_NEAR(run.measures.at("limited"), -limit, 1e-2 * limit) << method;
    EXPECT_NEAR(run.measures.at("tabled"), 0.25, 0.005);
    EXPECT_LT(std::fabs(run.last("heat.drift")), 1e-12);
  }
}

// A coefficient that falls below 0 on the way stops the run, at its place.
TEST(FrictionLaw, ACoefficientBelowZeroStopsTheRun) {
  const auto run = simulate_shipped("block-on-incline", level("'= v > 0.9 ? 0.3 : -0.1'", "0.2 s"));
  EXPECT_NE(run.failure.find("contact block-incline at ("), std::string::npos) << run.failure;
  EXPECT_NE(run.failure.find("coefficient of friction = -0.1"), std::string::npos) << run.failure;
  EXPECT_NE(run.failure.find("it must be at least 0, and is found at T = "), std::string::npos);
}

}  // namespace
}  // namespace brunt::test
