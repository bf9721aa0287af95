#include "core/rigid/free_bodies.hpp"

#include <cmath>
#include <map>
#include <utility>

#include "core/exact_sum.hpp"
#include "core/parallel/threads.hpp"
#include "core/points_state.hpp"
#include "core/state_hash.hpp"

namespace brunt {

namespace {
constexpr Real kLargestTurn = 0.2;           // [rad] of a step
constexpr std::size_t kWorthThreads = 1000;  // points
}  // namespace

/// Resultants of the forces at points; in 2D the force and the torque about z.
template <int Dim>
struct FreeBodies<Dim>::Sums {
  static constexpr std::size_t kSums = Dim == 3 ? 6 : 3;
  std::array<ExactSum, kSums> sum;

  void add(const Vec3& force, const Vec3& torque) {
    for (std::size_t c = 0; c < Dim; ++c) sum[c].add(force[static_cast<int>(c)]);
    for (std::size_t c = Dim; c < kSums; ++c)
      sum[c].add(torque[static_cast<int>(c) - (Dim == 3 ? 3 : 0)]);
  }
  void add(const Sums& other) {
    for (std::size_t c = 0; c < kSums; ++c) sum[c].add(other.sum[c]);
  }
  Vec3 force() const {
    Vec3 value = Vec3::Zero();
    for (int c = 0; c < Dim; ++c) value[c] = sum[c].value();
    return value;
  }
  Vec3 torque() const {
    if (Dim == 2) return {0, 0, sum[2].value()};
    return {sum[kSums - 3].value(), sum[kSums - 2].value(), sum[kSums - 1].value()};
  }
};

template <int Dim>
FreeBodies<Dim>::FreeBodies(const std::vector<Points<Dim>*>& groups,
                            std::vector<FreeBody<Dim>> bodies)
    : bodies_(std::move(bodies)) {
  for (Points<Dim>* points : groups) {
    groups_.push_back({points});
    find_points(groups_.back());
  }
}

template <int Dim>
void FreeBodies<Dim>::find_points(Group& group) {
  std::map<Label, std::size_t> number;
  for (std::size_t b = 0; b < bodies_.size(); ++b) number[bodies_[b].piece] = b;
  group.chosen.clear(), group.body_of.clear();
  for (LocalIndex i = 0; i < group.points->size(); ++i) {
    const auto found = number.find(group.points->piece[i]);
    if (found == number.end()) continue;
    group.chosen.push_back(i);
    group.body_of.push_back(found->second);
  }
  group.arm.assign(group.chosen.size(), Vec3::Zero());
  group.last_force.assign(group.chosen.size(), Vec<Dim>::Zero());
  group.work.assign(group.chosen.size(), 0.0);
  placed_.assign(bodies_.size(), {});
}

template <int Dim>
void FreeBodies<Dim>::follow(const Points<Dim>& old, Points<Dim>& now) {
  for (auto& group : groups_) {
    if (group.points != &old) continue;
    group.points = &now;
    find_points(group);
  }
}

/// True of a body without any motion, whose points have velocities of +0 whatever makes them.
template <int Dim>
bool is_at_rest(const FreeBody<Dim>& body) {
  const auto is_zero = [](Real value) { return value == 0 && !std::signbit(value); };
  const auto& v = body.state.v;
  if (!is_zero(v[0]) || !is_zero(v[1]) || !is_zero(v[2])) return false;
  return body.turns ? body.state.momentum == Vec3::Zero() : !body.prescribed.turns();
}

/// Arms as the bodies lie now; positions and velocities of the points with them. A body that was at
/// rest when they were last placed, and is there and at rest now, is left alone.
template <int Dim>
template <class Velocity>
void FreeBodies<Dim>::place_points(const Velocity& velocity) {
  std::vector<Mat3> rotation(bodies_.size());
  std::vector<char> leaves(bodies_.size());
  bool all_left = true;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const auto& state = bodies_[b].state;
    auto& placed = placed_[b];
    const bool rests = is_at_rest(bodies_[b]);
    leaves[b] = rests && placed.at_rest && placed.x == state.x &&
                placed.turn.coeffs() == state.turn.coeffs();
    all_left = all_left && leaves[b] != 0;
    if (leaves[b] != 0) continue;
    placed = {rests, state.x, state.turn};
    rotation[b] = state.rotation();
  }
  if (all_left) return;
  for (auto& group : groups_) {
    auto& points = *group.points;
    for_each(group.chosen.size(), kWorthThreads, [&](std::size_t k) {
      const auto i = slot_of(group.chosen[k]);
      const std::size_t b = group.body_of[k];
      if (leaves[b] != 0) return;
      const auto& body = bodies_[b];
      const Vec3 start = in_space<Dim>(points.x_start[i]) - body.center;
      const Vec3 arm = rotation[b] * start;
      points.x[i] = (body.state.x + arm).template head<Dim>();
      points.x_rest[i].setZero();
      points.v[i] = (body.state.v + velocity(b, group.arm[k], arm)).template head<Dim>();
      group.arm[k] = arm;
    });
  }
}

template <int Dim>
void FreeBodies<Dim>::start() {
  std::vector<Vec3> spin;
  for (const auto& body : bodies_) spin.push_back(body.state.spin());
  place_points([&](std::size_t b, const Vec3&, const Vec3& arm) { return spin[b].cross(arm); });
}

template <int Dim>
Vec3 FreeBodies<Dim>::prescribed_center(const FreeBody<Dim>& body,
                                        const RigidPose<Dim>& pose) const {
  return in_space<Dim>(body.prescribed.position(body.center.template head<Dim>(), pose));
}

/// What is not free follows its prescribed motion: the acceleration at the start of the step
/// becomes the one that leads there, as for points that a boundary moves.
template <int Dim>
void FreeBodies<Dim>::impose(FreeBody<Dim>& body, Real time, Real dt, Vec3& chords) {
  auto& state = body.state;
  auto& given = body.prescribed;
  const RigidPose<Dim> from = given.pose(time - dt);
  given.advance(time, dt);
  const RigidPose<Dim> to = given.pose(time);
  const Vec3 now = prescribed_center(body, to), before = prescribed_center(body, from);
  for (int c = 0; c < Dim; ++c) {
    if (body.is_free(c)) continue;
    const Real old = state.a[c];
    const Real v_half = (now[c] - before[c]) / dt;
    const Real needed = 2 * (v_half - (state.v[c] - 0.5 * dt * old)) / dt;
    body.reaction[c] += state.mass * (needed - old);
    body.integration += dt * dt / 8 * state.mass * (needed * needed - old * old);
    state.a[c] = needed;
    state.v[c] = v_half;
    state.x[c] = now[c];
  }
  if (body.turns) return;
  const auto turning = [&] { return 0.5 * state.momentum.dot(state.spin()); };
  const Real had = given.spin_over_time ? turning() : 0.0;
  state.turn = Eigen::AngleAxis<Real>(to.angle, given.axis);
  const Mat3 rotation = state.rotation();
  const Vec3 spin = given.spin_of(time) * given.axis;
  state.momentum = rotation * (state.inertia * (rotation.transpose() * spin));
  if (given.spin_over_time) body.boundary -= turning() - had;  // what leads it gives it that energy
  const Real angle = given.spin_over_time ? to.angle - from.angle : given.spin * dt;
  chords = chord_rate(angle, dt) * given.axis;
}

template <int Dim>
void FreeBodies<Dim>::predict(Real time, Real dt, Real dt_last) {
  const Real change = (dt * dt - dt_last * dt_last) / 8;
  std::vector<Vec3> chords;
  for (auto& body : bodies_) {
    body.integration += change * body.state.kick_energy();
    body.state.kick(dt);
    body.start_spin = body.state.spin();
    chords.push_back(body.state.drift(dt));
    impose(body, time, dt, chords.back());
    body.end_spin = body.state.spin();
    body.load_force.setZero(), body.load_torque.setZero();
  }
  // r(n+1) - r(n) = dt w x (r(n) + r(n+1))/2 to the last digit, whatever the step
  place_points([&](std::size_t b, const Vec3& before, const Vec3& arm) {
    return chords[b].cross(0.5 * (before + arm));
  });
}

/// Adds the forces of the owned points of a group, and books their work.
template <int Dim>
void FreeBodies<Dim>::add_forces(Real dt, Group& group, std::vector<Sums>& sums) {
  const auto& points = *group.points;
  for (std::size_t k = 0; k < group.chosen.size(); ++k) {
    if (group.chosen[k] >= points.n_owned) continue;
    const auto i = slot_of(group.chosen[k]);
    const Vec<Dim>& f = points.f[i];
    group.work[k] += 0.5 * dt * points.v[i].dot(group.last_force[k] + f);
    group.last_force[k] = f;
    if (f.squaredNorm() == 0) continue;
    const Vec3 force = in_space<Dim>(f);
    sums[group.body_of[k]].add(force, group.arm[k].cross(force));
  }
}

/// The forces on the points of each body, by all ranks.
template <int Dim>
auto FreeBodies<Dim>::sum_forces(const Communicator& ranks, Real dt) -> std::vector<Sums> {
  std::vector<Sums> sums(bodies_.size());
  for (auto& group : groups_) add_forces(dt, group, sums);
  ranks.reduce_all(std::span(sums), [](Sums& a, const Sums& b) { a.add(b); });
  return sums;
}

/// The acceleration that forces make, those of its points and of loads.
template <int Dim>
void FreeBodies<Dim>::take_forces(const Sums& sums, FreeBody<Dim>& body) {
  auto& state = body.state;
  body.point_force = sums.force(), body.point_torque = sums.torque();
  body.force = body.point_force + body.load_force;
  body.torque = body.point_torque + body.load_torque;
  if (body.turns) state.torque = body.turns_about.cwiseProduct(body.torque);
  state.a = body.force / state.mass;
}

template <int Dim>
void FreeBodies<Dim>::press(const Communicator& ranks) {
  const std::vector<Sums> sums = sum_forces(ranks, 0);
  for (std::size_t b = 0; b < bodies_.size(); ++b) take_forces(sums[b], bodies_[b]);
}

template <int Dim>
void FreeBodies<Dim>::collect_forces(const Communicator& ranks, Real time, Real dt) {
  const std::vector<Sums> sums = sum_forces(ranks, dt);
  for (std::size_t b = 0; b < bodies_.size(); ++b) book_forces(sums[b], time, dt, bodies_[b]);
}

/// The acceleration at the end of the step, and the work of what makes it.
template <int Dim>
void FreeBodies<Dim>::book_forces(const Sums& sums, Real time, Real dt, FreeBody<Dim>& body) {
  auto& state = body.state;
  const Vec3 last_force = body.point_force, last_torque = body.point_torque;
  take_forces(sums, body);
  Real taken = state.v.dot(last_force + body.point_force);
  if (body.turns) {
    taken += last_torque.dot(body.start_spin) + body.point_torque.dot(body.end_spin);
  }
  (body.turns ? body.integration : body.boundary) -= 0.5 * dt * taken;
  const auto& motion = body.prescribed;
  const RigidPose<Dim> pose = motion.pose(time);
  const Vec3 place = prescribed_center(body, pose);
  const Vec3 about = in_space<Dim>(Vec<Dim>(motion.center + pose.shift));
  const Vec3 given = in_space<Dim>(motion.velocity_of(time)) +
                     motion.spin_of(time) * motion.axis.cross(place - about);
  for (int c = 0; c < Dim; ++c) {
    if (body.is_free(c)) continue;
    const Real needed = 2 * (given[c] - state.v[c]) / dt;
    const Real reaction = state.mass * needed - body.force[c];
    body.boundary -= 0.5 * dt * state.v[c] * (body.reaction[c] + reaction);
    body.reaction[c] = reaction;
    state.a[c] = needed;
  }
}

template <int Dim>
void FreeBodies<Dim>::correct(Real dt) {
  for (auto& body : bodies_) body.state.kick(dt);
  start();
}

template <int Dim>
StepLimit FreeBodies<Dim>::stable_step() const {
  StepLimit step_limit;
  for (const auto& body : bodies_) {
    const Real rate =
        body.turns ? body.state.fastest_spin() : std::fabs(body.prescribed.spin_now());
    if (rate == 0) continue;
    step_limit.take({kLargestTurn / rate, "spin of a rigid body", body.body, body.piece});
  }
  return step_limit;
}

namespace {
/// Hands every value that a body carries from step to step to f(value, use). Rows of a checkpoint
/// have this order.
template <class AnyBody, class F>
void visit_free_body(AnyBody& body, const F& f) {
  auto& state = body.state;
  f(state.x, kState), f(state.v, kState), f(state.a, kState);
  f(state.turn.coeffs(), kState), f(state.momentum, kState), f(state.torque, kState);
  f(body.force, kSaved), f(body.torque, kSaved);
  f(body.point_force, kSaved), f(body.point_torque, kSaved), f(body.reaction, kSaved);
  f(body.integration, kSaved), f(body.boundary, kSaved);
}
constexpr auto kPrescribed = [](const auto& body) -> auto& { return body.prescribed; };
/// The same of one of its points.
template <class Group, class F>
void visit_point_of_body(Group& group, std::size_t k, const F& f) {
  f(group.last_force[k], kSaved), f(group.work[k], kSaved);
}
}  // namespace

template <int Dim>
void FreeBodies<Dim>::add_totals(Totals<Dim>& totals) const {
  for (const auto& group : groups_) {
    for (std::size_t k = 0; k < group.chosen.size(); ++k) {
      if (group.chosen[k] >= group.points->n_owned || group.work[k] == 0) continue;
      const auto& body = bodies_[group.body_of[k]];
      totals.add(body.turns ? Column::integration : Column::boundary, group.work[k]);
      if (body.turns) totals.bodies[body.body].integration.add(group.work[k]);
    }
  }
}

template <int Dim>
void FreeBodies<Dim>::add_body_totals(Real dt, Totals<Dim>& totals) const {
  for (const auto& body : bodies_) {
    const auto& state = body.state;
    auto& sums = totals.bodies[body.body];
    sums.mass.add(state.mass);
    sums.kinetic.add(state.kinetic(dt));
    EntityHash hash(body.piece);
    hash_values<3>(hash, [&](const auto& add) { visit_free_body(body, add); });
    totals.state_hash += hash.value();
    for (int c = 0; c < Dim; ++c) {
      sums.mass_position[c].add(state.mass * state.x[c]);
      sums.momentum[c].add(state.mass * state.v[c]);
    }
    totals.add(Column::integration, body.integration);
    sums.integration.add(body.integration);
    totals.add(Column::boundary, body.boundary);
  }
}

template <int Dim>
void FreeBodies<Dim>::save_state(std::vector<StateTable>& tables) const {
  save_rows(
      "rigid.bodies", bodies_.size(), [&](std::size_t b) { return GlobalId{bodies_[b].piece}; },
      [&](auto& row, std::size_t b) { visit_free_body(bodies_[b], saved_in(row)); }, tables);
  if (const auto varying = varying_of(bodies_, kPrescribed); !varying.empty()) {
    save_rows(
        "rigid.bodies.motions", varying.size(),
        [&](std::size_t k) { return GlobalId{varying[k]->piece}; },
        [&](auto& row, std::size_t k) { visit_motion(varying[k]->prescribed, saved_in(row)); },
        tables);
  }
  for (const auto& group : groups_) {
    save_chosen(
        "rigid.points", *group.points, group.chosen,
        [&](auto& row, std::size_t k) { visit_point_of_body(group, k, saved_in(row)); }, tables);
  }
}

template <int Dim>
void FreeBodies<Dim>::load_state(const StateTables& tables) {
  load_rows(
      "rigid.bodies", bodies_.size(), [&](std::size_t b) { return GlobalId{bodies_[b].piece}; },
      [&](auto& row, std::size_t b) { visit_free_body(bodies_[b], saved_in(row)); }, tables);
  if (const auto varying = varying_of(bodies_, kPrescribed); !varying.empty()) {
    load_rows(
        "rigid.bodies.motions", varying.size(),
        [&](std::size_t k) { return GlobalId{varying[k]->piece}; },
        [&](auto& row, std::size_t k) { visit_motion(varying[k]->prescribed, saved_in(row)); },
        tables);
  }
  for (auto& group : groups_) {
    load_chosen(
        "rigid.points", *group.points, group.chosen,
        [&](auto& row, std::size_t k) { visit_point_of_body(group, k, saved_in(row)); }, tables);
  }
  placed_.assign(bodies_.size(), {});
  start();
}

template class FreeBodies<2>;
template class FreeBodies<3>;

}  // namespace brunt
