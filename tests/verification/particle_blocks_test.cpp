// Bodies of particles against bodies of particles. Bars of particles: contact of
// 2L/c = 39.62 us, stress rho c v/2 between them, 2 %, velocities swapped to 5 %. Two blocks (C10):
// while they touch, no particle at a corner of the face that meets the other block is accelerated
// by more than twice the mean over that face: a spring that counts twice there would show at once.
// (Measured 1.77. Apart again the block rings, and where its mean passes a low, corners reach 2.4.)
// Pulled over another block a block is held back by mu N, to what riding over the particles
// of the other adds: without friction 2 % of N, with mu = 0.3 a tenth of the force.
// A body in double precision stays so beside one of its material in single that it never meets: it
// feels that only by the step they share, a tenth at the most of what single itself changes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "tests/support/force_pulse.hpp"
#include "tests/support/materials.hpp"
#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

constexpr Real kDensity = 7850, kModulus = 200e9, kLength = 0.1, kSpeed = 10;

const std::string kBars = kSteelForPlaneWaves + R"(
title: bars of particles
geometry: plane-strain
time: {end: 60 us, safety: 0.8}
bodies:
  striker:
    method: sph
    smoothing: 1.2
    material: steel
    shape: {box: {min: [-0.1, 0], max: [0, 0.01]}}
    size: 1 mm
    velocity: [10 m/s, 0]
    viscosity: {alpha: 0, beta: 0}
    artificial_stress: 0
  target:
    method: sph
    smoothing: 1.2
    material: steel
    shape: {box: {min: [0, 0], max: [0.1, 0.01]}}
    size: 1 mm
    viscosity: {alpha: 0, beta: 0}
    artificial_stress: 0
output: {history: 0.02 us}
)";

void expect_bars(const std::vector<std::string>& overrides) {
  const auto run = simulate_text(kBars, overrides);
  ASSERT_EQ(run.failure, "");
  const Real wave = std::sqrt(kModulus / kDensity);
  const Real plateau = 0.5 * kDensity * wave * kSpeed * 0.01;  // [N] per metre of depth
  const ForcePulse contact = force_pulse(run, "contact.striker-target.force.x");
  EXPECT_NEAR(contact.mean, plateau, 0.02 * plateau);
  EXPECT_NEAR(contact.duration, 2 * kLength / wave, 0.06 * 2 * kLength / wave);
  const Real v1 = run.last("body.striker.velocity.x"), v2 = run.last("body.target.velocity.x");
  EXPECT_GT((v2 - v1) / kSpeed, 0.95);
  EXPECT_LT((v2 - v1) / kSpeed, 1);
  const Real start = run.first("momentum.x");
  for (const Real p : run.column("momentum.x")) EXPECT_NEAR(p, start, 1e-12 * start);
  EXPECT_LT(run.worst_drift, 1e-10);
}

TEST(ParticleBars, SwapVelocities) { expect_bars({}); }

// The rows of one lie in the hollows of the other, sqrt(3/4) of a spacing apart.
TEST(ParticleBars, RowsNeedNotMatch) {
  expect_bars(
      {"bodies.target.shape={box: {min: [0, 0], max: [0.1, 0.01]}, translate: [-0.133 mm, "
       "0.5 mm]}"});
}

// Two bars that are bonded are one: thrown apart they hold together, and tension of rho c v slows
// both by v c/L per time, 10 m/s in 19.81 us. (With viscosity: a jump of 20 m/s from particle to
// particle otherwise stays in waves of their spacing, and a quarter of the tension is missing.)
TEST(ParticleBars, BondedBarsAreOne) {
  const std::vector<std::string> apart = {
      "bodies.target.velocity=[10 m/s, 0]", "bodies.striker.velocity=[-10 m/s, 0]",
      "bodies.striker.viscosity={alpha: 1, beta: 2}", "bodies.target.viscosity={alpha: 1, beta: 2}",
      "time.end=18 us"};
  EXPECT_EQ(simulate_text(kBars, apart).last("body.target.velocity.x"), 10);
  auto bonded = apart;
  bonded.emplace_back("contact.default={bonded: true}");
  const auto run = simulate_text(kBars, bonded);
  ASSERT_EQ(run.failure, "");
  EXPECT_LT(run.worst_drift, 1e-10);
  const Real wanted = 10 - 10 * 18e-6 * std::sqrt(kModulus / kDensity) / kLength;
  EXPECT_NEAR(run.last("body.target.velocity.x"), wanted, 0.02 * 10);
  EXPECT_NEAR(run.last("body.striker.velocity.x"), -wanted, 0.02 * 10);
}

TEST(RubbingBlocks, KeepMomentumEnergyAndHeat) {
  const auto run = simulate_shipped("rubbing-blocks");
  ASSERT_EQ(run.failure, "");
  const Real scale = std::fabs(run.first("momentum.z"));
  for (const char* axis : {"x", "y", "z"}) {
    const auto momentum = run.column(std::string("momentum.") + axis);
    for (const Real p : momentum) EXPECT_NEAR(p, momentum.front(), 1e-12 * scale) << axis;
  }
  EXPECT_LT(run.worst_drift, 1e-10);
  EXPECT_LT(std::fabs(run.last("energy.contact.pairs")), 1e-3 * run.largest_energy());
  EXPECT_GT(run.last("heat.friction"), 0);
  EXPECT_NEAR(run.last("heat.friction"), run.last("energy.contact.friction"),
              1e-10 * run.last("energy.contact.friction"));
  for (const Real drift : run.column("heat.drift")) EXPECT_LT(std::fabs(drift), 1e-12);
}

TEST(RubbingBlocks, CornersAreNotThrownOut) {
  Real worst = 0, largest = 0;
  SceneHooks hooks;
  hooks.step_done = [&](Scene<3>& scene, const Clock&) {
    if (scene.contact->work().contacts == 0) return;
    for (auto& solid : scene.solids) {
      const auto& p = solid->points();
      // The layer of the thrown block that meets the other one, and its four corners.
      Real sum = 0, corner = 0;
      int count = 0;
      for (std::size_t i = 0; i < p.x.size(); ++i) {
        const Vec3 start = p.x_start[i] + scene.origin;
        if (p.body[i] != 0 || start[2] > 1e-3) continue;
        sum += p.a[i].norm(), ++count;
        const bool at_corner = std::fabs(start[0]) > 2e-3 && std::fabs(start[1]) > 2e-3;
        if (at_corner) corner = std::max(corner, p.a[i].norm());
      }
      if (count == 0) continue;
      const Real mean = sum / count;
      largest = std::max(largest, mean);
      if (mean > 0.2 * largest) worst = std::max(worst, corner / mean);
    }
  };
  const auto run = simulate_text(R"(
title: two blocks of particles meet
geometry: 3d
time: {end: 6 us}
materials:
  steel: {density: 7850 kg/m^3, elastic: {E: 200 GPa, nu: 0.3}}
bodies:
  thrown:
    method: sph
    smoothing: 1.2
    material: steel
    shape: {box: {min: [-3 mm, -3 mm, 0], max: [3 mm, 3 mm, 6 mm]}}
    size: 1 mm
    velocity: [0, 0, -20 m/s]
  struck:
    method: sph
    smoothing: 1.2
    material: steel
    shape: {box: {min: [-6 mm, -4 mm, -4 mm], max: [6 mm, 4 mm, 0]}}
    size: 1 mm
)",
                                 {}, {}, hooks);
  ASSERT_EQ(run.failure, "");
  EXPECT_GT(worst, 0.5);  // it was looked at
  EXPECT_LT(worst, 2);
  testing::Test::RecordProperty("worst", std::to_string(worst));
}

TEST(RubbingBlocks, PulledBlockIsHeldBack) {
  const auto run = simulate_text(R"(
title: a block of particles is pulled over another one
geometry: plane-strain
time: {end: 3 ms}
materials:
  soft: {density: 1000 kg/m^3, elastic: {E: 10 MPa, nu: 0.3}}
bodies:
  top:
    method: sph
    smoothing: 1.2
    material: soft
    shape: {box: {min: [5 mm, 0], max: [25 mm, 6 mm]}}
    size: 1 mm
  floor:
    method: sph
    smoothing: 1.2
    material: soft
    shape: {box: {min: [0, -5 mm], max: [40 mm, 0]}}
    size: 0.83 mm
boundaries:
  pull: {body: top, where: {side: max-y}, velocity: [2 m/s, free]}
  hold: {body: floor, where: {side: min-y}, fix: [x, y]}
gravity: [0, -5000 m/s^2]
damping: {rate: 3000 1/s, until: 3 ms}
contact: {default: {friction: 0.3}}
output: {history: 5 us}
)");
  ASSERT_EQ(run.failure, "");
  const auto x = run.column("contact.top-floor.force.x"),
             y = run.column("contact.top-floor.force.y");
  Real along = 0, normal = 0;
  for (std::size_t i = x.size() / 2; i < x.size(); ++i) along -= x[i], normal += y[i];
  EXPECT_GT(along / normal, 0.3);
  EXPECT_LT(along / normal, 0.3 * 1.12);
  EXPECT_LT(std::fabs(run.last("energy.contact.pairs")), 1e-3 * run.largest_energy());
  EXPECT_LT(run.worst_drift, 1e-10);
}

TEST(ParticleBlocks, EachBodyHasItsOwnPrecision) {
  const auto energy = [](const std::string& precision) {
    const auto run = simulate_text(R"yaml(
title: two blocks that shear
geometry: plane-strain
time: {end: 2 us}
materials: {m: {density: 7850, elastic: {E: 200 GPa, nu: 0.3}}}
bodies:
  a:
    method: sph
    material: m
    size: 0.2 mm
    velocity: ["= 3000*y", 0]
    shape: {box: {min: [0, 0], max: [4 mm, 4 mm]}}
    pair_precision: )yaml" + precision +
                                   R"yaml(
  b:
    method: sph
    material: m
    size: 0.2 mm
    velocity: ["= 3000*y", 0]
    shape: {box: {min: [20 mm, 0], max: [24 mm, 4 mm]}}
output: {history: 1 us}
)yaml");
    EXPECT_EQ(run.failure, "");
    return std::pair(run.last("body.a.internal"), run.last("body.b.internal"));
  };
  const auto both = energy("double"), mixed = energy("single");
  const Real of_single = std::fabs(mixed.first - both.first);
  EXPECT_GT(of_single, 0);
  EXPECT_LT(std::fabs(mixed.second - both.second), 0.1 * of_single);
}

}  // namespace
}  // namespace brunt::test
