#include "core/boundaries/loads.hpp"

#include <utility>

#include "core/parallel/threads.hpp"
#include "core/points_state.hpp"

namespace brunt {

template <int Dim>
void Loads<Dim>::act_on(Points<Dim>& points) {
  const auto n = points.owned();
  Body body{&points, {}, {}, {}, true};
  if (has_gravity_) body.load_work.assign(n, 0.0);
  if (rate_ > 0) {
    body.damping_work.assign(n, 0.0);
    body.last_damping.assign(n, Vec<Dim>::Zero());
  }
  bodies_.push_back(std::move(body));
}

template <int Dim>
void Loads<Dim>::act_on(FreeBodies<Dim>& bodies) {
  const std::size_t n = bodies.all().size();
  const std::vector<Vec3> none(n, Vec3::Zero());
  const std::vector<Real> zero(n, 0.0);
  rigid_ = Rigid{&bodies, none, none, zero, zero, true};
}

template <int Dim>
void Loads<Dim>::follow(const Points<Dim>& old, Points<Dim>& now) {
  const auto bodies = std::exchange(bodies_, {});
  for (const auto& body : bodies) {
    act_on(body.points == &old ? now : *body.points);
  }
}

/// Weight, and drag of every point of a body: -rate m v and, about its centre, -rate L.
template <int Dim>
void Loads<Dim>::push_rigid(Real time, Real dt) {
  auto& rigid = *rigid_;
  const auto bodies = rigid.bodies->all();
  const Vec<Dim> last = rigid.fresh ? Vec<Dim>::Zero().eval() : last_gravity_;
  const Real rate = rate_ > 0 && time <= until_ ? rate_ : 0.0;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    auto& body = bodies[b];
    const auto& state = body.state;
    if (has_gravity_) {
      const Vec3 weight = in_space<Dim>(Vec<Dim>(state.mass * gravity_));
      body.load_force += weight;
      rigid.load_work[b] +=
          0.5 * dt * (weight + in_space<Dim>(Vec<Dim>(state.mass * last))).dot(state.v);
    }
    if (rate_ == 0) continue;
    const Vec3 drag = -rate * state.mass * state.v;
    const Vec3 torque = body.turns ? Vec3(-rate * state.momentum) : Vec3::Zero();
    body.load_force += drag;
    body.load_torque += torque;
    rigid.damping_work[b] +=
        0.5 * dt *
        (state.v.dot(drag + rigid.last_drag[b]) + body.start_spin.dot(rigid.last_torque[b]) +
         body.end_spin.dot(torque));
    rigid.last_drag[b] = drag, rigid.last_torque[b] = torque;
  }
  rigid.fresh = false;
}

template <int Dim>
void Loads<Dim>::add_forces(Real time, Real dt) {
  if (over_time_) gravity_ = over_time_(time);
  for (auto& body : bodies_) {
    auto& points = *body.points;
    // At time 0 no force has acted yet: the first half of the first step carries none.
    const Vec<Dim> last = body.fresh ? Vec<Dim>::Zero().eval() : last_gravity_;
    const bool damped = rate_ > 0;
    const Real rate = time <= until_ ? rate_ : 0.0;
    for_each(points.n_owned, kPointsWorthThreads, [&](LocalIndex point) {
      const auto i = slot_of(point);
      if (has_gravity_) {
        const Vec<Dim> weight = points.mass[i] * gravity_;
        points.f[i] += weight;
        body.load_work[i] += 0.5 * dt * (weight + points.mass[i] * last).dot(points.v[i]);
      }
      if (damped) {
        const Vec<Dim> drag = -rate * points.mass[i] * points.v[i];
        points.f[i] += drag;
        body.damping_work[i] += 0.5 * dt * points.v[i].dot(drag + body.last_damping[i]);
        body.last_damping[i] = drag;
      }
    });
    body.fresh = false;
  }
  if (rigid_) push_rigid(time, dt);
  last_gravity_ = gravity_;
}

template <int Dim>
StepLimit Loads<Dim>::stable_step(Real time) const {
  // The drag lags by half a step: stable while rate dt < 2; a tenth of it keeps it accurate.
  if (rate_ > 0 && time <= until_) return {0.2 / rate_, "damping", 0, 0};
  return {};
}

template <int Dim>
void Loads<Dim>::add_rigid_totals(Totals<Dim>& totals) const {
  if (!rigid_) return;
  for (const Real work : rigid_->load_work) totals.add(Column::boundary, -work);
  for (const Real work : rigid_->damping_work) totals.add(Column::damping, -work);
}

template <int Dim>
void Loads<Dim>::add_totals(Totals<Dim>& totals) const {
  for (const auto& body : bodies_) {
    for (const Real work : body.load_work) totals.add(Column::boundary, -work);
    for (const Real work : body.damping_work) totals.add(Column::damping, -work);
  }
}

namespace {
template <class Row, class Body>
void visit_body(Row& row, Body& body, std::size_t i) {
  if (!body.load_work.empty()) row(body.load_work[i]);
  if (body.damping_work.empty()) return;
  row(body.damping_work[i]);
  row(body.last_damping[i]);
}

template <class Row, class Rigid>
void visit_rigid(Row& row, Rigid& rigid, std::size_t b) {
  row(rigid.load_work[b]), row(rigid.damping_work[b]);
  row(rigid.last_drag[b]), row(rigid.last_torque[b]);
  row(rigid.fresh);
}
}  // namespace

template <int Dim>
void Loads<Dim>::save_state(std::vector<StateTable>& tables) const {
  if (over_time_) {
    save_row(
        "loads.gravity", [&](auto& row) { row(last_gravity_); }, tables);
  }
  for (const auto& body : bodies_) {
    const std::uint64_t fresh = body.fresh;
    save_row(
        "loads", [&](auto& row) { row(fresh); }, tables);
    if (body.load_work.empty() && body.damping_work.empty()) continue;
    save_rows(
        "loads.points", body.points->owned(), [&](std::size_t i) { return body.points->id[i]; },
        [&](auto& row, std::size_t i) { visit_body(row, body, i); }, tables);
  }
  if (rigid_) {
    save_rows(
        "loads.rigid", rigid_->load_work.size(), [](std::size_t b) { return GlobalId{b}; },
        [&](auto& row, std::size_t b) { visit_rigid(row, *rigid_, b); }, tables);
  }
}

template <int Dim>
void Loads<Dim>::load_state(const StateTables& tables) {
  if (over_time_) {
    load_row(
        "loads.gravity", [&](auto& row) { row(last_gravity_); }, tables);
  }
  for (auto& body : bodies_) {
    std::uint64_t fresh = 0;
    load_row(
        "loads", [&](auto& row) { row(fresh); }, tables);
    body.fresh = fresh != 0;
    if (body.load_work.empty() && body.damping_work.empty()) continue;
    load_rows(
        "loads.points", body.points->owned(), [&](std::size_t i) { return body.points->id[i]; },
        [&](auto& row, std::size_t i) { visit_body(row, body, i); }, tables);
  }
  if (rigid_) {
    load_rows(
        "loads.rigid", rigid_->load_work.size(), [](std::size_t b) { return GlobalId{b}; },
        [&](auto& row, std::size_t b) { visit_rigid(row, *rigid_, b); }, tables);
  }
}

template class Loads<2>;
template class Loads<3>;

}  // namespace brunt
