// Forces: two sheets that overlap by d over an area A push with k d A, k = phi series(S, S) =
// phi S / 2 for equal S = M/h.
// Bounce: a particle on a spring against a rigid face leaves as fast as it came. Mean over the
// phase at which steps meet the surface: 1.000 at any omega dt (velocity Verlet),
// never exp(-pi omega dt / 4).
#include "contact/manager/manager.hpp"

#include <gtest/gtest.h>

#include "tests/unit/contact/contact_scene.hpp"

namespace brunt {
namespace {

using testing::add_sheet;
using testing::ContactScene;

constexpr Real kStiffness = 1e6;  // [Pa/m]

TEST(ContactManager, SheetsPushByStiffnessDepthAndArea) {
  ContactScene<3> scene;
  add_sheet(scene, 4, 0, 1, 0.1, true, kStiffness, 1);
  add_sheet(scene, 5, 0, 1, 0, false, kStiffness, 1);
  scene.start();
  scene.evaluate();
  // Sums of some hundred roundings.
  const Real expected = 0.5 * kStiffness / 2 * 0.1;
  EXPECT_NEAR(scene.force(1)[2], expected, 1e-12 * expected);
  EXPECT_LT((scene.force(0) + scene.force(1)).norm(), 1e-12 * expected);
  const auto report = scene.contact->reports();
  ASSERT_EQ(report.size(), 1u);
  EXPECT_EQ(report[0].name, "b0-b1");
  EXPECT_NEAR(report[0].force[2], -expected, 1e-12 * expected);
  EXPECT_NEAR(report[0].area, 1, 1e-12);
  EXPECT_NEAR(report[0].max_penetration, 0.1, 1e-14);
  // Both grids' lines cut 1 in 8 strips each way.
  EXPECT_EQ(report[0].planes, 64);
  const auto view = scene.contact->view();
  EXPECT_EQ(view.polygon_size.size(), 64u);
  for (const Real depth : view.penetration) EXPECT_NEAR(depth, 0.1, 1e-14);
  for (const int corners : view.polygon_size) EXPECT_GE(corners, 3);
}

template <int Dim>
void expect_no_push_without_overlap() {
  for (const Real gap : {0.1, 0.0}) {
    ContactScene<Dim> scene;
    add_sheet(scene, 4, 0, 1, 0.3, true, kStiffness, 1);
    add_sheet(scene, 5, 0, 1, 0.3 + gap, false, kStiffness, 1);
    scene.start();
    scene.evaluate();
    EXPECT_EQ(scene.force(0).norm(), 0);
    EXPECT_EQ(scene.contact->work().contacts, 0u);
  }
}
TEST(ContactManager, SheetsThatAreOpenOrTouchPushNothing) { expect_no_push_without_overlap<3>(); }
TEST(ContactManager, EdgesThatAreOpenOrTouchPushNothing) { expect_no_push_without_overlap<2>(); }

// What the skin lets into the lists is beyond contact and may add nothing, not even zero times it:
// a sheet and a particle near by, with velocities that are no numbers, change no bit of a force.
TEST(ContactManager, EntriesOfTheSkinAddNothing) {
  const auto forces = [](Real velocity) {
    ContactScene<3> scene;
    scene.options.skin = 3;
    add_sheet(scene, 4, 0, 1, 0.1, true, kStiffness, 1);
    add_sheet(scene, 5, 0, 1, 0, false, kStiffness, 1);
    add_sheet(scene, 3, 0, 1, 0.8, false, kStiffness, 1);
    auto& group = scene.add_group();
    scene.add_particle(group, Vec3(0.5, 0.5, 0.6), 0.1, kStiffness, 1);
    for (std::size_t far : {2u, 3u}) {
      for (auto& v : scene.groups[far].points.v) v.setConstant(velocity);
    }
    scene.start();
    scene.evaluate();
    EXPECT_GT(scene.contact->work().candidates, 16u * 25u);
    EXPECT_EQ(scene.contact->work().contacts, 64u);
    std::vector<Vec3> all;
    for (const auto& near : {0u, 1u}) {
      const auto& f = scene.groups[near].points.f;
      all.insert(all.end(), f.begin(), f.end());
    }
    return all;
  };
  const auto healthy = forces(0), poisoned = forces(std::nan(""));
  for (std::size_t i = 0; i < healthy.size(); ++i) EXPECT_EQ(healthy[i], poisoned[i]);
}

TEST(ContactManager, EdgesInTwoDimensions) {
  ContactScene<2> scene;
  scene.depth = 0.25;
  add_sheet(scene, 4, 0, 1, 0.1, true, kStiffness, 1);
  add_sheet(scene, 5, 0, 1, 0, false, 0, 0);  // rigid: the spring of one side alone
  scene.start();
  scene.evaluate();
  const Real expected = 0.5 * kStiffness * 0.1 * 0.25;
  EXPECT_NEAR(scene.force(1)[1], expected, 1e-12 * expected);
  EXPECT_NEAR(scene.force(0)[1], -expected, 1e-12 * expected);
  // The ends of 4 and of 5 edges cut the line into 8 parts, each as deep as all.
  const auto view = scene.contact->view();
  EXPECT_EQ(view.penetration.size(), 8u);
  for (const Real depth : view.penetration) EXPECT_NEAR(depth, 0.1, 1e-14);
}

TEST(ContactManager, IgnoredPairsAndPiecesDoNotTouch) {
  ContactScene<3> scene;
  add_sheet(scene, 2, 0, 1, 0.1, true, kStiffness, 1);
  add_sheet(scene, 2, 0, 1, 0, false, kStiffness, 1);
  scene.options.pairs[{0, 1}].ignore = true;
  scene.start();
  scene.evaluate();
  EXPECT_EQ(scene.force(0).norm(), 0);
  EXPECT_EQ(scene.contact->stable_step().step, kInfinity);
  EXPECT_TRUE(scene.contact->reports().empty());
}

/// A particle that falls on a rigid floor with speed 1; dt in units of 1/omega.
template <int Dim>
ContactScene<Dim> bouncer(Real zeta, Real height) {
  ContactScene<Dim> scene;
  scene.options.fallback = {false, 1.0, zeta, {}};
  scene.options.fallback.initial_overlap = InitialOverlap::press;
  add_sheet(scene, 2, -10, 20, 0.0, true, 0, 0);
  auto& group = scene.add_group();
  Vec<Dim> x = Vec<Dim>::Constant(0.3);
  x[Dim - 1] = 50 + height;
  // k = M (2 r)^(Dim - 2) = 1 N/m, m = 1 kg.
  scene.add_particle(group, x, 50, Dim == 3 ? 0.01 : 1.0, 1.0);
  group.points.v[0][Dim - 1] = -1;
  scene.start();
  return scene;
}

template <int Dim>
Real mean_restitution(Real dt) {
  Real sum = 0;
  constexpr int phases = 40;
  for (int phase = 0; phase < phases; ++phase) {
    auto scene = bouncer<Dim>(0, dt * (1 + phase / Real(phases)));
    const auto& p = scene.groups[1].points;
    for (int i = 0; i < 20 + 10 / dt; ++i) scene.step(dt);
    EXPECT_GT(p.x[0][Dim - 1], 50);
    sum += p.v[0][Dim - 1];
  }
  return sum / phases;
}

TEST(ContactManager, BounceReturnsAllSpeedAtAnyStep) {
  // Each bounce meets the surface between two steps, which changes it by O((omega dt)^2) to either
  // side; the mean over phases cancels most of it.
  for (const Real dt : {0.1, 0.4, 1.0}) {
    const Real tolerance = 0.005 * std::max(dt, 0.2);
    EXPECT_NEAR(mean_restitution<2>(dt), 1, tolerance) << dt;
    EXPECT_NEAR(mean_restitution<3>(dt), 1, tolerance) << dt;
  }
}

TEST(ContactManager, EnergyBookedIsEnergyLost) {
  for (const Real zeta : {0.0, 0.1}) {
    auto scene = bouncer<3>(zeta, 0.07);
    const Real dt = 0.1, start = scene.kinetic(dt);
    for (int i = 0; i < 100; ++i) {
      scene.step(dt);
      const auto totals = scene.totals();
      const Real all = scene.kinetic(dt) + totals.value(Column::contact_spring) +
                       totals.value(Column::contact_damping) + totals.value(Column::contact_pairs);
      ASSERT_NEAR(all, start, 1e-14) << i;  // a hundred roundings of numbers below 1
    }
    const auto totals = scene.totals();
    if (zeta > 0) {
      // exp(-2 pi zeta / sqrt(1 - zeta^2)) = 0.53 of the energy would be left if the damper could
      // pull; it cannot, so a little more is.
      EXPECT_GT(totals.value(Column::contact_damping), 0.2);
      EXPECT_LT(totals.value(Column::contact_damping), 0.24);
    }
    // Apart again the spring holds nothing. Entry and exit fall between steps: O(dt^2) of what went
    // through it is left over.
    EXPECT_EQ(totals.value(Column::contact_spring), 0);
    EXPECT_NEAR(totals.value(Column::contact_pairs), 0, dt * dt);
  }
}

TEST(ContactManager, MomentumOfParticlesOnADeformableSheet) {
  // Random particles that overlap a wavy sheet: total force and moment vanish to round-off.
  ContactScene<3> scene;
  add_sheet(scene, 6, 0, 6, 0, true, kStiffness, 1, [](const Vec3& x) {
    return Vec3(x + 0.05 * Vec3(std::sin(7 * x[1]), std::cos(9 * x[0]), std::sin(5 * x[0] * x[1])));
  });
  auto& group = scene.add_group();
  for (int i = 0; i < 60; ++i) {
    const Real t = 0.5 + 5.0 * i / 60;
    scene.add_particle(group, Vec3(t, 3 + 2.4 * std::sin(11 * t), 0.3), 0.4, kStiffness, 1);
    group.points.v.back() = Vec3(std::sin(t), std::cos(3 * t), -1);
  }
  scene.start();
  scene.evaluate();
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
  Real size = 0;
  for (const auto& of : scene.groups) {
    for (std::size_t i = 0; i < of.points.x.size(); ++i) {
      force += of.points.f[i];
      moment += of.points.x[i].cross(of.points.f[i]);
      size += of.points.f[i].norm();
    }
  }
  EXPECT_GE(scene.contact->work().contacts, 40u);
  EXPECT_LT(force.norm(), 1e-14 * size);
  EXPECT_LT(moment.norm(), 6 * 1e-14 * size);  // arms of up to 6 m
}

TEST(ContactManager, StepLimitIsThatOfTheFacesOwnSpring) {
  // h/c = sqrt(2 m''/S) with m'' = rho h/2 = 500, S = 1e6; ratio 0.972 at phi = 0.5, zeta = 0.
  ContactScene<3> scene;
  scene.options.fallback.damping = 0;
  add_sheet(scene, 4, 0, 1, 0.0, true, kStiffness, 1);
  add_sheet(scene, 5, 0, 1, 1.0, false, kStiffness, 1);  // far from it
  scene.start();
  const auto step_limit = scene.contact->stable_step();
  const Real elements = std::sqrt(1000 / kStiffness);
  EXPECT_NEAR(step_limit.step, elements * std::sqrt(2 / (1 + std::sqrt(1.25))), 1e-14);
  EXPECT_STREQ(step_limit.reason, "contact stiffness");
  EXPECT_EQ(step_limit.entity, 1u << 3);
}

}  // namespace
}  // namespace brunt
