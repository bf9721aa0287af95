// Bodies that are apart cost nothing, and nothing is missed (docs/theory/contact.md (C49)).
//
// Two faces, 1 m wide, of bodies of their own, move towards each other along x. A face of 1 m has
// the size 1 m, depths here are 0.1 m. With steps of dt and the speed v the way ahead is 4 v dt,
// the allowance L = max(8 (4 v dt), 0.5 m), and bodies are near where their boxes are no farther
// apart than 2 (0.1 m) + L.
#include <gtest/gtest.h>

#include "tests/unit/contact/contact_scene.hpp"

namespace brunt {
namespace {

using testing::ContactScene;

constexpr Real kStep = 1e-4, kStiffness = 1e8, kDepth = 0.1, kMass = 10;

/// Faces that look at each other along x, `gap` apart; the second comes with -speed.
ContactScene<2> two_faces(Real gap, Real speed) {
  ContactScene<2> scene;
  auto& first = scene.add_group();
  scene.add_face(first, {{0, 0}, {0, 1}}, kStiffness, kDepth, kMass);
  auto& second = scene.add_group();
  scene.add_face(second, {{gap, 1}, {gap, 0}}, kStiffness, kDepth, kMass);
  for (auto& v : second.points.v) v[0] = -speed;
  return scene;
}

TEST(NearBodies, ThoseFarApartHaveNoPlanesAndBoundNoStep) {
  auto apart = two_faces(20, 10);
  EXPECT_EQ(apart.start().work().near_faces, 0u);
  apart.step(kStep);
  EXPECT_EQ(apart.contact->work().near_faces, 0u);
  EXPECT_FALSE(apart.contact->stable_step().step < kInfinity);
  auto close = two_faces(0.5, 10);
  EXPECT_EQ(close.start().work().near_faces, 2u);
  EXPECT_LT(close.contact->stable_step().step, kInfinity);
}

// L = 0.5 m at 10 m/s: near within 0.7 m, and looked at once more before L is used up.
TEST(NearBodies, ComeBackBeforeTheyTouch) {
  auto scene = two_faces(3, 10);
  auto& contact = scene.start();
  Real gap_when_near = 0;
  int looked_far = 0;
  for (int i = 0; i < 4000 && contact.work().contacts == 0; ++i) {
    scene.step(kStep);
    const bool near = contact.work().near_faces == 2;
    if (!near) ++looked_far;
    if (near && gap_when_near == 0) {
      gap_when_near = scene.groups[1].points.x[0][0] - scene.groups[0].points.x[0][0];
    }
  }
  EXPECT_GT(contact.work().contacts, 0u);
  EXPECT_GT(looked_far, 2000);
  EXPECT_LE(gap_when_near, 0.2 + 0.5);
  EXPECT_GT(gap_when_near, 0.2 + 4 * 10 * kStep);
}

// What is far accelerates as it likes: each step counts with the speed that it had.
TEST(NearBodies, AreFoundHoweverFastTheyBecome) {
  auto scene = two_faces(50, 0);
  auto& contact = scene.start();
  const auto pull = [&] {
    for (auto& f : scene.groups[1].points.f) f[0] -= 1e5 * kMass;
  };
  bool near_in_time = false;
  for (int i = 0; i < 3000 && contact.work().contacts == 0; ++i) {
    const bool was_near = contact.work().near_faces == 2;
    scene.step(kStep, pull);
    if (contact.work().contacts > 0) near_in_time = was_near;
  }
  EXPECT_GT(contact.work().contacts, 0u);
  EXPECT_TRUE(near_in_time);
}

// The same bits whatever the skin, and over restarts in the middle of the flight: the step limit of
// each step too.
TEST(NearBodies, FollowFromTheStateAlone) {
  struct Seen {
    std::vector<std::size_t> near;
    std::vector<Real> step, x;
    bool operator==(const Seen&) const = default;
  };
  const auto fly = [](std::optional<Real> skin, int restart_every) {
    auto scene = two_faces(3, 10);
    scene.options.skin = skin;
    scene.start();
    Seen seen;
    for (int i = 0; i < 3500; ++i) {
      scene.step(kStep);
      if (restart_every > 0 && i % restart_every == 0) {
        std::vector<StateTable> tables;
        scene.contact->save_state(tables);
        scene.start().load_state(StateTables(std::move(tables)));
      }
      seen.near.push_back(scene.contact->work().near_faces);
      seen.step.push_back(scene.contact->stable_step().step);
      seen.x.push_back(scene.groups[1].points.x[0][0]);
    }
    return seen;
  };
  const Seen usual = fly({}, 0);
  EXPECT_NE(usual.near.front(), usual.near[2900]);
  EXPECT_TRUE(usual == fly(0.0, 0));
  EXPECT_TRUE(usual == fly(5.0, 0));
  EXPECT_TRUE(usual == fly({}, 7));
  EXPECT_TRUE(usual == fly({}, 641));
}

// Of three bodies the two that touch are near, whatever the third does, until it comes.
TEST(NearBodies, AreThosePairsThatMayMeet) {
  auto scene = two_faces(0.01, 0);
  auto& third = scene.add_group();
  scene.add_face(third, {{10, 1}, {10, 0}}, kStiffness, kDepth, kMass);
  EXPECT_EQ(scene.start().work().near_faces, 2u);
  EXPECT_EQ(scene.contact->work().candidates, 1u);
}

// Particles too, and heat through gaps: 3 m, of each side half.
TEST(NearBodies, ReachAsFarAsHeatPasses) {
  for (const Real gap : {0.0, 3.0}) {
    auto scene = two_faces(2.5, 0);
    ContactConductance heat;
    heat.per_area.emplace().constant = 1e4;
    heat.width = gap;
    scene.options.fallback.heat = heat;
    EXPECT_EQ(scene.start().work().near_faces, gap > 0 ? 2u : 0u) << gap;
  }
  ContactScene<2> scene;
  auto& wall = scene.add_group();
  scene.add_face(wall, {{0, 0}, {0, 1}}, kStiffness, kDepth, kMass);
  auto& body = scene.add_group();
  scene.add_particle(body, {8, 0.5}, 0.5, 1e8, kMass);
  EXPECT_EQ(scene.start().work().near_faces, 0u);
  body.points.x[0][0] = 3;
  EXPECT_EQ(scene.start().work().near_faces, 1u);
}

}  // namespace
}  // namespace brunt
