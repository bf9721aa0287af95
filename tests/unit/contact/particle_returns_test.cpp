// A particle that no face held, since it was farther behind the nearest one than that holds, is not
// pressed where the other side of the plate, or the same face, holds it again: it would begin at
// the top of a barrier, with an energy that nobody put in. It goes out without a force, keeps what
// it has of speed, and is pressed by what it closes again.
#include "contact/evaluate/particle_returns.hpp"

#include <gtest/gtest.h>

#include "tests/unit/contact/contact_scene.hpp"

namespace brunt {
namespace {

using brunt::testing::ContactScene;

constexpr Real kRadius = 0.6, kStep = 1e-3;

/// A plate 1 m thick, whose faces hold by the depths given, and a particle at a height above the
/// upper that moves at a speed along y. Nothing else acts on it.
ContactScene<2> plate(Real upper_depth, Real lower_depth, Real height, Real speed) {
  ContactScene<2> scene;
  scene.options.fallback.damping = 0;
  auto& faces = scene.add_group();
  scene.add_face(faces, {{2, 0}, {-2, 0}}, 1e3, upper_depth, 1e6);
  scene.add_face(faces, {{-2, -1}, {2, -1}}, 1e3, lower_depth, 1e6);
  scene.add_particle(scene.add_group(), {0, height}, kRadius, 1e3, 1);
  scene.groups[1].points.v[0] = {0, speed};
  scene.start();
  scene.evaluate();
  return scene;
}

Vec<2> place(const ContactScene<2>& scene) { return scene.groups[1].points.x[0]; }
Vec<2> velocity(const ContactScene<2>& scene) { return scene.groups[1].points.v[0]; }

TEST(ParticleReturns, BetweenTwoLimitsItGoesOutWithoutForce) {
  // At 0.45 m behind the upper face, which holds 0.4 m, nothing holds; the lower one, nearest from
  // 0.5 m on, holds 0.45 m: from 0.55 m behind the upper.
  auto scene = plate(0.4, 0.45, -0.45, -5);
  ASSERT_EQ(scene.force(1)[1], 0);
  for (int i = 0; i < 400; ++i) {
    scene.step(kStep);
    ASSERT_EQ(scene.force(1)[1], 0) << place(scene)[1];
  }
  EXPECT_EQ(velocity(scene)[1], -5);
}

TEST(ParticleReturns, OutOfTheFaceThatGaveItUpItGoesWithoutForce) {
  auto scene = plate(0.4, 0.45, -0.45, 5);
  for (int i = 0; i < 400; ++i) {
    scene.step(kStep);
    ASSERT_EQ(scene.force(1)[1], 0) << place(scene)[1];
  }
  EXPECT_EQ(velocity(scene)[1], 5);
}

/// Until it turns back, then until it is out again.
void press(ContactScene<2>& scene) {
  for (int i = 0; i < 2000 && velocity(scene)[1] < 0; ++i) {
    scene.step(kStep);
    ASSERT_GE(scene.force(1)[1], 0);
  }
  for (int i = 0; i < 2000; ++i) scene.step(kStep);
}

TEST(ParticleReturns, WhatItClosesAgainIsFelt) {
  auto scene = plate(0.4, 0.45, -0.45, 1);
  for (int i = 0; i < 2000 && place(scene)[1] < -0.1; ++i) scene.step(kStep);
  scene.groups[1].points.v[0][1] = -1;
  press(scene);
  EXPECT_NEAR(velocity(scene)[1], 1, 0.01);  // the spring gives back what it took
}

TEST(ParticleReturns, WhatComesFromTheFrontIsHeld) {
  auto scene = plate(0.4, 0.45, 1, -5);
  press(scene);
  EXPECT_NEAR(velocity(scene)[1], 5, 0.05);
}

}  // namespace
}  // namespace brunt
