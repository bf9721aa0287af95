// Friction that depends on what slides. Two faces whose springs S = M/h are equal have k = phi S /
// 2 per area: pressed by d they carry p = k d. Dragged over many times the slip d mu at which they
// begin to slide, friction is mu p A, or Y/sqrt(3) A with a shear limit, whatever the mesh of both
// sides; sums of some tens of forces leave 1e-14 of it.
#include <gtest/gtest.h>

#include "core/errors.hpp"
#include "tests/unit/contact/contact_scene.hpp"

namespace brunt {
namespace {

using testing::add_sheet;
using testing::ContactScene;

constexpr Real kSide = 1e6;                             // [Pa/m] S of each face
constexpr Real kPressed = 0.01;                         // [m]
constexpr Real kArea = 9;                               // [m^2] of the upper sheet
constexpr Real kPressure = 0.5 * kSide / 2 * kPressed;  // [Pa]
constexpr Real kSoft = 1000, kHard = 3000;              // [Pa] flow stresses
const Real kLimit = kSoft / std::sqrt(3.0);             // [Pa]

Varying table(Varying::Over over, Real at_0, Real at_1000) {
  Varying varying;
  varying.over = over;
  varying.abscissa = {0, 1000};
  varying.ordinate = {at_0, at_1000};
  return varying;
}

Varying constant(Real value) {
  Varying varying;
  varying.constant = value;
  return varying;
}

/// A sheet of 3 x 3 m on one of 9 x 9 m, whose meshes do not match.
void add_sheets(ContactScene<3>& scene) {
  add_sheet(scene, 7, -3, 9, 0, true, kSide, 1);
  add_sheet(scene, 2, 0, 3, -kPressed, false, kSide, 1);
}

/// Drags group 1 along x in steps far beyond what its springs give.
template <int Dim>
void drag(ContactScene<Dim>& scene, Real step = 0.1) {
  for (int i = 0; i < 3; ++i) {
    for (auto& group : scene.groups) {
      for (auto& f : group.points.f) f.setZero();
    }
    auto& p = scene.groups[1].points;
    for (std::size_t k = 0; k < p.x.size(); ++k) {
      p.v[k] = Vec<Dim>::Unit(0) * step;
      p.x[k] += p.v[k];
    }
    scene.contact->add_forces(1);
  }
}

void show(ContactScene<3>& scene, std::size_t group, const SurfaceMaterial& material) {
  auto& surface = scene.groups[group].surface;
  surface.facet_material.assign(surface.facets.size(), material);
}

TEST(FrictionLaw, FacesCarryNoMoreShearThanTheSofterSide) {
  for (const bool soft_above : {true, false}) {
    ContactScene<3> scene;
    scene.options.fallback.coulomb.friction = constant(0.5);
    scene.options.fallback.coulomb.shear_limit = true;
    add_sheets(scene);
    show(scene, 0, {300, soft_above ? kHard : kSoft});
    show(scene, 1, {300, soft_above ? kSoft : kHard});
    scene.start();
    ASSERT_TRUE(scene.groups[0].surface.needs_material);
    drag(scene);
    ASSERT_GT(0.5 * kPressure, kLimit);
    EXPECT_NEAR(scene.force(1)[0], -kLimit * kArea, 1e-12 * kLimit * kArea);
    EXPECT_NEAR(scene.force(0)[0], kLimit * kArea, 1e-12 * kLimit * kArea);
  }
}

TEST(FrictionLaw, BelowTheLimitItIsCoulombs) {
  ContactScene<3> scene;
  scene.options.fallback.coulomb.friction = constant(0.1);
  scene.options.fallback.coulomb.shear_limit = true;
  add_sheets(scene);
  show(scene, 0, {300, kSoft});
  scene.start();
  drag(scene);
  const Real coulomb = 0.1 * kPressure * kArea;
  ASSERT_LT(coulomb, kLimit * kArea);
  EXPECT_NEAR(scene.force(1)[0], -coulomb, 1e-12 * coulomb);
}

// One side at 100 K, the other at 300 K: mu(200 K). What shows no material has the temperature of
// its body.
TEST(FrictionLaw, FacesRubAtTheMeanOfBothTemperatures) {
  ContactScene<3> scene;
  scene.options.fallback.coulomb.friction = table(Varying::Over::temperature, 0, 1);
  add_sheets(scene);
  for (auto& facet : scene.groups[0].surface.facets) facet.temperature = 100;
  show(scene, 1, {300, kInfinity});
  scene.start();
  drag(scene);
  EXPECT_NEAR(scene.force(1)[0], -0.2 * kPressure * kArea, 1e-12 * kPressure * kArea);
}

// Where points keep the temperature it is that of the place: T = 100 K + 50 K/m x under a sheet
// whose middle is at x = 1.5 m + 0.3 m, at 300 K. Linear along the face: its mean is that there.
TEST(FrictionLaw, NodesTellTheTemperatureAtThePlace) {
  ContactScene<3> scene;
  scene.options.fallback.coulomb.friction = table(Varying::Over::temperature, 0, 1);
  add_sheets(scene);
  auto& points = scene.groups[0].points;
  std::vector<Real> temperature;
  for (const auto& x : points.x) temperature.push_back(100 + 50 * x[0]);
  points.conduct(temperature);
  for (auto& facet : scene.groups[0].surface.facets) facet.temperature = 1e4;
  for (auto& facet : scene.groups[1].surface.facets) facet.temperature = 300;
  scene.start();
  drag(scene);
  const Real mu = 0.5 * (100 + 50 * 1.8 + 300) / 1000;
  EXPECT_NEAR(scene.force(1)[0], -mu * kPressure * kArea, 1e-12 * kPressure * kArea);
}

// mu = 1e-3 (T + yield + p + v): every argument where it belongs.
TEST(FrictionLaw, AnExpressionSeesTheStateOfSliding) {
  ContactScene<3> scene;
  auto& friction = scene.options.fallback.coulomb.friction.emplace();
  friction.over = Varying::Over::sliding;
  friction.depends.fill(true);
  friction.evaluate = [](const std::array<Real, 4>& s) {
    return 1e-5 * (s[0] + 2 * s[1] + 3 * s[2] + 4 * s[3]);
  };
  add_sheets(scene);
  show(scene, 0, {100, kHard});
  show(scene, 1, {300, kSoft});
  scene.start();
  drag(scene);
  const Real mu = 1e-5 * (200 + 2 * kSoft + 3 * kPressure + 4 * 0.1);
  EXPECT_NEAR(scene.force(1)[0], -mu * kPressure * kArea, 1e-12 * mu * kPressure * kArea);
}

// A particle of radius r on a rigid floor presses with phi M d (2 r)^(Dim - 2), its area is
// (2 r)^2.
TEST(FrictionLaw, AParticleCarriesNoMoreShearThanTheSofterSide) {
  constexpr Real r = 0.25, modulus = 1e6, pressed = 0.01;
  for (const Real yield : {kSoft, 1e9}) {
    ContactScene<3> scene;
    scene.options.fallback.coulomb.friction = table(Varying::Over::temperature, 0, 1);
    scene.options.fallback.coulomb.shear_limit = true;
    add_sheet(scene, 3, -3, 9, 0, true, 0, 0);
    for (auto& facet : scene.groups[0].surface.facets) facet.temperature = 500;
    scene.add_particle(scene.add_group(), Vec3(0.2, 0.1, r - pressed), r, modulus, 1);
    scene.groups[1].surface.particle_material = {{700, yield}};
    scene.start();
    drag(scene);
    const Real push = scene.force(1)[2], area = 4 * r * r;
    const Real expected = std::min(0.6 * push, yield / std::sqrt(3.0) * area);
    EXPECT_GT(0.6 * push, kLimit * area);
    EXPECT_NEAR(scene.force(1)[0], -expected, 1e-12 * expected);
  }
}

TEST(FrictionLaw, ParticlesOnParticlesKnowBothMaterials) {
  constexpr Real r = 0.25;
  ContactScene<3> scene;
  scene.options.fallback.coulomb.friction = table(Varying::Over::temperature, 0, 1);
  scene.options.fallback.coulomb.shear_limit = true;
  for (const Real z : {0.0, 2 * r - 0.01}) {
    scene.add_particle(scene.add_group(), Vec3(0, 0, z), r, 1e6, 1);
  }
  scene.groups[0].surface.particle_material = {{100, kHard}};
  scene.groups[1].surface.particle_material = {{300, kSoft}};
  scene.start();
  drag(scene, 0.01);
  const Vec3 along = (scene.groups[1].points.x[0] - scene.groups[0].points.x[0]).normalized();
  const Vec3 force = scene.force(1);
  const Real push = force.dot(along), rub = (force - push * along).norm();
  EXPECT_NEAR(rub, std::min(0.2 * push, kLimit * 4 * r * r), 1e-12 * push);
  EXPECT_GT(rub, 0);
}

// A coefficient below 0 stops the run: nobody may step on, and the check says where and why.
TEST(FrictionLaw, ACoefficientBelowZeroIsTold) {
  ContactScene<3> scene;
  auto& friction = scene.options.fallback.coulomb.friction.emplace();
  friction.over = Varying::Over::sliding;
  friction.depends = {false, false, false, true};
  friction.evaluate = [](const std::array<Real, 4>& s) { return 0.3 - 10 * s[3]; };
  add_sheets(scene);
  scene.start();
  drag(scene, 0.02);
  EXPECT_NO_THROW(scene.contact->check(1, Vec3::Zero()));
  drag(scene, 0.1);
  EXPECT_LT(scene.contact->stable_step().step, 0);
  try {
    scene.contact->check(2, Vec3(100, 0, 0));
    FAIL();
  } catch (const PhysicsError& error) {
    const std::string reported = error.what();
    EXPECT_NE(reported.find("at t = 2 s, contact b0-b1 at (10"), std::string::npos) << reported;
    EXPECT_NE(reported.find("coefficient of friction = -0.7"), std::string::npos) << reported;
    EXPECT_NE(reported.find("v = 0.1 m/s"), std::string::npos) << reported;
  }
}

// mu = c/p is infinite where nothing presses, and no error: friction c A whatever the pressure.
TEST(FrictionLaw, NoPressureNoCoefficient) {
  ContactScene<3> scene;
  auto& friction = scene.options.fallback.coulomb.friction.emplace();
  friction.over = Varying::Over::sliding;
  friction.depends = {false, false, true, false};
  friction.evaluate = [](const std::array<Real, 4>& s) { return 50 / s[2]; };
  scene.options.fallback.damping = 2;
  add_sheets(scene);
  scene.start();
  drag(scene);
  EXPECT_NEAR(scene.force(1)[0], -50 * kArea, 1e-12 * 50 * kArea);
  auto& p = scene.groups[1].points;
  for (auto& x : p.x) x[2] += 0.1 * kPressed;  // opens fast: the damper takes all of the push
  for (auto& v : p.v) v = Vec3(0.1, 0, 1);
  for (auto& f : p.f) f.setZero();
  scene.contact->add_forces(1);
  EXPECT_EQ(scene.force(1).norm(), 0);
  EXPECT_NO_THROW(scene.contact->check(1, Vec3::Zero()));
}

}  // namespace
}  // namespace brunt
