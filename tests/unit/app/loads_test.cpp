// Loads: a falling mass turns weight into kinetic energy, a drag takes it out; both to rounding.
#include "core/boundaries/loads.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "app/loop/verlet.hpp"
#include "core/boundaries/boundaries.hpp"

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
    loads.add_forces(dt * (n + 1), dt);
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

/// 8 t along y.
template <int Dim>
AppliedForce growing() {
  Varying force;
  force.over = Varying::Over::expression;
  force.evaluate = [](const std::array<Real, 4>& at) { return 8 * at[0]; };
  AppliedForce load;
  load.force.emplace(Dim);
  (*load.force)[1] = force;
  return load;
}

TEST(Loads, ForceIsSharedByMass) {
  Points<2> points;
  points.resize(2);
  points.mass = {1, 3};
  Patch<2> patch;
  patch.points = &points, patch.chosen = {0, 1}, patch.to = 2;
  Boundaries<2> loads;
  EXPECT_EQ(loads.add(growing<2>(), patch), "");
  loads.add_forces(1.0, 0.1);
  EXPECT_EQ(points.f[0], Vec<2>(0, 2));
  EXPECT_EQ(points.f[1], Vec<2>(0, 6));
  loads.add_forces(3.0, 0.1);  // after `to` it is gone
  EXPECT_EQ(points.f[1], Vec<2>(0, 6));
}

struct AllLoads {
  Loads<3> everywhere;
  Boundaries<3> push;

  explicit AllLoads(Points<3>& points) {
    everywhere.gravity(Vec3(0, 0, -9.81));
    everywhere.damp(2, 0.5);
    everywhere.act_on(points);
    Patch<3> patch;
    patch.name = "push", patch.points = &points, patch.chosen = {0};
    push.add(growing<3>(), patch);
  }
  Real work(Column column) const {
    Totals<3> totals;
    everywhere.add_totals(totals), push.add_totals(totals);
    return totals.value(column);
  }
};

/// One mass under weight, drag and a force that grows, for `steps` steps from step `from` on.
void advance(Points<3>& points, AllLoads& loads, int from, int steps) {
  const Real dt = 1e-3;
  for (int n = from; n < from + steps; ++n) {
    predict(points, dt, n ? dt : 0);
    loads.everywhere.add_forces(dt * (n + 1), dt);
    loads.push.add_forces(dt * (n + 1), dt);
    correct(points, dt);
  }
}

TEST(Loads, TheSameBitsAfterASplit) {
  Points<3> points;
  points.resize(1);
  points.id[0] = 17;
  points.mass[0] = 3;
  points.v[0] = Vec3(1, 0, 0);
  AllLoads whole(points);
  advance(points, whole, 0, 20);
  std::vector<StateTable> tables;
  whole.everywhere.save_state(tables), whole.push.save_state(tables);
  auto other = points;
  AllLoads again(other);
  const StateTables read(std::move(tables));
  again.everywhere.load_state(read), again.push.load_state(read);
  advance(points, whole, 20, 20);
  advance(other, again, 20, 20);
  EXPECT_EQ(whole.work(Column::boundary), again.work(Column::boundary));
  EXPECT_EQ(whole.work(Column::damping), again.work(Column::damping));
  EXPECT_NE(whole.work(Column::boundary), 0);
  EXPECT_EQ(points.x, other.x);
}

}  // namespace
}  // namespace brunt
