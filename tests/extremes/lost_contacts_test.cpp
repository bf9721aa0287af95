// Contacts that do not hold are reported where they begin to spoil the answer, and only there.
//
// A particle of radius r on a rigid face has k d up to d = r and b (d - r)^3 / r^2 more behind it,
// with k = phi M per breadth and b = 16 k (contact/geometry/particle_face.hpp), and is given up n
// radii behind, n = 3, or 6 of an open surface. Until there the spring takes, with d = (n + 1) r,
//   E = k r^2 ((n + 1)^2/2 + 4 n^4) = 332 k r^2, 5208.5 k r^2,
// of a square particle of mass 4 rho r^2 and speed v: v^2 = c^2 phi ((n + 1)^2/4 + 2 n^4),
// v = 12.88 c sqrt(phi), 51.03 c sqrt(phi). Slower ones come back.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

// rho = 1000 kg/m^3, M = 10 MPa: c = 100 m/s.
const std::string kHead = R"(
geometry: plane-strain
parameters: {speed: 100 m/s, end: 0.3 ms, phi: 0.5, longest: 1 ms}
time: {end: $end, max_step: $longest, max_created: 0.5}
materials:
  soft: {density: 1000 kg/m^3, elastic: {E: 10 MPa, nu: 0}}
output: {history: 1 us}
)";
const std::string kShot = kHead + R"(
title: a particle on a rigid face
contact: {default: {friction: 0, damping: 0, stiffness: $phi}}
bodies:
  shot:
    method: sph
    smoothing: 1.2
    material: soft
    shape: {box: {min: [-0.5 mm, 0.1 mm], max: [0.5 mm, 1.1 mm]}}
    size: 1 mm
    velocity: [0, = -$speed]
  wall:
    rigid: true
)";
const std::string kBox =
    "    shape: {box: {min: [-20 mm, -40 mm], max: [20 mm, 0]}}\n"
    "    size: 40 mm\n";
const std::string kPlane = "    shape: {plane: {origin: [0, 0], normal: y, extent: 40 mm}}\n";
const std::string kBlocks = kHead + R"(
title: blocks that meet fast
contact: {default: {friction: 0, stiffness: $phi}}
bodies:
  flying:
    material: soft
    shape: {box: {min: [3 mm, 0.3 mm], max: [13 mm, 6.3 mm]}}
    size: 1 mm
    element: {hourglass: {stiffness: 0.05}}  # so soft that corners fold
    velocity: [0, = -$speed]
  standing:
    material: soft
    shape: {box: {min: [0, -6 mm], max: [16 mm, 0]}}
    size: 1 mm
    element: {hourglass: {stiffness: 0.05}}  # so soft that corners fold
)";

std::string speed_text(Real speed) { return "parameters.speed=" + std::to_string(speed) + " m/s"; }

void expect_told_from(const std::string& wall, Real radii) {
  const Real phi = 0.01,
             bound =
                 100 * std::sqrt(phi * (0.25 * std::pow(radii + 1, 2) + 2 * std::pow(radii, 4)));
  // At n r the spring is stiffest, k (1 + 48 n^2): omega dt = 0.04 at most, by whose square steps
  // err; a hundredth of the speed is more.
  const auto held = simulate_text(
      kShot + wall, {speed_text(0.99 * bound), "parameters.phi=0.01", "parameters.longest=0.1 us"});
  ASSERT_EQ(held.failure, "");
  EXPECT_GT(held.last("body.shot.velocity.y"), 0.98 * bound);
  EXPECT_TRUE(held.lost.empty());
  EXPECT_TRUE(held.warnings.empty());

  const auto through = simulate_text(
      kShot + wall, {speed_text(1.01 * bound), "parameters.phi=0.01", "parameters.longest=0.1 us"});
  ASSERT_EQ(through.failure, "");
  EXPECT_LT(through.last("body.shot.velocity.y"), 0);
  ASSERT_EQ(through.lost.count("shot-wall"), 1u);
  const LostReport& lost = through.lost.at("shot-wall");
  EXPECT_EQ(lost.let_go, 1);
  EXPECT_EQ(lost.from_behind, 0);
  // Just beyond n r: a step moves it by far less than a tenth of that, slow as it is there.
  EXPECT_GT(lost.depth, radii * 0.5e-3);
  EXPECT_LT(lost.depth, 1.1 * radii * 0.5e-3);
  EXPECT_NEAR(lost.point[0], 0, 1e-9);
  EXPECT_NEAR(lost.point[1], 0, 1e-12) << "on the wall";
  ASSERT_EQ(through.warnings.size(), 1u);
  EXPECT_NE(through.warnings[0].find("shot-wall: a particle came "), std::string::npos);
}

TEST(LostContacts, AParticleIsGivenUpBehindARigidBody) { expect_told_from(kBox, 3); }

TEST(LostContacts, AParticleIsGivenUpBehindAnOpenSurface) { expect_told_from(kPlane, 6); }

TEST(LostContacts, FacesOfAWeakPairLetGo) {
  // phi = 1e-3: at the limit, an element of 1 mm, faces press by 62 phi M/2 = 0.031 M, which slows
  // them by p/(rho c) = 3 m/s each at most. They let go when the gap of 0.3 mm and the limit are
  // behind them, 13 us and up to 6 % more. Each of the ten faces of the block meets one.
  const std::string tube = R"(
boundaries:
  a: {body: flying, where: all, fix: [x]}
  b: {body: standing, where: all, fix: [x]}
)";
  const auto run = simulate_text(kBlocks + tube, {"parameters.phi=0.001", "parameters.end=20 us"});
  ASSERT_EQ(run.failure, "");
  ASSERT_EQ(run.lost.count("flying-standing"), 1u);
  const LostReport& lost = run.lost.at("flying-standing");
  EXPECT_EQ(lost.let_go, 10);
  EXPECT_EQ(lost.from_behind, 0);
  EXPECT_GT(lost.time, 13e-6);
  EXPECT_LT(lost.time, 1.06 * 13e-6);
  EXPECT_GT(lost.depth, 1e-3);
  EXPECT_EQ(run.last("contact.flying-standing.planes"), 0);
}

TEST(LostContacts, BlocksThatStayWholeSayNothing) {
  for (const Real speed : {10.0, 40.0, 60.0}) {
    const auto run = simulate_text(kBlocks, {speed_text(speed), "parameters.end=0.5 ms"});
    ASSERT_EQ(run.failure, "") << speed;
    EXPECT_TRUE(run.lost.empty()) << speed;
    EXPECT_TRUE(run.warnings.empty()) << speed;
  }
}

// Faces that go through each other where they fold come back without a push: contact makes or takes
// no more than steps at the limit of stability do (fast_faces_test.cpp), and blocks alike that meet
// at up to the speed of sound part again.
TEST(LostContacts, BlocksThatFoldSayItAndKeepTheirEnergy) {
  for (const Real speed : {70.0, 100.0, 200.0}) {
    const auto run = simulate_text(kBlocks, {speed_text(speed), "parameters.end=0.4 ms"});
    ASSERT_EQ(run.failure, "") << speed;
    ASSERT_EQ(run.lost.count("flying-standing"), 1u) << speed;
    const LostReport& lost = run.lost.at("flying-standing");
    EXPECT_GT(lost.from_behind, 0) << speed;
    // Beyond half of the element's depth, where no pair comes that holds.
    EXPECT_GT(lost.depth, 0.5e-3) << speed;
    // Whether an edge was inside first or faces came back first; those that are deep, and hold yet,
    // are reported before, and created energy behind.
    const auto says_it = [](const std::string& text) {
      return text.find("flying-standing: faces") != std::string::npos &&
             text.find("through each other") != std::string::npos;
    };
    EXPECT_EQ(std::count_if(run.warnings.begin(), run.warnings.end(), says_it), 1) << speed;
    Real largest = 0;
    for (const Real pairs : run.column("energy.contact.pairs")) {
      largest = std::max(largest, std::fabs(pairs));
    }
    EXPECT_LT(largest, 0.086 / 6 * run.first("energy.kinetic")) << speed;
    if (speed > 100) continue;
    EXPECT_GT(run.last("body.flying.velocity.y") - run.last("body.standing.velocity.y"),
              0.4 * speed);
    EXPECT_EQ(run.last("contact.flying-standing.planes"), 0);
  }
}

TEST(LostContacts, AreTheSameOverARestart) {
  const auto whole = simulate_text(kBlocks, {"parameters.end=0.15 ms"});
  ASSERT_EQ(whole.lost.size(), 1u);
  const LostReport& lost = whole.lost.at("flying-standing");
  for (const std::int64_t at : {100, 160}) {  // before, and after the first
    const auto split = simulate_text(kBlocks, {"parameters.end=0.15 ms"}, {0, false, at});
    ASSERT_EQ(split.lost.size(), 1u);
    const LostReport& other = split.lost.at("flying-standing");
    EXPECT_EQ(other.let_go, lost.let_go);
    EXPECT_EQ(other.from_behind, lost.from_behind);
    EXPECT_EQ(other.time, lost.time);
    EXPECT_EQ(other.depth, lost.depth);
    EXPECT_EQ(other.point, lost.point);
    // After the restart the last of them; before, deep faces are reported too.
    EXPECT_EQ(split.warnings.back(), whole.warnings.back());
  }
}

}  // namespace
}  // namespace brunt::test
