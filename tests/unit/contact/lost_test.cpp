// Contacts that did not hold are reported, and those that hold deeper than three quarters of what
// they do. Sheets and particles have a prescribed
// motion, by a known way each step, so that the step that brings them beyond their limit is known:
// the depth of the elements for faces, three radii for a particle behind a rigid face. Not reported
// is what turns back before, slides off, or was beyond the limit from when it came.
#include <gtest/gtest.h>

#include "contact/contacts/deep.hpp"
#include "tests/unit/contact/contact_scene.hpp"

namespace brunt {
namespace {

using testing::add_sheet;
using testing::ContactScene;

constexpr Real kStep = 1e-3, kDepth = 0.1;           // [s], [m]
constexpr Real kDown = 0.007, kRadius = 0.1;         // [m]
constexpr Real kRounding = 1e-14;                    // [m] of places of 1 m, after many steps
constexpr int kCells = 3, kLast = 14, kBeyond = 15;  // 14 * 7 mm = 98 mm, 105 mm
constexpr int kFirstDeep = 11;                       // 77 mm, 70 mm before
constexpr Real kSlide = 0.4;                         // [m]

/// Moves the second body by `way` in one step.
template <int Dim>
void move(ContactScene<Dim>& scene, const Vec<Dim>& way, int step) {
  auto& p = scene.groups[1].points;
  for (std::size_t i = 0; i < p.x.size(); ++i) {
    p.v[i] = way / kStep;
    p.x[i] += way;
  }
  scene.contact->add_forces(kStep, step * kStep);
}

template <int Dim>
Vec<Dim> along(int axis, Real way) {
  Vec<Dim> all = Vec<Dim>::Zero();
  all[axis] = way;
  return all;
}

template <int Dim>
LostReport lost(const ContactScene<Dim>& scene) {
  const auto pairs = scene.contact->lost_pairs();
  return pairs.empty() ? LostReport{} : pairs.at(0).lost;
}

/// Two sheets of elements that face each other, the second `deep` in the first and `aside`.
template <int Dim>
void build_sheets(ContactScene<Dim>& scene, Real deep = 0, Real aside = 0) {
  add_sheet(scene, kCells, 0, kCells, 0, true, 1e5, kDepth);
  add_sheet(scene, kCells, 0, kCells, 0, false, 1e5, kDepth);
  for (auto& x : scene.groups[1].points.x) x[Dim - 1] -= deep, x[0] += aside;
  scene.start();
}

template <int Dim>
void expect_told_of_faces() {
  ContactScene<Dim> scene;
  build_sheets(scene);
  const int pairs = Dim == 3 ? kCells * kCells : kCells;
  int step = 0;
  while (step < kFirstDeep - 1) move(scene, along<Dim>(Dim - 1, -kDown), ++step);
  EXPECT_TRUE(scene.contact->lost_pairs().empty());
  while (step < kLast) move(scene, along<Dim>(Dim - 1, -kDown), ++step);
  ASSERT_EQ(scene.contact->lost_pairs().size(), 1u);
  EXPECT_EQ(lost(scene).key.ordinal, kDeep);
  EXPECT_NEAR(lost(scene).depth, kFirstDeep * kDown, kRounding);
  EXPECT_NEAR(lost(scene).time, kFirstDeep * kStep, 1e-12);
  EXPECT_FALSE(lost(scene).any());
  EXPECT_GT(scene.contact->reports().at(0).planes, 0);
  for (; step < kBeyond + 2;) {
    move(scene, along<Dim>(Dim - 1, -kDown), ++step);
    const LostReport reported = lost(scene);
    EXPECT_EQ(reported.let_go, pairs);
    EXPECT_EQ(reported.from_behind, 0);
    EXPECT_EQ(reported.time, kBeyond * kStep);
    EXPECT_NEAR(reported.depth, kBeyond * kDown, kRounding);
    EXPECT_NEAR(reported.point[Dim - 1], -0.5 * kBeyond * kDown, kRounding) << "half way";
    EXPECT_EQ(reported.key.ordinal, kLetGo);
  }
  EXPECT_EQ(scene.contact->reports().at(0).planes, 0);
  while (step < kBeyond + 4) move(scene, along<Dim>(Dim - 1, kDown), ++step);
  EXPECT_EQ(lost(scene).from_behind, 0);
  move(scene, along<Dim>(Dim - 1, kDown), ++step);
  EXPECT_EQ(lost(scene).let_go, pairs);
  EXPECT_EQ(lost(scene).from_behind, pairs);
  EXPECT_EQ(lost(scene).time, kBeyond * kStep) << "the first";
  // They come out without a push, and are felt by what they close again: 98 mm to 91 mm and back.
  EXPECT_EQ(scene.contact->reports().at(0).planes, 0);
  move(scene, along<Dim>(Dim - 1, kDown), ++step);
  EXPECT_EQ(scene.contact->reports().at(0).planes, 0);
  move(scene, along<Dim>(Dim - 1, -kDown), ++step);
  EXPECT_EQ(scene.contact->reports().at(0).planes, pairs);
  EXPECT_NEAR(scene.contact->reports().at(0).max_penetration, kDown, kRounding);
  EXPECT_EQ(lost(scene).from_behind, pairs);
}

TEST(LostContacts, AreToldOfFaces) {
  expect_told_of_faces<2>();
  expect_told_of_faces<3>();
}

template <int Dim>
void expect_silence_of_faces() {
  ContactScene<Dim> back;  // as deep as they may come, and back
  build_sheets(back);
  for (int n = 1; n <= kLast; ++n) move(back, along<Dim>(Dim - 1, -kDown), n);
  for (int n = 1; n <= kLast + 1; ++n) move(back, along<Dim>(Dim - 1, kDown), kLast + n);
  EXPECT_EQ(back.contact->reports().at(0).planes, 0);
  EXPECT_FALSE(lost(back).any()) << Dim;

  ContactScene<Dim> off;  // as deep, and off over the border
  build_sheets(off);
  for (int n = 1; n <= kLast; ++n) move(off, along<Dim>(Dim - 1, -kDown), n);
  for (int n = 1; n <= 9; ++n) move(off, along<Dim>(0, kSlide), kLast + n);
  EXPECT_EQ(off.contact->reports().at(0).planes, 0);
  EXPECT_FALSE(lost(off).any()) << Dim;

  ContactScene<Dim> beyond;  // from aside, beyond the limit all the time, deeper, and aside
  build_sheets(beyond, 1.2 * kDepth, -kCells - kSlide);
  int step = 0;
  while (step < 5) move(beyond, along<Dim>(0, kSlide), ++step);
  move(beyond, along<Dim>(Dim - 1, -0.1 * kDepth), ++step);
  while (step < 20) move(beyond, along<Dim>(0, kSlide), ++step);
  EXPECT_FALSE(lost(beyond).any()) << Dim;
}

TEST(LostContacts, AreNotFacesThatTurnBackSlideOffOrAreSeenFromBehind) {
  expect_silence_of_faces<2>();
  expect_silence_of_faces<3>();
}

constexpr Real kStart = 0.06;  // [m] before the sheet: the particle touches it
constexpr int kBehind = 52;    // 60 mm - 52 * 7 mm = -304 mm, beyond 3 r

/// A particle that touches a rigid sheet from before.
template <int Dim>
void build_particle(ContactScene<Dim>& scene) {
  add_sheet(scene, kCells, 0, kCells, 0, true, 0, 0);
  Vec<Dim> x = Vec<Dim>::Constant(1.3);
  x[Dim - 1] = kStart;
  scene.add_particle(scene.add_group(), x, kRadius, 1e4, 1);
  scene.start();
}

template <int Dim>
void expect_told_of_a_particle() {
  ContactScene<Dim> scene;
  build_particle(scene);
  int step = 0;
  while (step < kBehind - 1) move(scene, along<Dim>(Dim - 1, -kDown), ++step);
  EXPECT_FALSE(lost(scene).any());
  EXPECT_EQ(scene.contact->reports().at(0).planes, 1);
  while (step < kBehind + 3) {
    move(scene, along<Dim>(Dim - 1, -kDown), ++step);
    const LostReport reported = lost(scene);
    EXPECT_EQ(reported.let_go, 1);
    EXPECT_EQ(reported.time, kBehind * kStep);
    EXPECT_NEAR(reported.depth, kBehind * kDown - kStart, kRounding);
    EXPECT_NEAR(reported.point[0], 1.3, kRounding);
    EXPECT_NEAR(reported.point[Dim - 1], 0, kRounding);
  }
  // What is saved and taken back is what was reported, and the same step tells no more.
  std::vector<StateTable> tables;
  scene.contact->save_state(tables);
  ContactScene<Dim> again;
  build_particle(again);
  for (std::size_t g = 0; g < 2; ++g) {
    again.groups[g].points.x = scene.groups[g].points.x;
    again.groups[g].points.v = scene.groups[g].points.v;
  }
  again.contact->load_state(StateTables(tables));
  EXPECT_EQ(lost(again).let_go, 1);
  EXPECT_EQ(lost(again).time, lost(scene).time);
  EXPECT_EQ(lost(again).depth, lost(scene).depth);
}

TEST(LostContacts, AreToldOfParticles) {
  expect_told_of_a_particle<2>();
  expect_told_of_a_particle<3>();
}

TEST(LostContacts, AreToldOfAParticleThatWasDeepBeforeARestart) {
  // Saved one step before it is given up: the step that gives it up is reported by the second run.
  ContactScene<3> scene;
  build_particle(scene);
  for (int n = 1; n < kBehind; ++n) move(scene, along<3>(2, -kDown), n);
  std::vector<StateTable> tables;
  scene.contact->save_state(tables);
  ContactScene<3> again;
  build_particle(again);
  for (std::size_t g = 0; g < 2; ++g) {
    again.groups[g].points.x = scene.groups[g].points.x;
    again.groups[g].points.v = scene.groups[g].points.v;
  }
  again.contact->load_state(StateTables(tables));
  EXPECT_FALSE(lost(again).any());
  move(again, along<3>(2, -kDown), kBehind);
  EXPECT_EQ(lost(again).let_go, 1);
  EXPECT_EQ(lost(again).time, kBehind * kStep);
}

TEST(LostContacts, AreNotParticlesThatTurnBackOrSlideOff) {
  ContactScene<3> back;
  build_particle(back);
  for (int n = 1; n < kBehind; ++n) move(back, along<3>(2, -kDown), n);
  for (int n = 0; n < kBehind + 20; ++n) move(back, along<3>(2, kDown), kBehind + n);
  EXPECT_EQ(back.contact->reports().at(0).planes, 0);
  EXPECT_FALSE(lost(back).any());

  ContactScene<3> off;
  build_particle(off);
  for (int n = 1; n < kBehind; ++n) move(off, along<3>(2, -kDown), n);
  for (int n = 0; n < 6; ++n) move(off, along<3>(0, kSlide), kBehind + n);
  EXPECT_EQ(off.contact->reports().at(0).planes, 0);
  EXPECT_FALSE(lost(off).any());
}

}  // namespace
}  // namespace brunt
