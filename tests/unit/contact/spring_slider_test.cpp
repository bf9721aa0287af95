// The spring-slider: t = -k u until |t| = limit, then t = -limit along the slip. Its work is what
// the spring stores plus heat, whatever the step: -(t0 + t1)/2 . du = (t1^2 - t0^2)/2k + heat.
// The turn of its plane is exact for bodies that turn as one: by any rotation R that takes n to
// R n, the traction R t follows.
#include "contact/law/spring_slider.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace brunt {
namespace {

TEST(Slide, SticksThenSlips) {
  const auto stuck = slide<2>({0, 0}, 100, {0.02, 0}, 3);
  EXPECT_EQ(stuck.traction, Vec<2>(-2, 0));
  EXPECT_EQ(stuck.slip, Vec<2>(0, 0));
  EXPECT_FALSE(stuck.slips);
  const auto slipped = slide<2>({-2, 0}, 100, {0.02, 0}, 3);
  EXPECT_TRUE(slipped.slips);
  EXPECT_NEAR(slipped.traction[0], -3, 1e-15);
  EXPECT_NEAR(slipped.slip[0], 0.01, 1e-16);  // 0.01 m of spring were left
}

TEST(Slide, WithoutAnyLimitThereIsNoTraction) {
  const auto open = slide<3>({1, 2, 0}, 10, {0, 0, 0}, 0);
  EXPECT_EQ(open.traction, Vec3::Zero());
  EXPECT_EQ(open.slip, Vec3(-0.1, -0.2, 0));  // the spring lets go: its 5/20 J become heat
}

// Where a spring rounds to more than its limit by its square, though not by its size, a damper of
// nothing stays nothing; without a damper that was 0/0.
TEST(Slide, NoDamperAtTheLimitIsNone) {
  int rounded = 0;
  for (int i = 1; i <= 1000; ++i) {
    const Vec3 spring(1.0 / i, std::sqrt(0.1 * i), 0);
    const Real limit = spring.norm();
    rounded += spring.squaredNorm() > limit * limit ? 1 : 0;
    EXPECT_EQ(within_limit<3>(spring, Vec3::Zero(), limit), Vec3(Vec3::Zero())) << i;
  }
  EXPECT_GT(rounded, 100);
}

TEST(Slide, WorkIsStoreAndHeat) {
  std::mt19937_64 random(3);
  std::normal_distribution<Real> normal(0, 1);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 before(normal(random), normal(random), normal(random));
    const Vec3 du(normal(random), normal(random), normal(random));
    const Real k = std::exp(normal(random)), limit = std::fabs(normal(random));
    const auto step = slide<3>(before, k, du, limit);
    const Real work = -0.5 * (before + step.traction).dot(du);
    const Real stored = (step.traction.squaredNorm() - before.squaredNorm()) / (2 * k);
    const Real heat = -0.5 * (before + step.traction).dot(step.slip);
    EXPECT_NEAR(work, stored + heat, 1e-12 * (1 + std::fabs(work) + std::fabs(stored)));
    EXPECT_LE(step.traction.norm(), limit * (1 + 1e-15) + (step.slips ? 0 : 1e300));
  }
}

TEST(PlaneTurn, FollowsARigidRotation) {
  std::mt19937_64 random(4);
  std::normal_distribution<Real> normal(0, 1);
  for (int i = 0; i < 100; ++i) {
    const Vec3 axis = Vec3(normal(random), normal(random), normal(random)).normalized();
    const Vec3 from = Vec3(normal(random), normal(random), normal(random)).normalized();
    const Mat3 rotation = Eigen::AngleAxis<Real>(0.3, axis).toRotationMatrix();
    const Vec3 to = rotation * from;
    PlaneTurn<3> turn(from, to);
    const Vec3 arm = from.unitOrthogonal(), tilted = turn.tilted(arm), goal = rotation * arm;
    turn.spin(tilted.dot(goal), to.dot(tilted.cross(goal)));
    for (const Vec3& v : {Vec3(1, 2, 3), from, arm}) {
      EXPECT_LT((turn(v) - rotation * v).norm(), 1e-14 * 4);
    }
  }
}

// Three vectors side by side: the bits of each alone.
TEST(PlaneTurn, TurnsThreeAsEach) {
  std::mt19937_64 random(6);
  std::normal_distribution<Real> normal(0, 1);
  const auto vector = [&] { return Vec3(normal(random), normal(random), normal(random)); };
  for (int i = 0; i < 1000; ++i) {
    PlaneTurn<3> turn(vector().normalized(), vector().normalized());
    if (i % 3 > 0) turn.spin(normal(random), normal(random));
    const std::array<Vec3, 3> v = {vector(), vector(), i % 5 == 0 ? Vec3::Zero() : vector()};
    const auto together = turn(v);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(together[k], turn(v[k]));
  }
}

TEST(PlaneTurn, TurnsInTwoDimensions) {
  const Vec<2> from(1, 0), to(std::cos(0.4), std::sin(0.4));
  const PlaneTurn<2> turn(from, to);
  EXPECT_LT((turn(Vec<2>(0, 2)) - Vec<2>(-2 * to[1], 2 * to[0])).norm(), 1e-15);
}

// Products are rounded before they are added, on any processor. Fused, many a turn differs in its
// last digit (docs/decisions/122-fused-turns.md).
TEST(PlaneTurn, RoundsEachProduct) {
  std::mt19937_64 random(5);
  std::normal_distribution<Real> normal(0, 1);
  int fused_differ = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vec<2> from = Vec<2>(normal(random), normal(random)).normalized();
    const Vec<2> to = Vec<2>(normal(random), normal(random)).normalized();
    const Vec<2> v(normal(random), normal(random));
    const volatile Real across = from[0] * to[1], back = from[1] * to[0];
    const Real cosine = PlaneTurn<2>(from, to).cosine(), sine = across - back;
    const volatile Real ca = cosine * v[0], sb = sine * v[1], sa = sine * v[0], cb = cosine * v[1];
    const Vec<2> turned = PlaneTurn<2>(from, to)(v);
    EXPECT_EQ(turned[0], ca - sb);
    EXPECT_EQ(turned[1], sa + cb);
    fused_differ += std::fma(cosine, v[0], -sb) != ca - sb ? 1 : 0;
  }
  EXPECT_GT(fused_differ, 100);  // it would have been seen
}

}  // namespace
}  // namespace brunt
