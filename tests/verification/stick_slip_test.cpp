// A block pulled through a spring. A rigid sled lies on
// the block, presses it by its weight and moves on at V; it holds the block by the springs of their
// contact, which are soft and do not slip (mu = 2). The block sticks to the floor until they carry
// mu N, N the weight of both; from then on it follows the sled, and they carry mu N: to 1 %, the
// page's. A mass that begins to slip at once would swing by V sqrt(K m) about it, 0.5 %; edges that
// begin before the rest make it less. Springs are damped, or a block of elements flutters at such
// a speed.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/materials.hpp"
#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

constexpr Real kGravity = 9.81, kMu = 0.3, kSpeed = 0.5e-3;

const std::string kDeck =
    kRubber + R"(  heavy: {density: 12500 kg/m^3, elastic: {E: 10 MPa, nu: 0.3}}
title: a block is pulled through a spring
parameters: {v: 0.5 mm/s}
time: {end: 1.4 s}
damping: {rate: 200 1/s, until: 0.2 s}
contact:
  default: {friction: 0.3, damping: 0.5}
  pairs:
    spring: {between: [block, sled], friction: 2, stiffness: 0.005}
output: {history: 5 ms}
)";
const char* const kInPlane = R"(
geometry: plane-strain
gravity: [0, -9.81 m/s^2]
bodies:
  block:
    material: rubber
    shape: {box: {min: [-50 mm, 0], max: [50 mm, 40 mm]}}
    size: 20 mm
  sled:
    rigid: true
    material: heavy
    shape: {box: {min: [-60 mm, 40 mm], max: [60 mm, 60 mm]}}
    motion: {velocity: [$v, free]}
)";
const char* const kInSpace = R"(
geometry: 3d
gravity: [0, 0, -9.81 m/s^2]
bodies:
  block:
    material: rubber
    shape: {box: {min: [-50 mm, -50 mm, 0], max: [50 mm, 50 mm, 40 mm]}}
    size: 20 mm
  sled:
    rigid: true
    material: heavy
    shape: {box: {min: [-60 mm, -60 mm, 40 mm], max: [60 mm, 60 mm, 60 mm]}}
    motion: {velocity: [$v, 0, free]}
)";

void expect_stick_slip(const std::string& scene, Real mass, const char* method) {
  SCOPED_TRACE(method);
  const auto run = simulate_text(kDeck + scene, {std::string("bodies.block.method=") + method});
  ASSERT_EQ(run.failure, "");
  EXPECT_LT(run.worst_drift, 1e-10);
  const Real limit = kMu * mass * kGravity;
  const auto time = run.column("time"), spring = run.column("contact.spring.force.x"),
             rubbed = run.column("energy.contact.friction"),
             x = run.column("body.block.position.x");
  // Between the sled and the middle of the block: of the rise from 0.2 s to 0.4 s.
  const std::size_t a = 40, b = 80;
  ASSERT_LT(spring[b], 0.8 * limit);
  const Real K = (spring[b] - spring[a]) / (kSpeed * (time[b] - time[a]) - (x[b] - x[a]));  // [N/m]
  EXPECT_LT(rubbed[b], 1e-3 * limit * limit / K);
  std::size_t onset = b;
  while (onset < time.size() && spring[onset] < 0.99 * limit) ++onset;
  ASSERT_LT(onset, time.size() * 2 / 3);
  for (std::size_t i = b; i < time.size(); ++i) {
    ASSERT_LT(spring[i], 1.01 * limit) << time[i];
    ASSERT_GT(spring[i], i >= onset ? 0.99 * limit : 0.0) << time[i];
  }
  // It follows the sled, mu N/K behind, and rubs mu N V.
  EXPECT_NEAR(x.back() - x.front(), kSpeed * time.back() - limit / K, 0.01 * limit / K);
  const std::size_t late = time.size() * 3 / 4;
  const Real way = kSpeed * (time.back() - time[late]);
  EXPECT_NEAR(rubbed.back() - rubbed[late], limit * way, 0.01 * limit * way);
}

TEST(StickSlip, PulledBlockSlipsAtTheCoulombForceInThePlane) {
  const Real mass = 1000 * 0.1 * 0.04 + 12500 * 0.12 * 0.02;
  const std::string face = R"(
  floor: {rigid: true, shape: {plane: {origin: [0, 0], normal: y, extent: 1 m}}}
)";
  for (const char* method : {"fe", "sph"}) expect_stick_slip(kInPlane + face, mass, method);
  expect_stick_slip(std::string(kInPlane) + R"(
  floor:
    material: rubber
    shape: {box: {min: [-75 mm, -20 mm], max: [75 mm, 0]}}
    size: [30 mm, 20 mm]
boundaries: {held: {body: floor, where: {side: min-y}, fix: [x, y]}}
)",
                    mass, "fe");
}

TEST(StickSlip, PulledBlockSlipsAtTheCoulombForceInSpace) {
  const Real mass = 1000 * 0.1 * 0.1 * 0.04 + 12500 * 0.12 * 0.12 * 0.02;
  const std::string face = R"(
  floor: {rigid: true, shape: {plane: {origin: [0, 0, 0], normal: z, extent: 1 m}}}
)";
  for (const char* method : {"fe", "sph"}) expect_stick_slip(kInSpace + face, mass, method);
}

}  // namespace
}  // namespace brunt::test
