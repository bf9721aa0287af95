// Loads: a falling mass turns weight into kinetic energy, a drag takes it out; both to rounding.
#include "core/boundaries/loads.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "app/loop/verlet.hpp"

namespace brunt {
namespace {

TEST(Loads, WeightAndDragCloseTheBalance) {
  Points<3> points;
  points.resize(1);
  points.mass[0] = 3;
  points.v[0] = Vec3(1, 0, 0);
  Loads<3> loads;
  loads.gravity(Vec3(0, 0, -9.81));
  loads.damp(2, 0.5);
  loads.act_on(points);
  const Real dt = 1e-3;
  for (int n = 0; n < 1000; ++n) {
    predict(points, dt, n ? dt : 0);
    loads.add_forces(dt * (n + 1), dt, Vec3::Zero());
    correct(points, dt);
  }
  Totals<3> totals;
  loads.add_totals(totals);
  const Real kinetic =
      1.5 * (points.v[0].squaredNorm() - 0.25 * dt * dt * points.a[0].squaredNorm());
  EXPECT_NEAR(kinetic + points.integration[0] + totals.value(Column::boundary) +
                  totals.value(Column::damping),
              1.5, 1e-12 * kinetic);
  // v_x = exp(-2 t) until 0.5 s; the drag lags half a step, and the first half step has none:
  // relative error 2 dt
  EXPECT_NEAR(points.v[0][0], std::exp(-1), 2e-3);
  EXPECT_GT(totals.value(Column::damping), 0);
  EXPECT_LT(totals.value(Column::boundary), 0);
}

TEST(Loads, ForceIsSharedByMass) {
  Points<2> points;
  points.resize(2);
  points.mass = {1, 3};
  Loads<2> loads;
  AppliedForce<2> force;
  force.points = &points;
  force.chosen = {0, 1};
  force.share = {0.25, 0.75};
  force.force[1] = [](Real t, const Vec3&) { return 8 * t; };
  force.to = 2;
  loads.apply(force);
  loads.add_forces(1.0, 0.1, Vec<2>::Zero());
  EXPECT_EQ(points.f[0], Vec<2>(0, 2));
  EXPECT_EQ(points.f[1], Vec<2>(0, 6));
  loads.add_forces(3.0, 0.1, Vec<2>::Zero());  // after `to` it is gone
  EXPECT_EQ(points.f[1], Vec<2>(0, 6));
}

/// One mass under weight, drag and a force that grows, for `steps` steps from step `from` on.
void advance(Points<3>& points, Loads<3>& loads, int from, int steps) {
  const Real dt = 1e-3;
  for (int n = from; n < from + steps; ++n) {
    predict(points, dt, n ? dt : 0);
    loads.add_forces(dt * (n + 1), dt, Vec3::Zero());
    correct(points, dt);
  }
}
Loads<3> all_loads(Points<3>& points) {
  Loads<3> loads;
  loads.gravity(Vec3(0, 0, -9.81));
  loads.damp(2, 0.5);
  loads.act_on(points);
  AppliedForce<3> force;
  force.name = "push";
  force.points = &points;
  force.chosen = {0};
  force.share = {1};
  force.force[1] = [](Real t, const Vec3&) { return 8 * t; };
  loads.apply(force);
  return loads;
}

TEST(Loads, TheSameBitsAfterASplit) {
  Points<3> points;
  points.resize(1);
  points.id[0] = 17;
  points.mass[0] = 3;
  points.v[0] = Vec3(1, 0, 0);
  auto whole = all_loads(points);
  advance(points, whole, 0, 20);
  std::vector<StateTable> tables;
  whole.save_state(tables);
  auto other = points;
  auto again = all_loads(other);
  again.load_state(StateTables(std::move(tables)));
  advance(points, whole, 20, 20);
  advance(other, again, 20, 20);
  Totals<3> a, b;
  whole.add_totals(a);
  again.add_totals(b);
  EXPECT_EQ(a.value(Column::boundary), b.value(Column::boundary));
  EXPECT_EQ(a.value(Column::damping), b.value(Column::damping));
  EXPECT_EQ(points.x, other.x);
}

}  // namespace
}  // namespace brunt
