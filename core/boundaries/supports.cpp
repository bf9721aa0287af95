#include "core/boundaries/supports.hpp"

#include <utility>

#include "core/points_state.hpp"

namespace brunt {

namespace {
template <int Dim>
Vec3 absolute(const Vec<Dim>& x, const Vec<Dim>& origin) {
  Vec3 place = Vec3::Zero();
  place.template head<Dim>() = x + origin;
  return place;
}

template <int Dim>
bool acts(const Constraint<Dim>& constraint, Real time) {
  return time >= constraint.from && time <= constraint.to;
}
}  // namespace

template <int Dim>
void Supports<Dim>::move_rigid(Points<Dim>& points, std::vector<RigidMotion<Dim>> motions,
                               std::set<Label> free) {
  Rigid rigid{&points, std::move(motions), std::move(free), {}, {}, {}, {}};
  for (const Label body : points.body) {
    if (!rigid.free.contains(body)) rigid.bodies.insert(body);
  }
  rigid.motions.push_back({});  // the last one: held
  name_motions(rigid);
  rigid_.push_back(std::move(rigid));
}

template <int Dim>
void Supports<Dim>::name_motions(Rigid& rigid) {
  rigid.motion_of_point.clear();
  for (const Label body : rigid.points->body) {
    if (rigid.free.contains(body)) {
      rigid.motion_of_point.push_back(kFree);
      continue;
    }
    std::size_t which = 0;
    while (which + 1 < rigid.motions.size() && rigid.motions[which].body != body) ++which;
    rigid.motion_of_point.push_back(which);
  }
  rigid.reaction.assign(rigid.points->x.size(), Vec<Dim>::Zero());
  rigid.work.assign(rigid.points->x.size(), 0.0);
}

template <int Dim>
void Supports<Dim>::follow(const Points<Dim>& old, Points<Dim>& now) {
  for (auto& rigid : rigid_) {
    if (rigid.points != &old) continue;
    rigid.points = &now;
    name_motions(rigid);
  }
  for (auto& constraint : constraints_) {
    if (constraint.points != &old) continue;
    std::vector<LocalIndex> chosen;
    for (const LocalIndex point : constraint.chosen) {
      const LocalIndex here = now.find(old.id[static_cast<std::size_t>(point)]);
      if (here >= 0 && here < now.n_owned) chosen.push_back(here);
    }
    constraint.points = &now;
    constraint.chosen = std::move(chosen);
    constraint.reaction.assign(constraint.chosen.size(), Vec<Dim>::Zero());
    constraint.work.assign(constraint.chosen.size(), 0.0);
  }
}

template <int Dim>
void Supports<Dim>::constrain(Constraint<Dim> constraint) {
  constraint.reaction.assign(constraint.chosen.size(), Vec<Dim>::Zero());
  constraint.work.assign(constraint.chosen.size(), 0.0);
  constraints_.push_back(std::move(constraint));
}

template <int Dim>
void Supports<Dim>::start() {
  for (auto& rigid : rigid_) {
    for (std::size_t i = 0; i < rigid.motion_of_point.size(); ++i) {
      if (rigid.motion_of_point[i] == kFree) continue;
      const auto& motion = rigid.motions[rigid.motion_of_point[i]];
      Vec3 arm = Vec3::Zero();
      arm.template head<Dim>() = rigid.points->x_start[i] - motion.center;
      rigid.points->v[i] =
          motion.velocity + (motion.spin * motion.axis.cross(arm)).template head<Dim>();
    }
  }
  for (auto& constraint : constraints_) {
    if (!acts(constraint, 0)) continue;
    for (const LocalIndex point : constraint.chosen) {
      const auto i = static_cast<std::size_t>(point);
      const Vec3 place = absolute<Dim>(constraint.points->x_start[i], origin_);
      for (int c = 0; c < Dim; ++c) {
        if (constraint.velocity[c])
          constraint.points->v[i][c] = (*constraint.velocity[c])(0, place);
      }
    }
  }
}

template <int Dim>
void Supports<Dim>::impose(Real time, Real dt) {
  for (auto& rigid : rigid_) impose_rigid(rigid, time, dt);
  for (auto& constraint : constraints_) {
    if (acts(constraint, time)) impose_constraint(constraint, time, dt);
  }
}

template <int Dim>
void Supports<Dim>::impose_rigid(Rigid& rigid, Real time, Real dt) {
  auto& points = *rigid.points;
#pragma omp parallel for schedule(static)
  for (LocalIndex point = 0; point < points.size();
       ++point) {  // copies have a prescribed motion too
    const auto i = static_cast<std::size_t>(point);
    if (rigid.motion_of_point[i] == kFree) continue;
    const auto& motion = rigid.motions[rigid.motion_of_point[i]];
    const Vec<Dim> now = motion.position(points.x_start[i], time);
    const Vec<Dim> before = motion.position(points.x_start[i], time - dt);
    points.x[i] = now;
    points.x_rest[i].setZero();
    points.v[i] = (now - before) / dt;
  }
}

template <int Dim>
void Supports<Dim>::impose_constraint(Constraint<Dim>& constraint, Real time, Real dt) {
  auto& points = *constraint.points;
  for (std::size_t k = 0; k < constraint.chosen.size(); ++k) {
    const auto i = static_cast<std::size_t>(constraint.chosen[k]);
    const Vec3 place = absolute<Dim>(points.x_start[i], origin_);
    Vec<Dim> change = Vec<Dim>::Zero();  // of the motion that was predicted
    for (int c = 0; c < Dim; ++c) {
      if (!constraint.velocity[c]) continue;
      const Real old = points.a[i][c];
      const Real v_start = points.v[i][c] - 0.5 * dt * old;
      const Real v_half = (*constraint.velocity[c])(time - 0.5 * dt, place);
      const Real needed = 2 * (v_half - v_start) / dt;
      constraint.reaction[k][c] += points.mass[i] * (needed - old);
      points.integration[i] += dt * dt / 8 * points.mass[i] * (needed * needed - old * old);
      points.a[i][c] = needed;
      change[c] = dt * (v_half - points.v[i][c]);
      points.v[i][c] = v_half;
    }
    points.move(i, change);
  }
}

template <int Dim>
void Supports<Dim>::take_reactions(Real time, Real dt) {
  for (auto& rigid : rigid_) {
    // Every rank has all rigid points; the owner of each knows its force and keeps its books.
    for (std::size_t i = 0; i < static_cast<std::size_t>(rigid.points->n_owned); ++i) {
      if (rigid.motion_of_point[i] == kFree) continue;
      const Vec<Dim> reaction = -rigid.points->f[i];
      rigid.work[i] += 0.5 * dt * rigid.points->v[i].dot(rigid.reaction[i] + reaction);
      rigid.reaction[i] = reaction;
    }
  }
  for (auto& constraint : constraints_) {
    auto& points = *constraint.points;
    for (std::size_t k = 0; k < constraint.chosen.size(); ++k) {
      const auto i = static_cast<std::size_t>(constraint.chosen[k]);
      const Vec3 place = absolute<Dim>(points.x_start[i], origin_);
      Vec<Dim> reaction = Vec<Dim>::Zero();
      for (int c = 0; c < Dim && acts(constraint, time); ++c) {
        if (!constraint.velocity[c]) continue;
        const Real v_end = (*constraint.velocity[c])(time, place);
        const Real needed = 2 * (v_end - points.v[i][c]) / dt;
        reaction[c] = points.mass[i] * needed - points.f[i][c];
        points.f[i][c] = points.mass[i] * needed;
      }
      constraint.work[k] += 0.5 * dt * points.v[i].dot(constraint.reaction[k] + reaction);
      constraint.reaction[k] = reaction;
    }
  }
}

template <int Dim>
void Supports<Dim>::add_totals(Totals<Dim>& totals) const {
  for (const auto& rigid : rigid_) {
    for (const Real work : rigid.work) totals.add(Column::boundary, -work);
  }
  for (const auto& constraint : constraints_) {
    for (const Real work : constraint.work) totals.add(Column::boundary, -work);
  }
}

namespace {
template <class Row, class Held>
void visit_held(Row& row, Held& held, std::size_t k) {
  row(held.reaction[k]);
  row(held.work[k]);
}

std::string support_table(const std::string& constraint) { return "support." + constraint; }
std::string rigid_table(std::size_t group) {
  return group == 0 ? "rigid" : "rigid." + std::to_string(group);
}
}  // namespace

template <int Dim>
void Supports<Dim>::save_state(std::vector<StateTable>& tables) const {
  for (std::size_t k = 0; k < rigid_.size(); ++k) {
    const auto& rigid = rigid_[k];
    save_rows(
        rigid_table(k), static_cast<std::size_t>(rigid.points->n_owned),
        [&](std::size_t i) { return rigid.points->id[i]; },
        [&](auto& row, std::size_t i) { visit_held(row, rigid, i); }, tables);
  }
  for (const auto& held : constraints_) {
    save_chosen(
        support_table(held.name), *held.points, held.chosen,
        [&](auto& row, std::size_t k) { visit_held(row, held, k); }, tables);
  }
}

template <int Dim>
void Supports<Dim>::load_state(const StateTables& tables) {
  for (std::size_t k = 0; k < rigid_.size(); ++k) {
    auto& rigid = rigid_[k];
    load_rows(
        rigid_table(k), static_cast<std::size_t>(rigid.points->n_owned),
        [&](std::size_t i) { return rigid.points->id[i]; },
        [&](auto& row, std::size_t i) { visit_held(row, rigid, i); }, tables);
  }
  for (auto& held : constraints_) {
    load_chosen(
        support_table(held.name), *held.points, held.chosen,
        [&](auto& row, std::size_t k) { visit_held(row, held, k); }, tables);
  }
}

template class Supports<2>;
template class Supports<3>;

}  // namespace brunt
