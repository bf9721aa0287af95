// What pairs keep from time 0: overlaps that are taken
// out, bonds of cohesion and tension. Two faces whose springs S = M/h are equal have k = phi S / 2
// per area, along the normal and across it.
#include "contact/contacts/first_touch.hpp"

#include <gtest/gtest.h>

#include "tests/unit/contact/contact_scene.hpp"

namespace brunt {
namespace {

using testing::add_sheet;
using testing::ContactScene;

constexpr Real kSide = 1e6;  // [Pa/m] S of each face
constexpr Real kSpring = 0.5 * kSide / 2;
constexpr Real kRounding = 1e-9 * kSpring;  // [N] of forces made of positions of size 1 m

/// Two sheets of 1 m^2 (1 m in 2D), the upper one `overlap` [m] inside the lower one.
template <int Dim>
ContactScene<Dim> sheets(Real overlap, const std::function<void(PairOptions&)>& set = {}) {
  ContactScene<Dim> scene;
  scene.options.fallback.damping = 0;
  scene.options.fallback.initial_overlap = InitialOverlap::track;
  if (set) set(scene.options.fallback);
  add_sheet(scene, 2, 0, 1, overlap, true, kSide, 1);
  add_sheet(scene, 3, 0, 1, 0, false, kSide, 1);
  scene.start();
  return scene;
}

/// Moves the upper body and returns the force on it [N].
template <int Dim>
Vec<Dim> shift(ContactScene<Dim>& scene, const Vec<Dim>& by) {
  constexpr Real kStep = 1e-3;
  auto& p = scene.groups[1].points;
  for (auto& group : scene.groups) {
    for (auto& f : group.points.f) f.setZero();
  }
  for (std::size_t i = 0; i < p.x.size(); ++i) {
    p.x[i] += by;
    p.v[i] = by / kStep;
  }
  scene.contact->add_forces(kStep);
  return scene.force(1);
}

/// The test's lengths along the normal, the last axis.
template <int Dim>
Vec<Dim> up(Real by) {
  return by * Vec<Dim>::Unit(Dim - 1);
}

Real energy(const Totals<3>& totals) {
  Real sum = 0;
  for (const auto& column : totals.columns) sum += column.value();
  return sum;
}

template <int Dim>
void expect_overlap_is_taken_out() {
  auto scene = sheets<Dim>(0.1);
  const auto found = scene.contact->initial_overlaps();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].name, "b0-b1");
  EXPECT_NEAR(found[0].deepest, 0.1, 1e-15);
  EXPECT_LT(shift<Dim>(scene, up<Dim>(0)).norm(), kRounding);
  // Closer by 0.02: that alone is felt, and given back.
  EXPECT_NEAR(shift<Dim>(scene, up<Dim>(-0.02))[Dim - 1], kSpring * 0.02, kRounding);
  EXPECT_LT(shift<Dim>(scene, up<Dim>(0.02)).norm(), kRounding);
  // Opened by 0.03, of which no more than 0.07 is left: back at 0.1, 0.03 is felt.
  EXPECT_LT(shift<Dim>(scene, up<Dim>(0.03)).norm(), kRounding);
  EXPECT_NEAR(shift<Dim>(scene, up<Dim>(-0.03))[Dim - 1], kSpring * 0.03, kRounding);
  // Apart: nothing is left, and the whole overlap counts.
  EXPECT_LT(shift<Dim>(scene, up<Dim>(0.2)).norm(), kRounding);
  EXPECT_TRUE(scene.contact->initial_overlaps().empty());
  EXPECT_NEAR(shift<Dim>(scene, up<Dim>(-0.2))[Dim - 1], kSpring * 0.1, kRounding);
}
TEST(FirstTouch, OverlapOfFacesIsTakenOut) { expect_overlap_is_taken_out<3>(); }
TEST(FirstTouch, OverlapOfEdgesIsTakenOut) { expect_overlap_is_taken_out<2>(); }

// Closing from a tracked overlap and coming back leaves no energy; nor does opening it.
TEST(FirstTouch, OverlapTakenOutHasNoEnergy) {
  auto scene = sheets<3>(0.1);
  for (const Real by : {0.0, -0.01, -0.01, 0.02, 0.03, 0.03, 0.05}) {
    shift<3>(scene, up<3>(by));
    if (by < 0) continue;
    EXPECT_LT(std::fabs(energy(scene.totals())), 1e-12 * kSpring) << by;
  }
  shift<3>(scene, up<3>(-0.01));  // still open by what was 0.1
  EXPECT_LT(std::fabs(energy(scene.totals())), 1e-12 * kSpring);
}

TEST(FirstTouch, OverlapPressesWhereAsked) {
  auto scene = sheets<3>(0.1, [](auto& pair) { pair.initial_overlap = InitialOverlap::press; });
  EXPECT_TRUE(scene.contact->initial_overlaps().empty());
  EXPECT_NEAR(shift<3>(scene, up<3>(0))[2], kSpring * 0.1, kRounding);
}

// A pair that is seen first after time 0 is given no offset: sheets that start beside each other.
TEST(FirstTouch, NobodyElseIsGivenOne) {
  auto scene = sheets<3>(-0.5);
  EXPECT_NEAR(shift<3>(scene, up<3>(-0.6))[2], kSpring * 0.1, kRounding);
}

// A particle 0.04 too deep in a corner of two walls: it feels what it closes to each of them.
TEST(FirstTouch, OverlapOfAParticleIsTakenOut) {
  ContactScene<3> scene;
  scene.options.fallback.initial_overlap = InitialOverlap::track;
  scene.options.fallback.damping = 0;
  scene.options.fallback.stiffness = 1;
  add_sheet(scene, 2, -1, 2, 0, true, 0, 0);
  const Real r = 0.25, stiffness = 1e3;
  scene.add_particle(scene.add_group(), Vec3(0.1, 0.2, r - 0.04), r, stiffness / (2 * r), 1);
  scene.start();
  ASSERT_EQ(scene.contact->initial_overlaps().size(), 1u);
  EXPECT_NEAR(scene.contact->initial_overlaps()[0].deepest, 0.04, 1e-15);
  EXPECT_LT(shift<3>(scene, up<3>(0)).norm(), 1e-9 * stiffness);
  EXPECT_NEAR(shift<3>(scene, up<3>(-0.01))[2], 0.01 * stiffness, 1e-9 * stiffness);
  EXPECT_LT(shift<3>(scene, up<3>(0.03)).norm(), 1e-9 * stiffness);
  EXPECT_NEAR(shift<3>(scene, up<3>(-0.02))[2], 0.02 * stiffness, 1e-9 * stiffness);
}

constexpr Real kTension = 2e3, kCohesion = 3e3, kCoefficient = 0.5;  // [Pa], [Pa], [1]

void bond(PairOptions& pair) {
  std::get<CohesiveBond>(pair.bonds) = {kCohesion, kTension};
  Varying friction;
  friction.constant = kCoefficient;
  pair.coulomb.friction = friction;
}

// Pulled apart, k g per area holds to the tensile strength; then the bond has gone, with its
// T^2 / 2k per area, and a pull meets nothing. Steps of 1 % of T / k: the last one that held stored
// less than T^2 / 2k, and the one that broke no more than 1.01^2 of it.
template <int Dim>
void expect_bond_tears() {
  auto scene = sheets<Dim>(0, bond);
  const Real limit = kTension / kSpring;
  for (int i = 1; i < 100; ++i) {
    ASSERT_NEAR(shift<Dim>(scene, up<Dim>(0.01 * limit))[Dim - 1], -0.01 * i * kTension,
                1e-6 * kTension)
        << i;
  }
  shift<Dim>(scene, up<Dim>(0.005 * limit));
  EXPECT_LT(shift<Dim>(scene, up<Dim>(0.01 * limit)).norm(), 1e-9 * kTension);
  const auto totals = scene.totals();
  const Real stored = 0.5 * kTension * limit;
  EXPECT_NEAR(totals.value(Column::contact_pairs), stored, 0.02 * stored);
  // What tore is booked at the opening at which it tore; the force fell to none over that step.
  EXPECT_NEAR(totals.value(Column::contact_spring), 0, 0.02 * stored);
  // Closed again it pushes, and pulls no more.
  EXPECT_NEAR(shift<Dim>(scene, up<Dim>(-1.025 * limit))[Dim - 1], 0.02 * kTension,
              1e-6 * kTension);
  EXPECT_LT(shift<Dim>(scene, up<Dim>(0.5 * limit)).norm(), 1e-9 * kTension);
}
TEST(FirstTouch, BondOfFacesTears) { expect_bond_tears<3>(); }
TEST(FirstTouch, BondOfEdgesTears) { expect_bond_tears<2>(); }

// Sheared under a pressure p, the bond holds to c + mu p; once it has slipped mu p is left. After a
// way w the sheets share 1 - w of their length, and so do the forces.
template <int Dim>
void expect_bond_slips() {
  auto scene = sheets<Dim>(0, bond);
  const Real closed = 0.004, push = kSpring * closed;
  shift<Dim>(scene, up<Dim>(-closed));
  const Real limit = kCohesion + kCoefficient * push, step = 0.1 * limit / kSpring;
  const auto drag = [&] { return shift<Dim>(scene, Vec<Dim>(step * Vec<Dim>::Unit(0)))[0]; };
  for (int i = 1; i < 10; ++i) {
    ASSERT_NEAR(drag(), -0.1 * i * limit * (1 - i * step), 1e-6 * limit) << i;
  }
  drag();
  drag();
  const Real left = kCoefficient * push;
  EXPECT_NEAR(drag(), -left * (1 - 12 * step), 1e-6 * left);
  EXPECT_NEAR(drag(), -left * (1 - 13 * step), 1e-6 * left);
}
TEST(FirstTouch, BondOfFacesSlips) { expect_bond_slips<3>(); }
TEST(FirstTouch, BondOfEdgesSlips) { expect_bond_slips<2>(); }

// Faces that do not touch at time 0 are never bonded.
TEST(FirstTouch, OnlyWhatTouchesIsBonded) {
  auto scene = sheets<3>(-0.01, bond);
  shift<3>(scene, up<3>(-0.02));
  EXPECT_LT(shift<3>(scene, up<3>(0.011)).norm(), kRounding);
}

// What is kept goes through a checkpoint: a twin that takes over in the middle does the same.
TEST(FirstTouch, OutlivesACheckpoint) {
  const auto press_and_bond = [](PairOptions& pair) {
    bond(pair), std::get<CohesiveBond>(pair.bonds).tension *= 100;
  };
  auto scene = sheets<3>(0.1, press_and_bond), twin = sheets<3>(0.1, press_and_bond);
  shift<3>(scene, Vec3(0, 0, -0.02));
  shift<3>(scene, Vec3(1e-3, 0, 0.03));
  for (std::size_t g = 0; g < 2; ++g) twin.groups[g].points = scene.groups[g].points;
  std::vector<StateTable> tables;
  scene.contact->save_state(tables);
  twin.contact->load_state(StateTables(tables));
  EXPECT_EQ(twin.totals().state_hash, scene.totals().state_hash);
  for (const Vec3& by : {Vec3(1e-3, 0, 0), Vec3(0, 2e-3, -0.03), Vec3(0, 0, 0.02)}) {
    EXPECT_EQ(shift<3>(twin, by), shift<3>(scene, by));
    EXPECT_EQ(twin.totals().state_hash, scene.totals().state_hash);
  }
}

}  // namespace
}  // namespace brunt
