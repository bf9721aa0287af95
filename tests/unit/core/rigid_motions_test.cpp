// Points that have a prescribed motion have its velocity from time 0 on, whatever stands before
// them; those of free bodies keep theirs. Of a motion with v and a spin w about z through c it is
// v + w (-(y - c_y), x - c_x).
#include "core/boundaries/rigid_motions.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace brunt {
namespace {

/// Points at x = 0, 1, 2 .. [m], of a body each.
Points<2> on_a_line(const std::vector<Label>& bodies) {
  Points<2> points;
  points.resize(static_cast<LocalIndex>(bodies.size()));
  points.body = bodies;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    points.id[i] = i;
    points.x[i] = points.x_start[i] = Vec<2>(static_cast<Real>(i), 0);
    points.v[i] = Vec<2>(7, 7);
  }
  return points;
}

TEST(RigidMotions, BeginBehindFreeBodies) {
  constexpr Label kFree = 0, kDriven = 1, kHeld = 2;
  Points<2> first = on_a_line({kFree, kDriven, kFree, kHeld, kDriven});
  Points<2> second = on_a_line({kFree, kFree, kDriven});
  const RigidMotion<2> driven{kDriven, Vec<2>(3, -1), Vec3::UnitZ(), 2, Vec<2>(1, 0)};
  RigidMotions<2> motions;
  motions.add(first, {driven}, {kFree});
  motions.add(second, {driven}, {kFree});
  motions.start();
  EXPECT_EQ(first.v[0], Vec<2>(7, 7));
  EXPECT_EQ(first.v[1], Vec<2>(3, -1));
  EXPECT_EQ(first.v[2], Vec<2>(7, 7));
  EXPECT_EQ(first.v[3], Vec<2>(0, 0));
  EXPECT_LT((first.v[4] - Vec<2>(3, -1 + 2 * 3)).norm(), 1e-12);
  EXPECT_EQ(second.v[1], Vec<2>(7, 7));
  EXPECT_LT((second.v[2] - Vec<2>(3, -1 + 2 * 1)).norm(), 1e-12);
  // Places of a metre are known to 2^-53 m, so that velocities of 2^-24 s are known to 2^-29 m/s.
  const Real dt = std::ldexp(1.0, -24);
  motions.impose(dt, dt);
  EXPECT_LT((first.v[1] - Vec<2>(3, -1)).norm(), 1e-6);
  EXPECT_LT((second.v[2] - Vec<2>(3, 1)).norm(), 1e-5);
  EXPECT_EQ(first.v[0], Vec<2>(7, 7));
  EXPECT_EQ(first.v[3], Vec<2>(0, 0));
}

/// A table is integrated exactly whatever its kinks, an expression up to the third power.
TEST(DrivenRate, Integrals) {
  Varying table;
  table.over = Varying::Over::time;
  table.abscissa = {1, 2, 4}, table.ordinate = {2, 6, 0};
  const auto rate = driven_rate_of(table);
  EXPECT_NEAR(rate->over(0, 1), 2, 1e-15);
  EXPECT_NEAR(rate->over(1.5, 3), 0.5 * 5 + 0.5 * 9, 1e-14);
  EXPECT_NEAR(rate->over(0, 9), 2 + 4 + 6, 1e-14);
  const DrivenRate cubic{[](Real t, const Vec3&) { return t * t * t; }, {}};
  EXPECT_NEAR(cubic.over(1, 3), (81 - 1) / 4.0, 1e-13);
  // Over many swings, as of a torch in steps of heat: 0.05 (1 - cos 4 pi t).
  const DrivenRate swings{[](Real t, const Vec3&) { return 0.2 * kPi * std::sin(4 * kPi * t); },
                          {}};
  EXPECT_NEAR(swings.over(0.3, 9.7), 0.05 * (std::cos(1.2 * kPi) - std::cos(38.8 * kPi)), 1e-10);
  EXPECT_FALSE(driven_rate_of(Varying{}));
}

/// v = (3 t^2, -1), w = 4 t about the origin: it has come (t^3, -t) and turned by 2 t^2.
TEST(RigidMotions, RatesOverTime) {
  Points<2> points = on_a_line({0, 0});
  RigidMotion<2> driven;
  driven.velocity = Vec<2>(0, -1);
  driven.velocity_over_time[0] = {[](Real t, const Vec3&) { return 3 * t * t; }, {}};
  driven.spin_over_time = {[](Real t, const Vec3&) { return 4 * t; }, {}};
  RigidMotions<2> motions, resumed;
  motions.add(points, {driven});
  motions.start();
  EXPECT_EQ(points.v[1], Vec<2>(0, -1));
  Points<2> copy = points;
  resumed.add(copy, {driven});
  constexpr int kSteps = 1000;
  constexpr Real kStep = 1e-3;  // [s]
  for (int n = 1; n <= kSteps; ++n) {
    motions.impose(n * kStep, kStep);
    if (n == kSteps / 2) {
      std::vector<StateTable> saved;
      motions.save_state(saved);
      resumed.load_state(StateTables(std::move(saved)));
    } else if (n > kSteps / 2) {
      resumed.impose(n * kStep, kStep);
      ASSERT_EQ(copy.x[1], points.x[1]);
      ASSERT_EQ(copy.v[1], points.v[1]);
    }
  }
  EXPECT_LT((points.x[0] - Vec<2>(1, -1)).norm(), 1e-12);
  EXPECT_LT((points.x[1] - Vec<2>(1 + std::cos(2), -1 + std::sin(2))).norm(), 1e-12);
  const auto& motion = motions.all()[0].motions[0];
  EXPECT_LT(
      (motion.velocity_at(Vec<2>(1, 0), 1) - Vec<2>(3 - 4 * std::sin(2), -1 + 4 * std::cos(2)))
          .norm(),
      1e-9);
}

}  // namespace
}  // namespace brunt
