// Velocities that grow from 0 to 4 m/s in 2 s and fall to -2 m/s at 5 s; before and after they are
// held. Integral from 0: t^2 up to 2 s, then 4 + 4 s - s^2, s = t - 2 s, and 7 - 2 s, s = t - 5 s.
#include "core/rigid/velocity_table.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/rigid/rigid_surfaces.hpp"

namespace brunt {
namespace {

TEST(VelocityTable, IsLinearBetweenItsTimesAndHeldOutside) {
  const VelocityTable table({0, 2, 5}, {0, 4, -2});
  EXPECT_EQ(table.velocity(-1), 0);
  EXPECT_EQ(table.velocity(1), 2);
  EXPECT_EQ(table.velocity(2), 4);
  EXPECT_EQ(table.velocity(3), 2);
  EXPECT_EQ(table.velocity(7), -2);
}

TEST(VelocityTable, HasItsIntegralInClosedForm) {
  const VelocityTable table({0, 2, 5}, {0, 4, -2});
  EXPECT_EQ(table.travel(0), 0);
  EXPECT_EQ(table.travel(1), 1);
  EXPECT_EQ(table.travel(2), 4);
  EXPECT_EQ(table.travel(3), 7);
  EXPECT_EQ(table.travel(5), 7);
  EXPECT_EQ(table.travel(6), 5);
}

TEST(VelocityTable, MayBeginBeforeOrAfterTimeZero) {
  const VelocityTable before({-1, 1}, {0, 2}), after({1, 2}, {3, 5});
  EXPECT_EQ(before.travel(0), 0);
  EXPECT_EQ(before.travel(1), 1.5);
  EXPECT_EQ(after.travel(1), 3);
  EXPECT_EQ(after.travel(2), 7);
  EXPECT_EQ(after.travel(-1), -3);
}

TEST(VelocityTable, MovesABodyThatTurnsAboutItsCentre) {
  RigidMotion<2> motion;
  motion.velocity = Vec<2>(0, 3);
  motion.spin = 0.5;
  motion.over_time[0].emplace(std::vector<Real>{0, 2}, std::vector<Real>{0, 4});
  const Vec<2> x = motion.position(Vec<2>(1, 0), 2), v = motion.velocity_at(Vec<2>(1, 0), 2);
  EXPECT_LT((x - Vec<2>(4 + std::cos(1.0), 6 + std::sin(1.0))).norm(), 1e-14);
  EXPECT_LT((v - Vec<2>(4 - 0.5 * std::sin(1.0), 3 + 0.5 * std::cos(1.0))).norm(), 1e-14);
}

}  // namespace
}  // namespace brunt
