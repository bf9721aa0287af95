// A particle shot at a face at 0.2 to 5 times its speed of sound, with the step that contact allows
// (times 0.9): it must come back, on a rigid face and on the face of one free element as large as
// itself.
#include <gtest/gtest.h>

#include <random>

#include "tests/unit/contact/contact_scene.hpp"

namespace brunt {
namespace {

using testing::ContactScene;

// rho = 1000 kg/m^3, M = 1e9 Pa: c = 1000 m/s; spacing 1 mm.
constexpr Real kDensity = 1000, kModulus = 1e9, kSound = 1000, kSpacing = 1e-3;

template <int Dim>
std::vector<Vec<Dim>> upward_face(Real size) {
  const Real s = 0.5 * size;
  if constexpr (Dim == 2) {
    return {Vec<2>(s, 0), Vec<2>(-s, 0)};
  } else {
    return {Vec3(-s, -s, 0), Vec3(s, -s, 0), Vec3(s, s, 0), Vec3(-s, s, 0)};
  }
}

/// True if the particle ends up over the face again and leaves it.
template <int Dim>
bool returns(bool rigid, Real speed, const Vec<Dim>& start, bool& slow_enough) {
  ContactScene<Dim> scene;
  auto& target = scene.add_group();
  const auto corners = upward_face<Dim>(kSpacing);
  const Real element = kDensity * std::pow(kSpacing, Dim);
  scene.add_face(target, corners, rigid ? 0 : kModulus / kSpacing, rigid ? 0 : kSpacing,
                 rigid ? 0 : element / (2.0 * static_cast<Real>(corners.size())));
  auto& group = scene.add_group();
  scene.add_particle(group, start, kSpacing / 2, kModulus, element);
  group.points.v[0][Dim - 1] = -speed;
  scene.start();
  Real dt = 0;
  for (int step = 0; step < 4000; ++step) {
    dt = 0.9 * scene.contact->stable_step().step;
    dt = std::min(dt, 0.7 * kSpacing / kSound);
    const Real height = group.points.x[0][Dim - 1];
    if (scene.contact->work().contacts && height > 0 && group.points.v[0][Dim - 1] < 0) {
      slow_enough = slow_enough && speed * dt <= 0.5 * kSpacing;
    }
    scene.step(dt);
    Vec<Dim> center = Vec<Dim>::Zero(), velocity = Vec<Dim>::Zero();
    for (std::size_t i = 0; i < corners.size(); ++i) {
      center += target.points.x[i] / static_cast<Real>(corners.size());
      velocity += target.points.v[i] / static_cast<Real>(corners.size());
    }
    const Vec<Dim> apart = group.points.x[0] - center, leaving = group.points.v[0] - velocity;
    if (step > 3 && apart[Dim - 1] > 0.6 * kSpacing && leaving[Dim - 1] > 0) return true;
    if (apart.norm() > 4 * kSpacing) return false;
  }
  return false;
}

template <int Dim>
void shoot() {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<Real> above(0.51, 2.5);
  for (const bool rigid : {true, false}) {
    // A free face has no element to stiffen it: hit far from its middle it turns over.
    const Real widest = rigid ? 0.3 : 0.1;
    std::uniform_real_distribution<Real> aside(-widest, widest);
    int lost = 0;
    bool slow_enough = true;
    for (const Real mach : {0.2, 0.5, 1.0, 2.0, 3.0, 5.0}) {
      for (int shot = 0; shot < 50; ++shot) {
        Vec<Dim> start;
        for (int c = 0; c + 1 < Dim; ++c) start[c] = aside(random) * kSpacing;
        start[Dim - 1] = above(random) * kSpacing;
        lost += returns<Dim>(rigid, mach * kSound, start, slow_enough) ? 0 : 1;
      }
    }
    EXPECT_EQ(lost, 0) << (rigid ? "rigid" : "free element");
    EXPECT_TRUE(slow_enough);
  }
}

TEST(ContactImpact, NoParticleIsLostInTwoDimensions) { shoot<2>(); }
TEST(ContactImpact, NoParticleIsLostInThreeDimensions) { shoot<3>(); }

/// A particle `height` [m] over a face of a metre that lets go `depth` behind itself, 0: a rigid
/// one, and comes down at 4 km/s; the step limit.
template <int Dim>
StepLimit step_limit_of_one_that_comes(Real height, Real depth) {
  ContactScene<Dim> scene;
  const Real corner = kDensity * depth / (2 * (Dim == 2 ? 2 : 4));  // [kg] of a metre's face
  scene.add_face(scene.add_group(), upward_face<Dim>(1), depth > 0 ? kModulus / depth : 0, depth,
                 corner);
  auto& group = scene.add_group();
  Vec<Dim> x = Vec<Dim>::Zero(), v = 700 * Vec<Dim>::Unit(0);
  x[Dim - 1] = height, v[Dim - 1] = -4000;
  scene.add_particle(group, x, kSpacing / 2, kModulus, kDensity * std::pow(kSpacing, Dim));
  group.points.v[0] = v;
  scene.start();
  return scene.contact->stable_step();
}

template <int Dim>
void expect_speed_limits() {
  // Where they touch; with a gap of half a spacing, that much more.
  for (const auto& [height, way] : {std::pair(0.4, 0.25), {1.0, 0.75}}) {
    const StepLimit step_limit = step_limit_of_one_that_comes<Dim>(height * kSpacing, 0);
    EXPECT_NEAR(step_limit.step, way * kSpacing / 4000, 1e-20);
    EXPECT_STREQ(step_limit.reason, "contact speed");
  }
  // A face that lets go 0.1 spacings behind itself: half of that.
  const StepLimit step_limit = step_limit_of_one_that_comes<Dim>(0.6 * kSpacing, 0.1 * kSpacing);
  EXPECT_NEAR(step_limit.step, (0.1 + 0.05) * kSpacing / 4000, 1e-20);
  EXPECT_STREQ(step_limit.reason, "contact speed");
}

TEST(ContactImpact, SpeedLimitIsHalfARadiusOrDepthOverTheClosingSpeed) {
  expect_speed_limits<2>();
  expect_speed_limits<3>();
}

}  // namespace
}  // namespace brunt
