// Supports: a mass pulled by a spring while its velocity is prescribed. The work of the reaction
// must be what the spring stores and the mass gains, to rounding, and a held point takes none.
#include "core/boundaries/boundaries.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "app/loop/verlet.hpp"
#include "core/boundaries/rigid_motions.hpp"

namespace brunt {
namespace {

template <class Any>
Real boundary(const Any& supports) {
  Totals<2> totals;
  supports.add_totals(totals);
  return totals.value(Column::boundary);
}

/// v = 3 sin(5 t) along x; y follows its forces.
PrescribedMotion shaken() {
  Varying sine;
  sine.over = Varying::Over::expression;
  sine.evaluate = [](const std::array<Real, 4>& at) { return 3 * std::sin(5 * at[0]); };
  PrescribedMotion motion;
  motion.velocity = {{sine, std::nullopt}};
  return motion;
}
Patch<2> patch_of(Points<2>& points, std::vector<LocalIndex> chosen) {
  Patch<2> patch;
  patch.name = "pull", patch.points = &points, patch.chosen = std::move(chosen);
  return patch;
}

TEST(Supports, ReactionWorkClosesTheBalance) {
  Points<2> points;
  points.resize(1);
  points.mass[0] = 2;
  Boundaries<2> supports;
  EXPECT_EQ(supports.add(shaken(), patch_of(points, {0})), "");
  supports.start();
  Real t = 0, dt_last = 0, spring = 0;
  Vec<2> f_old = Vec<2>::Zero();
  for (int n = 0; n < 1000; ++n) {
    const Real dt = 0.01 + 0.002 * std::cos(0.3 * n);
    const Vec<2> x_old = points.x[0];
    predict(points, dt, dt_last);
    supports.impose(t + dt, dt);
    const Vec<2> f(-4 * points.x[0][0], 1);  // a spring along x, a constant force along y
    points.f[0] += f;
    spring -= 0.5 * (f + f_old).dot(points.x[0] - x_old);
    f_old = f;
    supports.take_reactions(t + dt, dt);
    correct(points, dt);
    dt_last = dt, t += dt;
  }
  const Real kinetic =
      points.v[0].squaredNorm() - 0.25 * dt_last * dt_last * points.a[0].squaredNorm();
  const Real scale = std::fabs(spring);
  EXPECT_NEAR(kinetic + points.integration[0] + spring + boundary(supports), 0, 1e-12 * scale);
  // midpoint velocities: the path is the integral of 3 sin(5 t) to second order, dt = 0.012
  EXPECT_NEAR(points.x[0][0], 0.6 * (1 - std::cos(5 * t)), 1e-3);
  EXPECT_NEAR(points.v[0][0], 3 * std::sin(5 * t), 1e-12);
  EXPECT_GT(points.x[0][1], 0);
}

TEST(Supports, RigidBodyTurnsAndItsReactionIsTheForceOnIt) {
  Points<2> points;
  points.resize(2);
  points.id = {0, 1};
  points.x = points.x_start = {Vec<2>(1, 0), Vec<2>(0, 2)};
  RigidSurfaces<2> rigid(points, {});
  RigidMotion<2> motion;
  motion.spin = kPi, motion.velocity = Vec<2>(0.5, 0);
  RigidMotions<2> supports;
  supports.add(rigid.points(), {motion});
  supports.start();
  EXPECT_NEAR((rigid.points().v[0] - Vec<2>(0.5, kPi)).norm(), 0, 1e-15);
  const int steps = 100;
  for (int n = 0; n < steps; ++n) {
    predict(rigid.points(), 0.01, 0.01);
    supports.impose(0.01 * (n + 1), 0.01);
    rigid.points().f[0] += Vec<2>(3, 0);
    supports.take_reactions(0.01);
    correct(rigid.points(), 0.01);
  }
  // half a turn and half a metre on
  EXPECT_NEAR((rigid.points().x[0] - Vec<2>(-0.5, 0)).norm(), 0, 1e-12);
  EXPECT_NEAR((rigid.points().x[1] - Vec<2>(0.5, -2)).norm(), 0, 1e-12);
  // The force does 3 N (-1.5 m) on the body, its first half step none; the support takes it away.
  const Real first = 0.5 * 3 * (std::cos(kPi * 0.01) + 0.005 - 1);
  EXPECT_NEAR(boundary(supports), 3 * -1.5 - first, 1e-12);
}

TEST(Supports, WorkAndReactionsGoOnAfterASplit) {
  Points<2> points;
  points.resize(2);
  points.id = {4, 9};
  points.mass = {2, 3};
  const auto supported = [](Points<2>& of) {
    Boundaries<2> supports;
    supports.add(shaken(), patch_of(of, {1}));
    return supports;
  };
  const auto advance = [](Points<2>& of, Boundaries<2>& supports, int from, int steps) {
    for (int n = from; n < from + steps; ++n) {
      predict(of, 0.01, n ? 0.01 : 0);
      supports.impose(0.01 * (n + 1), 0.01);
      for (std::size_t i = 0; i < 2; ++i) of.f[i] -= 4 * of.x[i];
      supports.take_reactions(0.01 * (n + 1), 0.01);
      correct(of, 0.01);
    }
  };
  auto whole = supported(points);
  advance(points, whole, 0, 50);
  std::vector<StateTable> tables;
  whole.save_state(tables);
  auto other = points;
  auto again = supported(other);
  again.load_state(StateTables(std::move(tables)));
  EXPECT_EQ(again.of<PrescribedMotion>()[0].reaction, whole.of<PrescribedMotion>()[0].reaction);
  advance(points, whole, 50, 50);
  advance(other, again, 50, 50);
  EXPECT_EQ(boundary(again), boundary(whole));
  EXPECT_NE(boundary(whole), 0);
  EXPECT_EQ(other.x, points.x);
}

}  // namespace
}  // namespace brunt
