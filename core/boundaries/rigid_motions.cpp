#include "core/boundaries/rigid_motions.hpp"

#include <utility>

#include "core/parallel/threads.hpp"
#include "core/points_state.hpp"

namespace brunt {

template <int Dim>
void RigidMotions<Dim>::add(Points<Dim>& points, std::vector<RigidMotion<Dim>> motions,
                            std::set<Label> free) {
  Group rigid{&points, std::move(motions), std::move(free), {}, {}, {}, {}};
  for (const Label body : points.body) {
    if (!rigid.free.contains(body)) rigid.bodies.insert(body);
  }
  rigid.motions.push_back({});  // the last one: held
  name_motions(rigid);
  groups_.push_back(std::move(rigid));
}

template <int Dim>
void RigidMotions<Dim>::name_motions(Group& rigid) {
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
void RigidMotions<Dim>::follow(const Points<Dim>& old, Points<Dim>& now) {
  for (auto& rigid : groups_) {
    if (rigid.points != &old) continue;
    rigid.points = &now;
    name_motions(rigid);
  }
}

template <int Dim>
void RigidMotions<Dim>::start() {
  for (auto& rigid : groups_) {
    for (std::size_t i = 0; i < rigid.motion_of_point.size(); ++i) {
      if (rigid.motion_of_point[i] == kFree) continue;
      const auto& motion = rigid.motions[rigid.motion_of_point[i]];
      rigid.points->v[i] = motion.velocity_at(rigid.points->x_start[i], 0);
    }
  }
}

template <int Dim>
void RigidMotions<Dim>::impose(Real time, Real dt) {
  for (auto& rigid : groups_) {
    auto& points = *rigid.points;
    std::vector<RigidPose<Dim>> from, to;
    for (auto& motion : rigid.motions) {
      from.push_back(motion.pose(time - dt));
      motion.advance(time, dt);
      to.push_back(motion.pose(time));
    }
    const LocalIndex n = points.size();  // copies have a prescribed motion too
    for_each(n, kPointsWorthThreads, [&](LocalIndex point) {
      const auto i = slot_of(point);
      const std::size_t which = rigid.motion_of_point[i];
      if (which == kFree) return;
      const auto& motion = rigid.motions[which];
      const Vec<Dim> now = motion.position(points.x_start[i], to[which]);
      const Vec<Dim> before = motion.position(points.x_start[i], from[which]);
      points.x[i] = now;
      points.x_rest[i].setZero();
      points.v[i] = (now - before) / dt;
    });
  }
}

template <int Dim>
void RigidMotions<Dim>::take_reactions(Real dt) {
  for (auto& rigid : groups_) {
    // Every rank has all rigid points; the owner of each knows its force and keeps its books.
    for (std::size_t i = 0; i < rigid.points->owned(); ++i) {
      if (rigid.motion_of_point[i] == kFree) continue;
      const Vec<Dim> reaction = -rigid.points->f[i];
      rigid.work[i] += 0.5 * dt * rigid.points->v[i].dot(rigid.reaction[i] + reaction);
      rigid.reaction[i] = reaction;
    }
  }
}

template <int Dim>
void RigidMotions<Dim>::add_totals(Totals<Dim>& totals) const {
  for (const auto& rigid : groups_) {
    for (const Real work : rigid.work) totals.add(Column::boundary, -work);
  }
}

namespace {
std::string table_of(std::size_t group) {
  return group == 0 ? "rigid" : "rigid." + std::to_string(group);
}

/// How far those have come whose rates are not constant follows from all steps.
constexpr auto kItself = [](const auto& motion) -> auto& { return motion; };
}  // namespace

template <int Dim>
void RigidMotions<Dim>::save_state(std::vector<StateTable>& tables) const {
  for (std::size_t k = 0; k < groups_.size(); ++k) {
    const auto& rigid = groups_[k];
    save_rows(
        table_of(k), rigid.points->owned(), [&](std::size_t i) { return rigid.points->id[i]; },
        [&](auto& row, std::size_t i) { rigid.visit_fields(rigid, saved_in(row, i)); }, tables);
    const auto motions = varying_of(rigid.motions, kItself);
    if (motions.empty()) continue;
    save_rows(
        table_of(k) + ".motions", motions.size(),
        [&](std::size_t i) { return GlobalId{motions[i]->body}; },
        [&](auto& row, std::size_t i) { visit_motion(*motions[i], saved_in(row)); }, tables);
  }
}

template <int Dim>
void RigidMotions<Dim>::load_state(const StateTables& tables) {
  for (std::size_t k = 0; k < groups_.size(); ++k) {
    auto& rigid = groups_[k];
    load_rows(
        table_of(k), rigid.points->owned(), [&](std::size_t i) { return rigid.points->id[i]; },
        [&](auto& row, std::size_t i) { rigid.visit_fields(rigid, saved_in(row, i)); }, tables);
    const auto motions = varying_of(rigid.motions, kItself);
    if (motions.empty()) continue;
    load_rows(
        table_of(k) + ".motions", motions.size(),
        [&](std::size_t i) { return GlobalId{motions[i]->body}; },
        [&](auto& row, std::size_t i) { visit_motion(*motions[i], saved_in(row)); }, tables);
  }
}

template class RigidMotions<2>;
template class RigidMotions<3>;

}  // namespace brunt
// Tested by tests/unit/app/supports_test.cpp.
