// Friction in an axisymmetric section, where a length dl at the radius r stands for the ring
// 2 pi r dl and forces are those of whole rings. Faces whose springs S = M/h are equal have k = phi
// S / 2 per area: pressed by d they carry p = k d, dragged far they rub with mu p. Sums of some
// tens of exact integrals leave 1e-14 of them.
#include <gtest/gtest.h>

#include "tests/unit/contact/contact_scene.hpp"

namespace brunt {
namespace {

using testing::add_sheet;
using testing::ContactScene;

constexpr Real kSide = 1e6, kPressed = 0.01, kMu = 0.3;  // [Pa/m], [m], [1]
constexpr Real kPressure = 0.5 * kSide / 2 * kPressed;   // [Pa]

ContactScene<2> ring_scene() {
  ContactScene<2> scene;
  scene.geometry = Geometry::axisymmetric;
  scene.options.fallback.coulomb.friction.emplace().constant = kMu;
  return scene;
}

/// A cylinder of the radius r from `base` up, of n edges, that faces outwards or inwards.
void add_cylinder(ContactScene<2>& scene, int n, Real r, Real base, Real length, bool outwards) {
  auto& group = scene.add_group();
  for (int i = 0; i <= n; ++i) scene.add_point(group, {r, base + length / n * i}, 1);
  for (int i = 0; i < n; ++i) {
    auto& facet = group.surface.facets.emplace_back();
    facet.node = {outwards ? i : i + 1, outwards ? i + 1 : i};
    scene.name(group, facet, kSide, 1);
  }
}

void drag(ContactScene<2>& scene, const Vec<2>& step) {
  for (int i = 0; i < 3; ++i) {
    for (auto& group : scene.groups) {
      for (auto& f : group.points.f) f.setZero();
    }
    for (auto& v : scene.groups[1].points.v) v = step;
    for (auto& x : scene.groups[1].points.x) x += step;
    scene.contact->add_forces(1);
  }
}

/// [J] that contact has taken from the motion and not booked: none.
void expect_books(ContactScene<2>& scene, const Vec<2>& step) {
  const auto column = [](const Totals<2>& totals, Column which) {
    return totals.columns[static_cast<std::size_t>(which)].value();
  };
  for (auto& v : scene.groups[1].points.v) v = step;
  const auto before = scene.totals();
  Real work = 0;
  for (int half = 0; half < 2; ++half) {
    for (const auto& f : scene.groups[1].points.f) work -= 0.5 * f.dot(step);
    if (half == 0) {
      for (auto& group : scene.groups) {
        for (auto& f : group.points.f) f.setZero();
      }
      for (auto& x : scene.groups[1].points.x) x += step;
      scene.contact->add_forces(1);
    }
  }
  const auto after = scene.totals();
  Real booked = 0;
  for (const auto which : {Column::contact_spring, Column::contact_damping,
                           Column::contact_friction, Column::contact_pairs}) {
    booked += column(after, which) - column(before, which);
  }
  EXPECT_NEAR(booked, work, 1e-12 * std::fabs(work));
  const Real heat =
      column(after, Column::contact_friction) - column(before, Column::contact_friction);
  EXPECT_NEAR(heat, work, 1e-3 * std::fabs(work));
}

// A disc from a to b on a plate, all of it moving outwards: mu p pi (b^2 - a^2) against it.
TEST(AxisymmetricFriction, ARingThatGrowsOnAPlate) {
  auto scene = ring_scene();
  add_sheet(scene, 11, 0.5, 9, 0, true, kSide, 1);
  add_sheet(scene, 4, 1, 3, -kPressed, false, kSide, 1);
  scene.start();
  drag(scene, {0.1, 0});
  const Real a = 1.3, b = 4.3, expected = kMu * kPressure * kPi * (b * b - a * a);
  EXPECT_NEAR(scene.force(1)[0], -expected, 1e-12 * expected);
  EXPECT_NEAR(scene.force(0)[0], expected, 1e-12 * expected);
  drag(scene, {1e-3, 0});  // areas that grow much in a step load their springs anew
  expect_books(scene, {1e-3, 0});
}

// A shaft pushed along the axis through a ring of length L: mu p 2 pi r L, r in the middle of what
// overlaps. Axial momentum is kept.
TEST(AxisymmetricFriction, AShaftPushedThroughARing) {
  auto scene = ring_scene();
  add_cylinder(scene, 7, 2, -3, 9, true);
  add_cylinder(scene, 4, 2 - kPressed, 0, 3, false);
  scene.start();
  drag(scene, {0, 0.1});
  const Real expected = kMu * kPressure * 2 * kPi * (2 - 0.5 * kPressed) * 3;
  EXPECT_NEAR(scene.force(1)[1], -expected, 1e-12 * expected);
  EXPECT_NEAR(scene.force(0)[1] + scene.force(1)[1], 0, 1e-14 * expected);
  expect_books(scene, {0, 1e-3});
}

// A shear limit counts the area of the ring.
TEST(AxisymmetricFriction, AShearLimitOnARing) {
  auto scene = ring_scene();
  scene.options.fallback.coulomb.shear_limit = true;
  add_cylinder(scene, 7, 2, -3, 9, true);
  add_cylinder(scene, 4, 2 - kPressed, 0, 3, false);
  const Real yield = 0.5 * kMu * kPressure * std::sqrt(3.0);
  auto& surface = scene.groups[0].surface;
  surface.facet_material.assign(surface.facets.size(), {300, yield});
  scene.start();
  drag(scene, {0, 0.1});
  const Real expected = 0.5 * kMu * kPressure * 2 * kPi * (2 - 0.5 * kPressed) * 3;
  EXPECT_NEAR(scene.force(1)[1], -expected, 1e-12 * expected);
}

}  // namespace
}  // namespace brunt
