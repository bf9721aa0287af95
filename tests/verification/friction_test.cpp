// Coulomb's block on an incline, the shipped deck: it
// slides with g (sin a - mu cos a) where tan a > mu = 0.3 and stays where tan a < mu. Its speed of
// 1 m/s keeps it sliding while its weight comes on to its springs; the way in 0.5 s is then v t +
// a t^2 / 2 but for the springs' own 10 um, 1e-4 of a t^2 / 2.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

constexpr Real kGravity = 9.81, kMu = 0.3, kEnd = 0.5;

Real acceleration(const Simulation& run, const char* up) {
  const auto way = [&](const char* axis) {
    const std::string column = std::string("body.block.position.") + axis;
    return run.last(column) - run.first(column);
  };
  return 2 * (std::hypot(way("x"), way(up)) - kEnd) / (kEnd * kEnd);
}

Real closed_form(Real degrees) {
  const Real angle = degrees * kPi / 180;
  return kGravity * (std::sin(angle) - kMu * std::cos(angle));
}

void expect_balance(const Simulation& run) {
  ASSERT_EQ(run.failure, "");
  EXPECT_LT(run.worst_drift, 1e-10);
  EXPECT_LT(std::fabs(run.last("energy.contact.pairs")), 1e-3 * run.largest_energy());
}

TEST(Incline, HexesSlideAsCoulombSays) {
  for (const Real angle : {20.0, 30.0, 35.0}) {
    const auto run = simulate_shipped("block-on-incline",
                                      {"parameters.angle=" + std::to_string(angle) + " deg"});
    expect_balance(run);
    EXPECT_NEAR(acceleration(run, "z"), closed_form(angle), 1e-3 * closed_form(angle)) << angle;
  }
}

TEST(Incline, QuadsSlideAsCoulombSays) {
  const auto run = simulate_shipped(
      "block-on-incline", {"geometry=plane-strain", "gravity=[0, -9.81 m/s^2]",
                           "bodies.block.velocity=[0.8660254037844387 m/s, -0.5 m/s]",
                           "bodies.block.shape={box: {min: [-50 mm, 0], max: [50 mm, 40 mm]}, "
                           "rotate: {angle: -$angle, about: [0, 0]}}",
                           "bodies.incline.shape={plane: {origin: [0, 0], normal: y, extent: 2 m}, "
                           "rotate: {angle: -$angle, about: [0, 0]}}",
                           "measures.height.history.column=body.block.position.y"});
  expect_balance(run);
  EXPECT_NEAR(acceleration(run, "y"), closed_form(30), 1e-3 * closed_form(30));
}

TEST(Incline, ParticlesSlideAsCoulombSays) {
  const auto run =
      simulate_shipped("block-on-incline", {"bodies.block.method=sph", "parameters.size=20 mm"});
  expect_balance(run);
  EXPECT_NEAR(acceleration(run, "z"), closed_form(30), 1e-2 * closed_form(30));
}

// At 15 degrees it stays: once it has settled it moves by less than 1e-4 mm in 1 s.
TEST(Incline, BlockStaysUnderTheAngleOfFriction) {
  for (const char* method : {"fe", "sph"}) {
    const auto run = simulate_shipped(
        "block-on-incline",
        {"parameters.angle=15 deg", "parameters.speed=0 m/s", "parameters.end=1.2 s",
         "damping={rate: 200 1/s, until: 0.2 s}", std::string("bodies.block.method=") + method});
    expect_balance(run);
    const auto time = run.column("time"), x = run.column("body.block.position.x");
    const std::size_t settled = time.size() / 6;  // 0.2 s
    EXPECT_LT(std::fabs(x.back() - x[settled]), 1e-7) << method;
    EXPECT_LT(run.last("energy.kinetic"), 1e-18) << method;
  }
}

// Four bricks at rest on a slope: each joint carries N = n m g cos(angle) and T = n m g sin(angle)
// of the n bricks above it, m = 1900 kg/m^3 0.2 m 0.1 m 0.06 m. Their motion has died away by e^-20
// of damping, so that nothing but rounding is left of it.
TEST(BrickStack, JointsCarryTheWeightAboveThem) {
  const auto run = simulate_shipped("brick-stack");
  expect_balance(run);
  const Real m = 1900 * 0.2 * 0.1 * 0.06, angle = 15 * kPi / 180;
  const char* joints[] = {"third-fourth", "second-third", "first-second", "first-floor"};
  for (int n = 1; n <= 4; ++n) {
    const std::string column = std::string("contact.") + joints[n - 1] + ".force.";
    const Real sign = n == 4 ? -1 : 1;  // forces are those on the first of the two
    const Real weight = sign * n * m * kGravity;
    EXPECT_NEAR(run.last(column + "x"), weight * std::sin(angle), 1e-6 * m * kGravity) << n;
    EXPECT_NEAR(run.last(column + "z"), -weight * std::cos(angle), 1e-6 * m * kGravity) << n;
  }
}

}  // namespace
}  // namespace brunt::test
