// Bodies by forces at their points: momenta, work along chords and what it leaves, prescribed
// components, state and order of points.
#include "core/rigid/free_bodies.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace brunt {
namespace {

/// A box of eight points and a second body of one point; forces as somebody says.
struct Bodies {
  Points<3> points;
  std::unique_ptr<FreeBodies<3>> free;
  Real time = 0, dt_last = 0;  // [s]

  explicit Bodies(bool reversed = false) {
    points.resize(9);
    for (std::size_t k = 0; k < 9; ++k) {
      const std::size_t i = reversed ? 8 - k : k;
      points.id[i] = k;
      points.piece[i] = k < 8 ? 3 : 7;
      const Vec3 corner(k & 1 ? 1.0 : -1.0, k & 2 ? 0.5 : -0.5, k & 4 ? 0.3 : -0.3);
      points.x[i] = points.x_start[i] = k < 8 ? Vec3(corner + Vec3(5, 0, 0)) : Vec3(0, 9, 0);
    }
    std::vector<FreeBody<3>> bodies(2);
    auto& box = bodies[0];
    box.piece = 3, box.body = 0;
    box.free = {true, true, true}, box.turns = true;
    box.state.mass = 3;
    box.state.inertia = Vec3(0.34, 1.09, 1.25).asDiagonal();
    box.state.inverse_inertia = box.state.inertia.inverse();
    box.state.x = box.center = Vec3(5, 0, 0);
    box.state.v = Vec3(1, 2, -1);
    box.state.momentum = Vec3(0.5, 2, 0.3);
    auto& other = bodies[1];
    other.piece = 7, other.body = 1;
    other.free = {false, true, false};
    other.prescribed.velocity = Vec3(2, 0, 0);
    other.prescribed.center = Vec3(0, 8, 0);
    other.prescribed.spin = 4;
    other.state.mass = 2;
    other.state.x = other.center = Vec3(0, 9, 0);
    other.state.v = Vec3(2 - 4, 1, 0);
    other.state.momentum = Vec3(0, 0, 4);  // of an inertia of 1
    free = std::make_unique<FreeBodies<3>>(std::vector{&points}, std::move(bodies));
    free->start();
  }

  using Force = std::function<Vec3(GlobalId, Real)>;
  void step(Real dt, const Force& force) {
    for (auto& f : points.f) f.setZero();
    time += dt;
    free->predict(time, dt, dt_last);
    for (std::size_t i = 0; i < points.x.size(); ++i) points.f[i] = force(points.id[i], time);
    free->collect_forces(lone_rank(), time, dt);
    free->correct(dt);
    dt_last = dt;
  }

  Totals<3> totals() const {
    Totals<3> totals;
    totals.bodies.resize(2);
    free->add_totals(totals);
    free->add_body_totals(dt_last, totals);
    return totals;
  }
};

Vec3 pulls(GlobalId id, Real t) {
  const Real k = 1.0 + static_cast<Real>(id);
  return {3 * std::sin(k * t), 2 * std::cos(2 * k + t), std::sin(k) - 0.2 * k * t};
}

// All columns: the kinetic energy changes by the work of the forces along the motion of their
// points, 1/2 (f(n) + f(n+1)).(x(n+1) - x(n)), less what is booked to integration and boundary,
// also where the step changes. Sums of 400 steps of 9 points: rounding.
TEST(FreeBodies, WorkOfPointsIsKineticEnergyAndWhatIsBooked) {
  Bodies bodies;
  std::vector<Vec3> last(9, Vec3::Zero());
  Real work = 0, start = 0;
  for (const auto& body : bodies.totals().bodies) start += body.kinetic.value();
  for (int n = 0; n < 400; ++n) {
    const auto before = bodies.points.x;
    bodies.step(n % 7 < 4 ? 0.01 : 0.006, pulls);
    for (std::size_t i = 0; i < 9; ++i) {
      work += 0.5 * (last[i] + bodies.points.f[i]).dot(bodies.points.x[i] - before[i]);
      last[i] = bodies.points.f[i];
    }
    const auto totals = bodies.totals();
    Real kinetic = 0;
    for (const auto& body : totals.bodies) kinetic += body.kinetic.value();
    const Real booked = totals.value(Column::integration) + totals.value(Column::boundary);
    ASSERT_NEAR(kinetic - start + booked, work, 1e-11) << n;
  }
  EXPECT_GT(std::fabs(work), 1);
  EXPECT_GT(std::fabs(bodies.totals().value(Column::boundary)), 0.1);  // the one that is driven
}

// Momentum and angular momentum change by forces and torques times the step: those of time n act
// for half of the step before and half of the one after. Rounding of 300 steps.
TEST(FreeBodies, MomentaChangeByForcesAndTorques) {
  Bodies bodies;
  const auto moments = [&] {
    const auto& state = bodies.free->all()[0].state;
    return std::pair(Vec3(state.mass * state.v),
                     Vec3(state.momentum + state.mass * state.x.cross(state.v)));
  };
  const auto [p_start, l_start] = moments();
  Vec3 p = p_start, l = l_start;
  Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
  const Real dt = 0.01;
  for (int n = 0; n < 300; ++n) {
    p += 0.5 * dt * force, l += 0.5 * dt * torque;
    bodies.step(dt, pulls);
    force.setZero(), torque.setZero();
    for (std::size_t i = 0; i < 8; ++i) {
      force += bodies.points.f[i];
      torque += bodies.points.x[i].cross(bodies.points.f[i]);
    }
    p += 0.5 * dt * force, l += 0.5 * dt * torque;
    const auto [p_now, l_now] = moments();
    ASSERT_LT((p_now - p).norm(), 1e-11) << n;
    ASSERT_LT((l_now - l).norm(), 1e-10) << n;
  }
  EXPECT_GT((l - l_start).norm(), 1);
}

// A body keeps its shape, and its points move by dt v.
TEST(FreeBodies, PointsMoveAsOne) {
  Bodies bodies;
  for (int n = 0; n < 200; ++n) {
    for (auto& f : bodies.points.f) f.setZero();
    const auto before = bodies.points.x;
    bodies.time += 0.01;
    bodies.free->predict(bodies.time, 0.01, 0.01);
    const auto v = bodies.points.v;
    for (std::size_t i = 0; i < 9; ++i) {
      EXPECT_LT((bodies.points.x[i] - before[i] - 0.01 * v[i]).norm(), 4e-15);
      bodies.points.f[i] = pulls(i, bodies.time);
    }
    bodies.free->collect_forces(lone_rank(), bodies.time, 0.01);
    bodies.free->correct(0.01);
  }
  EXPECT_NEAR((bodies.points.x[7] - bodies.points.x[0]).norm(), std::sqrt(4 + 1 + 0.36), 1e-14);
}

// What is prescribed is so: x and z of the second body, about a centre that moves, whatever pulls.
TEST(FreeBodies, PrescribedComponentsMoveAsPrescribed) {
  Bodies bodies;
  for (int n = 0; n < 100; ++n) bodies.step(0.01, pulls);
  const auto& state = bodies.free->all()[1].state;
  EXPECT_NEAR(state.x[0], 2 - std::sin(4.0), 1e-14);
  EXPECT_EQ(state.x[2], 0);
  EXPECT_NEAR(state.v[0], 2 - 4 * std::cos(4.0), 1e-13);
  EXPECT_NE(state.v[1], 1);
}

// The order in which points stand changes no bit, and a state taken over goes on with the same
// bits.
TEST(FreeBodies, BitsDependOnNeitherOrderNorRestart) {
  Bodies one, other(true), third;
  for (int n = 0; n < 50; ++n) one.step(0.01, pulls), other.step(0.01, pulls);
  std::vector<StateTable> tables;
  one.free->save_state(tables);
  third.free->load_state(StateTables(std::move(tables)));
  third.time = one.time, third.dt_last = one.dt_last;
  EXPECT_EQ(one.points.x, third.points.x);
  for (int n = 0; n < 50; ++n) {
    for (auto* bodies : {&one, &other, &third}) bodies->step(0.01, pulls);
  }
  EXPECT_EQ(one.totals().state_hash, other.totals().state_hash);
  EXPECT_EQ(one.totals().state_hash, third.totals().state_hash);
  for (const Column column : {Column::integration, Column::boundary}) {
    EXPECT_EQ(one.totals().value(column), other.totals().value(column));
    EXPECT_EQ(one.totals().value(column), third.totals().value(column));
  }
}

// Points that stand in two groups, the second with copies of some of the first that nobody owns,
// are one body's all the same: forces of owned points act once, and copies move along.
TEST(FreeBodies, PointsOfTwoGroupsAreOneBody) {
  Bodies one, other;
  auto& all = other.points;
  const std::vector<LocalIndex> here = {0, 2, 4, 6, 8}, there = {1, 3, 5, 7, 0, 2};
  Points<3> first = all.subset(here, 5), second = all.subset(there, 4);
  std::vector<FreeBody<3>> bodies(other.free->all().begin(), other.free->all().end());
  FreeBodies<3> split({&all, &second}, bodies);
  split.follow(all, first);
  split.start();
  Real time = 0;
  for (int n = 0; n < 50; ++n) {
    one.step(0.01, pulls);
    time += 0.01;
    split.predict(time, 0.01, n == 0 ? 0 : 0.01);
    for (auto* points : {&first, &second}) {
      for (std::size_t i = 0; i < points->x.size(); ++i) {
        points->f[i] = pulls(points->id[i], time);
      }
    }
    split.collect_forces(lone_rank(), time, 0.01);
    split.correct(0.01);
  }
  Totals<3> totals;
  totals.bodies.resize(2);
  split.add_totals(totals);
  split.add_body_totals(0.01, totals);
  EXPECT_EQ(totals.state_hash, one.totals().state_hash);
  EXPECT_EQ(totals.value(Column::integration), one.totals().value(Column::integration));
  EXPECT_EQ(second.x[4], one.points.x[0]);
  // What it keeps of points goes by their ids: the checkpoint of one group is that of two.
  std::vector<StateTable> tables;
  split.save_state(tables);
  Bodies again;
  again.free->load_state(StateTables(std::move(tables)));
  EXPECT_EQ(again.totals().value(Column::integration), totals.value(Column::integration));
  EXPECT_EQ(again.points.x, one.points.x);
}

// A step turns no body by more than 0.2 rad, even if all its momentum went to its least inertia.
TEST(FreeBodies, LimitTheAngleOfAStep) {
  const Bodies bodies;
  const StepLimit step_limit = bodies.free->stable_step();
  const Real fastest = std::max(Vec3(0.5, 2, 0.3).norm() / 0.34, 4.0);
  EXPECT_NEAR(step_limit.step, 0.2 / fastest, 1e-14);
}

}  // namespace
}  // namespace brunt
