// A plate of elements 1 m thick is squeezed to 0.2 m about a particle of radius 0.6 m that came in
// from above: 0.15 m behind the upper face it is nearer to the lower one, and at 0.25 m beyond it,
// and still belongs to the upper. Once it has let go of the plate the nearest face has it.
#include "contact/evaluate/particle_touches.hpp"

#include <gtest/gtest.h>

#include "tests/unit/contact/contact_scene.hpp"

namespace brunt {
namespace {

using brunt::testing::ContactScene;

constexpr Real kRadius = 0.6;

/// Two faces of a plate, 1 m apart, and a particle at a height above the upper.
ContactScene<2> plate(Real height) {
  ContactScene<2> scene;
  auto& faces = scene.add_group();
  scene.add_face(faces, {{2, 0}, {-2, 0}}, 1e3, 0.5, 1);
  scene.add_face(faces, {{-2, -1}, {2, -1}}, 1e3, 0.5, 1);
  scene.add_particle(scene.add_group(), {0, height}, kRadius, 1e3, 1);
  scene.start();
  scene.evaluate();
  return scene;
}

/// Force on the particle once the plate is squeezed about it.
Real squeezed(ContactScene<2>& scene, Real height) {
  for (auto& x : scene.groups[0].points.x) {
    if (x[1] < 0) x[1] = -0.2;
  }
  scene.groups[1].points.x[0][1] = height;
  scene.evaluate();
  return scene.force(1)[1];
}

TEST(ParticleTouches, AThinPlateHasTheSideThatWasTouchedLast) {
  for (const Real height : {-0.15, -0.25}) {
    auto touched = plate(0.3), apart = plate(5);
    EXPECT_GT(touched.force(1)[1], 0);
    EXPECT_GT(squeezed(touched, height), 0) << height;
    EXPECT_EQ(apart.force(1)[1], 0);
    EXPECT_LT(squeezed(apart, height), 0) << height;
  }
}

TEST(ParticleTouches, WhatIsLetGoBelongsToTheNearestFace) {
  auto scene = plate(0.3);
  EXPECT_EQ(squeezed(scene, 2), 0);
  EXPECT_LT(squeezed(scene, -0.15), 0);
  EXPECT_LT(squeezed(scene, -0.05), 0);  // it is the lower one's now
  EXPECT_EQ(squeezed(scene, -3), 0);
  EXPECT_GT(squeezed(scene, -0.05), 0);
}

}  // namespace
}  // namespace brunt
