// The torque of a pair on its first body about the origin of the deck's coordinates, which lies at
// -origin: M(origin) = M(0) + origin x F. On bodies whose nodes are free it is sum x_a x f_a.
#include <gtest/gtest.h>

#include <random>

#include "tests/unit/contact/contact_scene.hpp"

namespace brunt {
namespace {

using testing::add_sheet;
using testing::ContactScene;

constexpr Real kSpring = 1e4, kPressed = 1e-3, kCoefficient = 0.3;  // [N/m], [m], [1]

ContactOptions rubbing() {
  ContactOptions options;
  options.fallback = {false, 1.0, 0, Varying{}};
  options.fallback.initial_overlap = InitialOverlap::press;
  options.fallback.coulomb.friction->constant = kCoefficient;
  return options;
}

/// Moves the second body by `way` along x in one step.
template <int Dim>
void drag(ContactScene<Dim>& scene, Real way) {
  auto& p = scene.groups[1].points;
  for (std::size_t i = 0; i < p.x.size(); ++i) {
    p.v[i][0] = way / 1e-3;
    p.x[i][0] += way;
  }
  scene.contact->add_forces(1e-3);
}

// A particle at c on a rigid floor, N up and mu N back: (mu N, 0, -N) on the floor, in a line
// through c.
TEST(ContactReports, TorqueOfAParticle) {
  ContactScene<3> scene;
  scene.options = rubbing();
  add_sheet(scene, 3, 0, 3, 0, true, 0, 0);
  const Real r = 0.25, height = r - kPressed, normal = kSpring * kPressed;
  scene.add_particle(scene.add_group(), Vec3(1.2, 0.7, height), r, kSpring / (2 * r), 1);
  scene.start();
  drag(scene, 0.1);
  const Vec3 force(kCoefficient * normal, 0, -normal);
  for (const Vec3& origin : {Vec3(0, 0, 0), Vec3(3, -20, 7)}) {
    const Vec3 expected = (origin + Vec3(1.3, 0.7, height)).cross(force);
    const auto report = scene.contact->reports(origin).at(0);
    // 1 mm of penetration, known to 5e-17 m of rounding at 0.25 m; arms of up to 20 m.
    for (int c = 0; c < 3; ++c) {
      const auto k = static_cast<std::size_t>(c);
      EXPECT_NEAR(report.force[k], force[c], 1e-12 * normal);
      EXPECT_NEAR(report.torque[k], expected[c], 20 * 1e-12 * normal);
    }
  }
}

// In 2D there is z alone: x f_y - y f_x. Sheets of equal springs S, which press by d over 1 m: N =
// S d / 2 at the middle of both faces, d / 2 high, and friction mu N there.
TEST(ContactReports, TorqueOfEdges) {
  ContactScene<2> scene;
  scene.options = rubbing();
  add_sheet(scene, 6, -1, 3, kPressed, true, kSpring, 1);
  add_sheet(scene, 2, 0, 1, 0, false, kSpring, 1);
  scene.start();
  drag(scene, 0.1);
  const Real normal = 0.5 * kSpring * kPressed;
  const Vec<2> force(kCoefficient * normal, -normal), middle(0.6, 0.5 * kPressed);
  for (const Vec<2>& origin : {Vec<2>(0, 0), Vec<2>(3, -20)}) {
    const Vec<2> at = origin + middle;
    const auto report = scene.contact->reports(origin).at(0);
    EXPECT_NEAR(report.torque[2], at[0] * force[1] - at[1] * force[0], 20 * 1e-12 * normal);
    EXPECT_EQ(report.torque[0], 0);
    EXPECT_EQ(report.torque[1], 0);
  }
}

TEST(ContactReports, NoTorqueOfAWholeRing) {
  ContactScene<2> scene;
  scene.geometry = Geometry::axisymmetric;
  scene.options = rubbing();
  add_sheet(scene, 3, 0, 1, kPressed, true, kSpring, 1);
  add_sheet(scene, 2, 0, 1, 0, false, kSpring, 1);
  scene.start();
  scene.evaluate();
  EXPECT_GT(scene.contact->reports().at(0).force[1], -1e3);
  EXPECT_EQ(scene.contact->reports(Vec<2>(1, 2)).at(0).torque[2], 0);
}

// Warped faces and particles at random places, with friction and dampers: what is reported is the
// moment of the nodes' forces. Some hundred roundings at arms of up to 10 m.
TEST(ContactReports, TorqueIsTheMomentOfTheForces) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<Real> u(-1, 1);
  const auto warp = [&](const Vec3& x) {
    return Vec3(x + 0.01 * Vec3(u(random), u(random), u(random)));
  };
  for (const bool particles : {false, true}) {
    ContactScene<3> scene;
    scene.options = rubbing();
    scene.options.fallback.damping = 0.1;
    if (particles) {
      auto& group = scene.add_group();
      for (int i = 0; i < 12; ++i) {
        const Vec3 x(0.5 + 0.4 * u(random), 0.5 + 0.4 * u(random), 0.15);
        scene.add_particle(group, x, 0.2, kSpring, 1);
      }
    } else {
      add_sheet(scene, 4, 0.05, 0.9, 0, false, kSpring, 1, warp);
    }
    add_sheet(scene, 5, 0, 1, particles ? 0 : 0.05, true, kSpring, 1, warp);
    for (auto& group : scene.groups) {
      for (auto& v : group.points.v) v = Vec3(u(random), u(random), 0.1 * u(random));
    }
    scene.start();
    scene.contact->add_forces(1e-3);
    const Vec3 origin(4, -9, 2);
    Vec3 moment = Vec3::Zero();
    const auto& p = scene.groups[0].points;
    for (std::size_t i = 0; i < p.x.size(); ++i) moment += (origin + p.x[i]).cross(p.f[i]);
    const auto report = scene.contact->reports(origin).at(0);
    for (int c = 0; c < 3; ++c) {
      const Real reported = report.torque[static_cast<std::size_t>(c)];
      EXPECT_NEAR(reported, moment[c], 1e-13 * moment.norm()) << particles;
    }
    EXPECT_GT(moment.norm(), 1);
  }
}

}  // namespace
}  // namespace brunt
