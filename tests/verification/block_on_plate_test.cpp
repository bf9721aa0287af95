// A block of particles and a plate of hexes.
// Free flight and impact without supports, with and without friction: total momentum changes by
// rounding only, and the forces of contact have no moment, with the couple that friction at the
// centre of a particle gives the corners of a face. Elements, the corrected stress of particles and
// their viscosity have none either; artificial stress has one (unit sph angular_momentum_test.cpp),
// and total angular momentum is kept to rounding but for its impulse. At rest under gravity the
// plate carries the weight of the block: m g = 1000 kg/m^3 (20 mm)^3 g = 0.07848 N.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sph/particles.hpp"
#include "tests/support/materials.hpp"
#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

const std::string kBlock = kRubber + R"(
title: block on plate
geometry: 3d
time: {end: 4 ms, safety: 0.9}
bodies:
  block:
    method: sph
    smoothing: 1.2
    material: rubber
    shape: {box: {min: [-10 mm, -10 mm, 0], max: [10 mm, 10 mm, 20 mm]}}
    size: 4 mm
    velocity: [0.2 m/s, 0.1 m/s, -1 m/s]
  plate:
    method: fe
    material: rubber
    shape: {box: {min: [-21 mm, -21 mm, -10 mm], max: [21 mm, 21 mm, 0]}}
    size: 5 mm
)";

class BlockOnPlate : public testing::TestWithParam<const char*> {
 protected:
  std::string friction() const { return std::string("contact.default.friction=") + GetParam(); }
};

TEST_P(BlockOnPlate, MomentumIsKept) {
  const auto run = simulate_text(kBlock, {friction()});
  ASSERT_EQ(run.failure, "");
  const Real scale = 0.008 * 1.0;  // [N s] of the falling block
  for (const char* axis : {"x", "y", "z"}) {
    const auto momentum = run.column(std::string("momentum.") + axis);
    for (const Real p : momentum) EXPECT_NEAR(p, momentum.front(), 1e-12 * scale) << axis;
  }
  EXPECT_LT(run.last("body.plate.velocity.z"), 0);  // it was hit
  EXPECT_LT(run.worst_drift, 1e-10);
}

TEST_P(BlockOnPlate, ContactForcesHaveNoMoment) {
  // Forces of contact alone, at the nodes of the bending plate and at the particles, as they stand
  // at every second step of the impact.
  int seen = 0;
  Real aside = 0;  // largest part of the forces along the plate
  SceneHooks hooks;
  hooks.step_done = [&](Scene<3>& scene, const Clock& clock) {
    if (clock.step() % 2 != 0) return;
    for (auto& solid : scene.solids) {
      for (auto& f : solid->points().f) f.setZero();
    }
    scene.contact->add_forces(0);
    Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
    Real size = 0, along = 0;
    for (auto& solid : scene.solids) {
      const auto& points = solid->points();
      for (std::size_t i = 0; i < points.x.size(); ++i) {
        force += points.f[i];
        moment += points.x[i].cross(points.f[i]);
        size += points.f[i].norm();
        along += points.f[i].head<2>().norm();
      }
    }
    if (size == 0) return;
    ++seen;
    aside = std::max(aside, along / size);
    EXPECT_LT(force.norm(), 1e-12 * size) << clock.step();
    EXPECT_LT(moment.norm(), 1e-12 * size * 0.02) << clock.step();  // arms of 20 mm
  };
  const auto run = simulate_text(kBlock, {friction(), "time.end=2 ms"}, {}, hooks);
  ASSERT_EQ(run.failure, "");
  EXPECT_GT(seen, 10);
  EXPECT_GT(aside, friction().ends_with("0") ? 0.0 : 0.2);  // it rubs
}

/// Total angular momentum about the origin, and what of it the artificial stress has given.
struct AngularMomentum {
  Vec3 start = Vec3::Zero(), impulse = Vec3::Zero(), moment = Vec3::Zero();
  Real size = 0;                     // sum m |x| |v| after the first step
  Real change = 0, unaccounted = 0;  // largest
  Vec3 sum(const Scene<3>& scene) {
    Vec3 total = Vec3::Zero();
    Real sizes = 0;
    for (const auto& solid : scene.solids) {
      const auto& p = solid->points();
      for (std::size_t i = 0; i < p.x.size(); ++i) {
        total += p.mass[i] * p.x[i].cross(p.v[i]);
        sizes += p.mass[i] * p.x[i].norm() * p.v[i].norm();
      }
    }
    if (size == 0) start = total, size = sizes;
    return total;
  }
  static Vec3 artificial_moment(const Scene<3>& scene) {
    Vec3 total = Vec3::Zero();
    for (const auto& solid : scene.solids) {
      const auto* particles = dynamic_cast<const SphParticles<3>*>(solid.get());
      if (particles == nullptr) continue;
      for (std::size_t i = 0; i < particles->states().size(); ++i) {
        total += particles->points().x[i].cross(particles->artificial_of(i).force);
      }
    }
    return total;
  }
  /// Velocity Verlet: half a step of the moment of its start, half of that of its end.
  void observe(const Scene<3>& scene, Real dt) {
    const Vec3 last = moment;
    moment = artificial_moment(scene);
    const bool first = size == 0;
    const Vec3 now = sum(scene);
    if (!first) impulse += 0.5 * dt * (last + moment);
    change = std::max(change, (now - start).norm());
    unaccounted = std::max(unaccounted, (now - start - impulse).norm());
  }
};

// The page's 1e-12 of the sum of the parts' sizes.
TEST_P(BlockOnPlate, AngularMomentumIsKeptButForArtificialStress) {
  for (const bool artificial : {false, true}) {
    AngularMomentum momentum;
    SceneHooks hooks;
    hooks.step_done = [&](Scene<3>& scene, const Clock& clock) {
      momentum.observe(scene, clock.dt());
    };
    const auto run = simulate_text(
        kBlock,
        {friction(), std::string("bodies.block.artificial_stress=") + (artificial ? "0.3" : "0")},
        {}, hooks);
    ASSERT_EQ(run.failure, "");
    EXPECT_LT(momentum.unaccounted, 1e-12 * momentum.size);
    if (artificial) {
      EXPECT_GT(momentum.change, 1e-7 * momentum.size);  // there is something to account for
    } else {
      EXPECT_EQ(momentum.impulse.norm(), 0);
    }
  }
}

TEST_P(BlockOnPlate, CarriesItsWeightAtRest) {
  // The block's first mode has a period of 4 L/c = 0.7 ms and the plate's is shorter; damping of
  // 2000 1/s takes e^-20 off it in 20 ms.
  const auto run = simulate_text(
      kBlock +
          "gravity: [0, 0, -9.81 m/s^2]\ndamping: {rate: 2000 1/s}\n"
          "boundaries:\n  floor: {body: plate, where: {side: min-z}, fix: [x, y, z]}\n",
      {friction(), "bodies.block.velocity=[0, 0, 0]", "time.end=40 ms"});
  ASSERT_EQ(run.failure, "");
  const Real weight = 1000 * 0.02 * 0.02 * 0.02 * 9.81;
  EXPECT_NEAR(run.last("contact.block-plate.force.z"), weight, 1e-3 * weight);
}

INSTANTIATE_TEST_SUITE_P(Friction, BlockOnPlate, testing::Values("0", "0.3"),
                         [](const auto& mu) { return mu.index == 0 ? "without" : "with"; });

}  // namespace
}  // namespace brunt::test
