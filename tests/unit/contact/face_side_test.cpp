// What friction reads of a face. With r the corners about their mean and v their velocities:
//   J w = torque,  J = sum |r|^2 I - r r^T;   moment = sum r x v
// A force F shared as w_a F + (J^-1 c) x r_a has the power F . sum w_a v_a + (J^-1 c) . moment, for
// (w x r) . v = w . (r x v). Sums of some tens of terms of order 1: 1e-13.
#include "contact/surfaces/face_side.hpp"

#include <gtest/gtest.h>

#include <random>

#include "contact/contacts/friction.hpp"
#include "contact/contacts/record.hpp"

namespace brunt {
namespace {

constexpr Real kRounding = 1e-13;

template <int Dim>
ContactNodes<Dim> random_nodes(std::size_t n, std::mt19937_64& random) {
  std::uniform_real_distribution<Real> number(-1, 1);
  ContactNodes<Dim> nodes;
  nodes.x.resize(n), nodes.v.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    for (int c = 0; c < Dim; ++c) nodes.x[i][c] = number(random), nodes.v[i][c] = number(random);
  }
  return nodes;
}

TEST(FaceSide, TurnsAsTheInertiaOfItsCorners) {
  std::mt19937_64 random(1);
  for (int k = 0; k < 100; ++k) {
    const auto nodes = random_nodes<3>(4, random);
    const std::array<LocalIndex, 4> corner{0, 1, 2, 3};
    for (const std::size_t n : {3U, 4U}) {
      FaceSide<3> side;
      side.set(nodes, std::span(corner).first(n));
      Vec3 mean = Vec3::Zero(), moment = Vec3::Zero();
      for (std::size_t i = 0; i < n; ++i) mean += nodes.x[i] / static_cast<Real>(n);
      Eigen::Matrix3d J = Eigen::Matrix3d::Zero();
      for (std::size_t i = 0; i < n; ++i) {
        const Vec3 r = nodes.x[i] - mean;
        J += r.squaredNorm() * Eigen::Matrix3d::Identity() - r * r.transpose();
        moment += r.cross(nodes.v[i]);
      }
      const Vec3 torque(1, -2, 0.5);
      const Real condition = 1 / (J.inverse().norm() * J.norm());
      EXPECT_LT((J * side.turn(torque) - torque).norm() * condition, kRounding) << k;
      EXPECT_LT((side.mean - mean).norm(), kRounding);
      EXPECT_LT((side.moment - moment).norm(), 10 * kRounding);
    }
  }
}

TEST(FaceSide, AFaceAsThinAsALineDoesNotTurn) {
  ContactNodes<3> nodes;
  nodes.v.assign(4, Vec3(0, 0, 1));
  for (const Real s : {0.0, 1.0, 2.0, 5.0}) nodes.x.push_back(s * Vec3(1, 2, 3));
  const std::array<LocalIndex, 4> corner{0, 1, 2, 3};
  FaceSide<3> side;
  side.set(nodes, corner);
  EXPECT_EQ(side.turn(Vec3(1, 1, 1)), Vec3(0, 0, 0));
  side.set(nodes, LocalIndex{2});
  EXPECT_EQ(side.turn(Vec3(1, 1, 1)), Vec3(0, 0, 0));
  EXPECT_EQ(side.mean, nodes.x[2]);
  EXPECT_EQ(side.moment, Vec3(0, 0, 0));
}

TEST(FaceSide, AnEdgeTurnsAsItsEnds) {
  std::mt19937_64 random(2);
  const auto nodes = random_nodes<2>(2, random);
  const std::array<LocalIndex, 2> corner{0, 1};
  FaceSide<2> side;
  side.set(nodes, corner);
  const Vec<2> r = 0.5 * (nodes.x[1] - nodes.x[0]), v = 0.5 * (nodes.v[1] - nodes.v[0]);
  EXPECT_NEAR(side.turn(3), 3 / (2 * r.squaredNorm()), 10 * kRounding);
  EXPECT_NEAR(side.moment, 2 * (r[0] * v[1] - r[1] * v[0]), kRounding);
}

/// Friction of two random quads, with their sides known or not.
Friction<3> friction_of(const ContactNodes<3>& nodes, bool known) {
  ContactRecord<3> record;
  record.normal = Vec3(0.6, 0, 0.8);
  record.point = Vec3::Zero();
  record.spring = 7;
  for (LocalIndex i = 0; i < 8; ++i) record.add(i, 0.25);
  PairOptions options;
  options.coulomb.friction.emplace().constant = 0.3;
  const PairLaws laws(options, false);
  FrictionStep<3> step;
  step.laws = &laws;
  step.lower = {0, 4, true}, step.upper = {4, 8, true};
  step.weight = {0.1, 0.2, 0.3, 0.4, 0.4, 0.3, 0.2, 0.1};
  step.area = step.pressed = 2;
  step.stiffness = 5, step.damping = 0.1, step.dt = 0.01;
  FaceSide<3> lower, upper;
  const std::array<LocalIndex, 8> corner{0, 1, 2, 3, 4, 5, 6, 7};
  lower.set(nodes, std::span(corner).first(4)), upper.set(nodes, std::span(corner).last(4));
  if (known) step.lower_face = &lower, step.upper_face = &upper;
  Friction<3> friction;
  find_friction(nodes, record, step, friction);
  return friction;
}

TEST(FaceSide, FrictionIsTheSameWhetherASideIsKnownOrNot) {
  std::mt19937_64 random(3);
  for (int k = 0; k < 100; ++k) {
    const auto nodes = random_nodes<3>(8, random);
    const auto known = friction_of(nodes, true), found = friction_of(nodes, false);
    Real power = 0;
    for (std::size_t i = 0; i < 8; ++i) {
      EXPECT_EQ(known.force[i], found.force[i]) << k;
      power += known.force[i].dot(nodes.v[i]);
    }
    EXPECT_EQ(known.pairs, found.pairs);
    // Half of what the new forces take: what is not heat, stored or damped is of the pair.
    const Real taken = known.heat + known.stored + known.damped + known.pairs;
    EXPECT_NEAR(taken, -0.5 * 0.01 * power, kRounding) << k;
  }
}

}  // namespace
}  // namespace brunt
