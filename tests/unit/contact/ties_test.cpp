// Sheets and particles that are held from time 0 on: forces by hand, no moment, no drift however
// they turn, what breaking leaves in the books.
#include "contact/evaluate/ties.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "contact/geometry/face_couple.hpp"
#include "tests/unit/contact/contact_scene.hpp"

namespace brunt {
namespace {

using testing::add_sheet;
using testing::ContactScene;

constexpr Real kSheet = 1e6;                              // [Pa/m] M/h of each face
constexpr Real kTieSpring = kTiedStiffness * kSheet / 2;  // [Pa/m] both in series

/// Two sheets of 1 m^2 (1 m in 2D) on each other, n faces below and m above a side.
template <int Dim>
ContactScene<Dim> tied_sheets(int n, int m, const std::function<void(PairOptions&)>& set = {}) {
  ContactScene<Dim> scene;
  scene.options.fallback.damping = 0;
  scene.options.fallback.tied = true;
  scene.options.fallback.initial_overlap = InitialOverlap::track;
  if (set) set(scene.options.fallback);
  add_sheet(scene, n, 0, 1, 0, true, kSheet, 1);
  add_sheet(scene, m, 0, 1, 0, false, kSheet, 1);
  scene.start();
  return scene;
}

template <int Dim>
void move_points(ContactScene<Dim>& scene, std::size_t group,
                 const std::function<Vec<Dim>(const Vec<Dim>&)>& to, Real dt) {
  auto& p = scene.groups[group].points;
  for (std::size_t i = 0; i < p.x.size(); ++i) {
    const Vec<Dim> at = to(p.x[i]);
    p.v[i] = (at - p.x[i]) / dt;
    p.x[i] = at;
  }
}
template <int Dim>
Vec<Dim> tied_shift(ContactScene<Dim>& scene, const Vec<Dim>& by) {
  constexpr Real kStep = 1e-3;
  for (auto& group : scene.groups) {
    for (auto& f : group.points.f) f.setZero();
    for (auto& v : group.points.v) v.setZero();
  }
  move_points<Dim>(
      scene, 1, [&](const Vec<Dim>& x) { return Vec<Dim>(x + by); }, kStep);
  scene.contact->add_forces(kStep);
  return scene.force(1);
}

template <int Dim>
void expect_springs_in_all_directions() {
  auto scene = tied_sheets<Dim>(2, 3);
  for (int c = 0; c < Dim; ++c) {
    for (const Real by : {1e-3, -1e-3}) {
      const Vec<Dim> shift = by * Vec<Dim>::Unit(c);
      const Vec<Dim> force = tied_shift<Dim>(scene, shift);
      EXPECT_LT((force + kTieSpring * shift).norm(), 1e-9 * kTieSpring * 1e-3) << c << " " << by;
      EXPECT_LT((scene.force(0) + force).norm(), 1e-12 * kTieSpring * 1e-3);
      const auto totals = scene.totals();
      EXPECT_NEAR(totals.value(Column::contact_spring), 0.5 * kTieSpring * 1e-6, 1e-9);
      EXPECT_NEAR(totals.value(Column::contact_pairs), 0, 1e-9);
      tied_shift<Dim>(scene, -shift);
    }
  }
}
TEST(Ties, FacesHangOnSpringsInAllDirections) { expect_springs_in_all_directions<3>(); }
TEST(Ties, EdgesHangOnSpringsInAllDirections) { expect_springs_in_all_directions<2>(); }

// A constant traction gives the corners what it gives them on one matching mesh: half of each face
// at its ends in 2D, a quarter in 3D. So the patch test holds on any meshes.
TEST(Ties, ShareAConstantTractionConsistently) {
  auto scene = tied_sheets<3>(2, 3);
  tied_shift<3>(scene, Vec3(0, 0, 1e-3));
  const auto& below = scene.groups[0].points;
  for (std::size_t i = 0; i < below.x.size(); ++i) {
    Real area = 0.25;
    for (const int c : {0, 1}) {
      if (below.x[i][c] < 1e-9 || below.x[i][c] > 1 - 1e-9) area *= 0.5;
    }
    EXPECT_NEAR(below.f[i][2], area * kTieSpring * 1e-3, 1e-9 * kTieSpring * 1e-3);
  }
}

template <int Dim>
using Turn = Eigen::Matrix<Real, Dim, Dim>;
template <int Dim>
Turn<Dim> turn_by(Real angle) {
  if constexpr (Dim == 2) {
    Turn<2> q;
    q << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
    return q;
  } else {
    return Eigen::AngleAxis<Real>(angle, Vec3(0.3, -0.5, 0.8).normalized()).toRotationMatrix();
  }
}

// Both sheets turned as one, ten times around in steps of 0.1 rad, with the upper one pulled off by
// a millimetre along a fixed direction of theirs: the force turns with them and does not change.
template <int Dim>
void expect_no_drift() {
  auto scene = tied_sheets<Dim>(
      2, 3, [](auto& pair) { pair.joint = JointSpring{.normal = 2e5, .shear = 1e5}; });
  Vec<Dim> pulled = Vec<Dim>::Constant(1e-3);
  const Vec<Dim> start = tied_shift<Dim>(scene, pulled);
  EXPECT_NEAR(start[0], -1e5 * 1e-3, 1e-6);
  EXPECT_NEAR(start[Dim - 1], -2e5 * 1e-3, 1e-6);
  const Real energy = scene.totals().value(Column::contact_spring);
  const Turn<Dim> step = turn_by<Dim>(0.1);
  Turn<Dim> turned = Turn<Dim>::Identity();
  for (int n = 0; n < 628; ++n) {
    for (auto& group : scene.groups) {
      for (auto& f : group.points.f) f.setZero();
    }
    for (const std::size_t g : {0u, 1u}) {
      move_points<Dim>(
          scene, g, [&](const Vec<Dim>& x) { return Vec<Dim>(step * x); }, 1e-3);
    }
    turned = step * turned;
    scene.contact->add_forces(1e-3);
  }
  EXPECT_LT((scene.force(1) - turned * start).norm(), 1e-9 * start.norm());
  EXPECT_NEAR(scene.totals().value(Column::contact_spring), energy, 1e-9 * energy);
}
TEST(Ties, TurnWithTheirFaces) { expect_no_drift<3>(); }
TEST(Ties, TurnWithTheirEdges) { expect_no_drift<2>(); }

// Random warped shifts of all points: no force and no moment of both sides together, though joint
// springs along the normal and across differ.
template <int Dim>
void expect_momentum() {
  std::mt19937 random(5);
  std::uniform_real_distribution<Real> any(-1e-2, 1e-2);
  for (int trial = 0; trial < 20; ++trial) {
    auto scene = tied_sheets<Dim>(
        2, 3, [](auto& pair) { pair.joint = JointSpring{.normal = 5e5, .shear = 1e5}; });
    for (auto& group : scene.groups) {
      for (auto& x : group.points.x) {
        for (int c = 0; c < Dim; ++c) x[c] += any(random);
      }
      for (auto& f : group.points.f) f.setZero();
    }
    scene.contact->add_forces(1e-3);
    Vec<Dim> sum = Vec<Dim>::Zero();
    auto moment = torque_at(sum, sum);
    Real size = 0;
    for (const auto& group : scene.groups) {
      for (std::size_t i = 0; i < group.points.x.size(); ++i) {
        sum += group.points.f[i];
        moment += torque_at(group.points.x[i], group.points.f[i]);
        size += group.points.f[i].norm();
      }
    }
    ASSERT_GT(size, 100);
    EXPECT_LT(sum.norm(), 1e-12 * size);
    if constexpr (Dim == 2) {
      EXPECT_LT(std::fabs(moment), 1e-12 * size);
    } else {
      EXPECT_LT(moment.norm(), 1e-12 * size);
    }
  }
}
TEST(Ties, FacesKeepMomentumAndItsMoment) { expect_momentum<3>(); }
TEST(Ties, EdgesKeepMomentumAndItsMoment) { expect_momentum<2>(); }

// Pulled beyond its tension it lets go for good, and what its springs held is used up.
TEST(Ties, BreakByTensionForGood) {
  auto scene = tied_sheets<3>(2, 3, [](auto& pair) {
    std::get<CohesiveBond>(pair.bonds) = {0, 1e3};
  });
  const Real at = 1e3 / kTieSpring;
  EXPECT_NEAR(tied_shift<3>(scene, Vec3(0, 0, 0.99 * at))[2], -990, 1e-6);
  const auto before = scene.totals();
  EXPECT_EQ(before.value(Column::contact_friction), 0);
  EXPECT_EQ(tied_shift<3>(scene, Vec3(0, 0, 0.02 * at)).norm(), 0);
  const auto after = scene.totals();
  EXPECT_EQ(after.value(Column::contact_spring), 0);
  // 1/2 k (1.01 a)^2 less what its force would have taken in the second half of the step.
  const Real released = 0.5 * kTieSpring * at * at * (1.01 * 1.01 - 1.01 * 0.02);
  EXPECT_NEAR(after.value(Column::contact_friction), released, 1e-6 * released);
  EXPECT_NEAR(after.value(Column::contact_pairs), 0, 1e-9);
  EXPECT_EQ(tied_shift<3>(scene, Vec3(0, 0, -0.5 * at)).norm(), 0);
  // Then it is a contact like others.
  EXPECT_NEAR(tied_shift<3>(scene, Vec3(0, 0, -0.61 * at))[2], 0.1 * at * 0.5 * kSheet / 2, 1e-3);
}

TEST(Ties, BreakByShearBeyondCohesionAndFriction) {
  auto scene = tied_sheets<3>(1, 1, [](auto& pair) {
    std::get<CohesiveBond>(pair.bonds) = {1e3, 0};
    pair.coulomb.friction.emplace().constant = 0.5;
  });
  const Real at = 1e3 / kTieSpring;
  tied_shift<3>(scene, Vec3(0, 0, -at));  // pressed by 1 kPa: 1.5 kPa of shear hold
  EXPECT_NEAR(tied_shift<3>(scene, Vec3(1.49 * at, 0, 0))[0], -1490, 1e-6);
  const Vec3 slides = tied_shift<3>(scene, Vec3(0.02 * at, 0, 0));
  EXPECT_LT(std::fabs(slides[0]), 0.5 * slides[2] * (1 + 1e-9));
  EXPECT_GT(slides[2], 0);
}

// A particle hangs on the nearest face by springs of its section, in all directions.
TEST(Ties, ParticlesHangOnFaces) {
  ContactScene<3> scene;
  scene.options.fallback.tied = true;
  add_sheet(scene, 2, 0, 1, 0, true, kSheet, 1);
  scene.add_particle(scene.add_group(), Vec3(0.3, 0.2, 0.05), 0.05, 1e5, 1);
  scene.start();
  // M/2r of the particle and M/h of the face in series, by (2r)^2.
  const Real spring = kTiedStiffness * kSheet / 2 * 0.01;
  for (const Vec3& by : {Vec3(1e-3, 0, 0), Vec3(0, -1e-3, 0), Vec3(0, 0, 1e-3)}) {
    const Vec3 force = tied_shift<3>(scene, by);
    EXPECT_LT((force + spring * by).norm(), 1e-9 * spring * 1e-3);
    EXPECT_LT((scene.force(0) + force).norm(), 1e-12 * spring * 1e-3);
    Vec3 moment = Vec3::Zero();
    for (const auto& group : scene.groups) {
      for (std::size_t i = 0; i < group.points.x.size(); ++i) {
        moment += group.points.x[i].cross(group.points.f[i]);
      }
    }
    EXPECT_LT(moment.norm(), 1e-12 * spring * 1e-3);
    tied_shift<3>(scene, -by);
  }
}

// Sheets that are joined, not tied, begin without a bond; their spring is the joint's.
TEST(Ties, AJointWithoutStrengthPressesAlone) {
  auto scene = tied_sheets<3>(2, 2, [](auto& pair) {
    pair.tied = false;
    pair.joint = JointSpring{.normal = 1e5, .shear = {}, .closures = {HyperbolicClosure{1e-2}, {}}};
  });
  EXPECT_EQ(tied_shift<3>(scene, Vec3(0, 0, 1e-3)).norm(), 0);
  EXPECT_NEAR(tied_shift<3>(scene, Vec3(0, 0, -6e-3))[2], 1e5 * 5e-3 / 0.5, 1e-6);
  // Closed to x = 0.5: open at 0.25 V, which it keeps though it opens and slides off and back.
  EXPECT_EQ(tied_shift<3>(scene, Vec3(0, 0, 2.6e-3)).norm(), 0);
  for (const Vec3& by : {Vec3(0, 0, 0.1), Vec3(3, 0, 0), Vec3(-3, 0, 0), Vec3(0, 0, -0.1)}) {
    EXPECT_EQ(tied_shift<3>(scene, by).norm(), 0);
  }
  EXPECT_NEAR(tied_shift<3>(scene, Vec3(0, 0, -1.1e-3))[2], 4e5 * 1e-3, 1e-6);
  EXPECT_NEAR(scene.totals().value(Column::contact_friction), 0.06815 * 1e5 * 1e-4, 1e-4);
}

}  // namespace
}  // namespace brunt
