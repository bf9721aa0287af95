// Extremes of contact (physics.md C): stiff penalties in a corner, and moduli a factor of 200,000
// apart.
#include <gtest/gtest.h>

#include <cmath>

#include "contact/law.hpp"
#include "tests/support/simulate.hpp"
#include "tests/unit/contact/contact_scene.hpp"

namespace brunt::test {
namespace {

using brunt::testing::ContactScene;

constexpr Real kSpacing = 1, kDensity = 1, kModulus = 1;  // [m], [kg/m^3], [Pa]: c = 1 m/s

/// A particle of 1 kg in the corner of three rigid walls that face it.
ContactScene<3> corner(Real stiffness) {
  ContactScene<3> scene;
  scene.options.fallback.stiffness = stiffness;
  auto& walls = scene.add_group();
  const Real far = 4;
  scene.add_face(walls, {{0, 0, 0}, {far, 0, 0}, {far, far, 0}, {0, far, 0}}, 0, 0, 0);
  scene.add_face(walls, {{0, 0, 0}, {0, far, 0}, {0, far, far}, {0, 0, far}}, 0, 0, 0);
  scene.add_face(walls, {{0, 0, 0}, {0, 0, far}, {far, 0, far}, {far, 0, 0}}, 0, 0, 0);
  scene.add_particle(scene.add_group(), Vec3::Constant(0.5 * kSpacing + 1e-3), 0.5 * kSpacing,
                     kModulus, kDensity * kSpacing * kSpacing * kSpacing);
  scene.start();
  return scene;
}

// C6. Thrown into the corner at v = 0.04 c along each axis the particle overlaps each wall by less
// than v/c dp sqrt(rho dp^3 / k dp^-2) = 0.04 dp / sqrt(phi), under 5 % of dp for phi = 1. With the
// default damping it never leaves faster than it came, whatever the stiffness and although steps as
// long as its votes allow meet the walls within a step, which gives or takes (w dt)^2/8 of a
// bounce.
TEST(ContactExtremes, NoStiffnessThrowsACornerParticleOut) {
  for (const Real stiffness : {1.0, 10.0, 100.0}) {
    auto scene = corner(stiffness);
    auto& particle = scene.groups[1].points;
    const Real speed = 0.04;
    particle.v[0] = Vec3::Constant(-speed);
    const Real start = scene.kinetic(0);
    Real deepest = 0, dt = 0;
    for (int step = 0; step < 100000 && particle.x[0][0] < 0.5 * kSpacing + 2e-3; ++step) {
      dt = std::min(0.9 * scene.contact->stable_step(dt).step, 0.01);
      scene.step(dt);
      deepest = std::max(deepest, 0.5 * kSpacing - particle.x[0].minCoeff());
    }
    EXPECT_GT(particle.v[0].minCoeff(), 0) << stiffness;
    EXPECT_LT(deepest, 0.05 * kSpacing) << stiffness;
    EXPECT_GT(deepest, 0) << stiffness;
    EXPECT_LE(0.5 * particle.mass[0] * particle.v[0].squaredNorm(), (1 + 1e-6) * start)
        << stiffness;
  }
}

const char* const kSoftOnHard = R"(
title: rubber on steel
geometry: 3d
time: {end: 2 ms}
materials:
  rubber: {density: 1000 kg/m^3, elastic: {E: 1 MPa, nu: 0.3}}
  steel: {density: 7850 kg/m^3, elastic: {E: 200 GPa, nu: 0.3}}
bodies:
  block:
    method: METHOD
    material: rubber
    shape: {box: {min: [-4 mm, -4 mm, 0], max: [4 mm, 4 mm, 8 mm]}}
    size: 2 mm
    velocity: [0, 0, -1 m/s]
  plate:
    material: steel
    shape: {box: {min: [-10 mm, -10 mm, -5 mm], max: [10 mm, 10 mm, 0]}}
    size: 5 mm
)";

// C14. A spring in series of both sides is as soft as the softer one: at 1 m/s = 0.03 c of rubber
// the block of c = 36 m/s sinks in by v/c dp / phi = 5.6 % of a spacing, less than 10 %; and no
// contact asks for a shorter step than a face's own spring does before it touches anything (A5).
TEST(ContactExtremes, SoftOnHardCostsNoStep) {
  for (const std::string method : {"sph", "fe"}) {
    std::string text = kSoftOnHard;
    text.replace(text.find("METHOD"), 6, method);
    const Real own_spring = 0.98 * surface_step_ratio(0.5, 0.1);  // 2 %: footprints of particles
    int seen = 0;
    SceneHooks hooks;
    hooks.step_done = [&](Scene<3>& scene, const Clock& clock) {
      StepVote solids;
      for (const auto& solid : scene.solids) solids.take(solid->stable_step());
      EXPECT_GE(scene.contact->stable_step(clock.dt()).step, own_spring * solids.step) << method;
      ++seen;
    };
    const auto run = simulate_text(text, {}, {}, hooks);
    ASSERT_EQ(run.failure, "");
    EXPECT_GT(seen, 1000);
    const auto depths = run.column("contact.block-plate.max_penetration");
    const Real deepest = *std::max_element(depths.begin(), depths.end());
    EXPECT_GT(deepest, 0.01 * 2e-3) << method;
    EXPECT_LT(deepest, 0.1 * 2e-3) << method;
    EXPECT_GT(run.last("body.block.velocity.z"), 0.5) << method;
    EXPECT_LT(run.worst_drift, 1e-10) << method;
  }
}

}  // namespace
}  // namespace brunt::test
