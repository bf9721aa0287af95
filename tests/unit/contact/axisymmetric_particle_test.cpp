// Particles about the axis of an axisymmetric scene: one of radius a at r is the ring from r - a to
// r + a, and where that would end behind the axis the disc of r + a; its breadth is b = area / 2a
// (docs/theory/contact.md, C57). On a held rigid face it has k = phi M b and goes
// v sqrt(m/k) deep at the speed v, wherever it is, if its mass follows its area.
#include <gtest/gtest.h>

#include "tests/unit/contact/contact_scene.hpp"

namespace brunt {
namespace {

using testing::add_sheet;
using testing::ContactScene;

constexpr Section kRing{Geometry::axisymmetric, 1};
// rho = 1000 kg/m^3, M = 1e9 Pa: c = 1000 m/s; spacing 1 mm.
constexpr Real kDensity = 1000, kModulus = 1e9, kSound = 1000, kRadius = 0.5e-3;

/// [m^2] seen along the axis.
Real area_at(Real r) {
  const Real inside = std::max(r - kRadius, 0.0);
  return kPi * ((r + kRadius) * (r + kRadius) - inside * inside);
}

Real spring_at(Real r, Real phi) { return phi * kModulus * area_at(r) / (2 * kRadius); }

/// A floor at y = 0, rigid or as stiff as the particle, and a particle over it.
ContactScene<2> scene_of(Real r, Real height, bool rigid) {
  ContactScene<2> scene;
  scene.geometry = Geometry::axisymmetric;
  const Real side = 2 * kRadius;
  add_sheet(scene, 8, 0, 40 * side, 0, true, rigid ? 0 : kModulus / side, side);
  scene.add_particle(scene.add_group(), {r, height}, kRadius, kModulus,
                     kDensity * 2 * kRadius * area_at(r));
  return scene;
}

TEST(AxisymmetricParticle, RowsCoverADisc) {
  for (const Real first : {0.0, 0.3 * kRadius, kRadius, 7 * kRadius}) {
    Real sum = 0, r = first;
    for (int i = 0; i < 20; ++i, r += 2 * kRadius) {
      sum += 2 * kRadius * kRing.breadth_of_particle(r, kRadius);
    }
    const Real inside = std::max(first - kRadius, 0.0), outside = r - kRadius;
    EXPECT_NEAR(sum / (kPi * (outside * outside - inside * inside)), 1, 1e-14) << first;
  }
}

TEST(AxisymmetricParticle, BreadthAndItsSlopeAreContinuous) {
  const auto slope = [](Real r) {
    const Real d = 1e-6 * kRadius;
    const auto at = [](Real x) { return kRing.breadth_of_particle(x, kRadius); };
    return (at(r + d) - at(r - d)) / (2 * d);
  };
  EXPECT_NEAR(slope(kRadius * (1 - 1e-5)), 2 * kPi, 1e-4);
  EXPECT_NEAR(slope(kRadius * (1 + 1e-5)), 2 * kPi, 1e-4);
  for (const Real r : {1.0, 1.5, 40.0}) {  // the same bits as those of a face
    EXPECT_EQ(kRing.breadth_of_particle(r * kRadius, kRadius), kRing.breadth(r * kRadius));
  }
  EXPECT_NEAR(kRing.breadth_of_particle(0, kRadius), kPi * kRadius / 2, 1e-15);
  EXPECT_EQ(kRing.breadth_of_particle(-0.2 * kRadius, kRadius),
            kRing.breadth_of_particle(0.2 * kRadius, kRadius));
  const Section strip{Geometry::plane_strain, 0.3};
  EXPECT_EQ(strip.breadth_of_particle(0, kRadius), 0.3);
}

TEST(AxisymmetricParticle, PushesByItsArea) {
  const Real pressed = 0.1 * kRadius;
  for (const Real r : {0.0, 0.4 * kRadius, kRadius, 9 * kRadius}) {
    for (const bool rigid : {true, false}) {
      auto scene = scene_of(r, kRadius - pressed, rigid);
      scene.start();
      scene.evaluate();
      // On a face of the same matter, both springs in series: S (2 r)^2 = 2 r M.
      const Real force = spring_at(r, rigid ? 0.5 : 0.25) * pressed;
      EXPECT_NEAR(scene.force(1)[1] / force, 1, 1e-12) << r / kRadius << rigid;
      EXPECT_NEAR(scene.force(1)[0], 0, 1e-12 * force);
      EXPECT_NEAR(scene.force(0)[1] / force, -1, 1e-12);
      EXPECT_NEAR(scene.contact->view().pressure.at(0) * area_at(r) / force, 1, 1e-12);
    }
  }
}

// Half a swing of a few hundred steps, dt w = 0.02: (dt w)^2 / 8 of the depth is missed at most.
TEST(AxisymmetricParticle, ComesBackFromTheAxisAsFromElsewhere) {
  const Real speed = 0.1 * kSound;
  for (const Real r : {0.0, 0.4 * kRadius, kRadius, 9 * kRadius}) {
    auto scene = scene_of(r, kRadius, true);
    scene.options.fallback.damping = 0;
    scene.start();
    auto& points = scene.groups[1].points;
    points.v[0][1] = -speed;
    const Real frequency = std::sqrt(spring_at(r, 0.5) / points.mass[0]);
    EXPECT_NEAR(scene.contact->stable_step().step * frequency, 2, 1e-12);
    Real deepest = 0;
    for (int i = 0; i < 200; ++i) {
      scene.step(0.02 / frequency);
      deepest = std::max(deepest, kRadius - points.x[0][1]);
    }
    EXPECT_NEAR(deepest * frequency / speed, 1, 1e-4) << r / kRadius;
    EXPECT_NEAR(points.v[0][1] / speed, 1, 1e-3) << r / kRadius;
  }
}

// With the step that contact allows: held up to five times its speed of sound, as in space.
TEST(AxisymmetricParticle, IsHeldOnTheAxisHoweverFast) {
  for (const bool rigid : {true, false}) {
    for (const Real speed : {0.2, 1.0, 5.0}) {
      auto scene = scene_of(0, 1.2 * kRadius, rigid);
      for (auto& mass : scene.groups[0].points.mass) mass *= 10 * scene.groups[1].points.mass[0];
      auto& points = scene.groups[1].points;
      points.v[0][1] = -speed * kSound;
      scene.start();
      const Real momentum = points.mass[0] * speed * kSound;
      for (int i = 0; i < 2000 && points.x[0][1] < 2 * kRadius; ++i) {
        const Real bound = 0.9 * scene.contact->stable_step().step;
        // As elements do, whose nodes on the axis stay there.
        const auto hold = [&] { scene.groups[0].points.f[0][0] = 0; };
        scene.step(std::min(bound, 0.7 * 2 * kRadius / kSound), hold);
      }
      EXPECT_GT(points.v[0][1], 0) << speed << rigid;
      if (rigid) continue;
      Real sum = points.mass[0] * points.v[0][1];
      const auto& floor = scene.groups[0].points;
      for (std::size_t k = 0; k < floor.x.size(); ++k) sum += floor.mass[k] * floor.v[k][1];
      EXPECT_NEAR(sum / momentum, -1, 1e-12) << speed;
    }
  }
}

}  // namespace
}  // namespace brunt
