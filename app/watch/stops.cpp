#include "app/watch/stops.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/watch/rigid_reports.hpp"

namespace brunt {

namespace {
/// The check of a deck has found the name.
template <int Dim>
Label label_of(const Scene<Dim>& scene, const std::string& body) {
  const auto& names = scene.body_names;
  return static_cast<Label>(std::find(names.begin(), names.end(), body) - names.begin());
}

/// Coordinate [m] of a body's centre of mass at a time [s], absolute; of one without mass that of
/// its shape.
template <int Dim>
Real center(const Scene<Dim>& scene, Label body, int axis, Real time) {
  if (const auto place = rigid_place(scene, body, time)) {
    return place->position[axis] + scene.origin[axis];
  }
  std::array<ExactSum, 2> sums;
  auto& [mass, moment] = sums;
  for (const auto& solid : scene.solids) {
    const auto& points = solid->points();
    for (std::size_t i = 0; i < points.owned(); ++i) {
      if (points.body[i] != body) continue;
      mass.add(points.mass[i]);
      moment.add(points.mass[i] * points.x[i][axis]);
    }
  }
  if (scene.rigid && scene.ranks->is_root()) {
    for (const auto& one : scene.rigid->all()) {
      if (one.body != body) continue;
      mass.add(one.state.mass);
      moment.add(one.state.mass * one.state.x[axis]);
    }
  }
  scene.ranks->reduce_all(std::span<ExactSum>(sums),
                          [](ExactSum& a, const ExactSum& b) { a.add(b); });
  return moment.value() / mass.value() + scene.origin[axis];
}

/// [m/s] of the fastest point of a body.
template <int Dim>
Real fastest_of(const Scene<Dim>& scene, Label body) {
  Real squared = 0;
  for (const auto& solid : scene.solids) {
    const auto& points = solid->points();
    for (std::size_t i = 0; i < points.owned(); ++i) {
      if (points.body[i] == body) squared = std::max(squared, points.v[i].squaredNorm());
    }
  }
  return std::sqrt(scene.ranks->max(squared));
}
}  // namespace

template <int Dim>
void StopConditions<Dim>::begin(const Scene<Dim>& scene, const std::vector<std::string>& columns) {
  const auto& beyond = stop_.beyond;
  if (beyond && static_cast<int>(beyond->axis) < Dim) {
    const Label body = label_of(scene, beyond->body);
    start_center_ = center(scene, body, static_cast<int>(beyond->axis), 0);
  }
  if (!stop_.when.empty()) when_.emplace(stop_.when, columns);
}

/// True once the body of stop.at_rest has been at rest for long enough.
template <int Dim>
bool StopConditions<Dim>::is_at_rest(const Scene<Dim>& scene, Real time) {
  const auto& rest = *stop_.at_rest;
  if (fastest_of(scene, label_of(scene, rest.body)) >= rest.below) {
    at_rest_since_ = -1;
    return false;
  }
  if (at_rest_since_ < 0) at_rest_since_ = time;
  return time - at_rest_since_ >= rest.duration;
}

template <int Dim>
std::string StopConditions<Dim>::look(const Scene<Dim>& scene, const Clock& clock,
                                      std::span<const Real> row) {
  std::string why;
  if (stop_.at_rest && is_at_rest(scene, clock.time())) why = stop_.at_rest->body + " is at rest";
  const auto& beyond = stop_.beyond;
  if (beyond && static_cast<int>(beyond->axis) < Dim) {
    const Label body = label_of(scene, beyond->body);
    const Real now = center(scene, body, static_cast<int>(beyond->axis), clock.time());
    const bool passed = (start_center_ - beyond->at) * (now - beyond->at) <= 0;
    if (passed) why = beyond->body + " is beyond its place";
  }
  // All ranks have the same row. What is no number, as 0/0 before anything touches, does not hold.
  const Real value = when_ && !row.empty() ? (*when_)(row) : 0;
  if (value != 0 && !std::isnan(value)) why = "stop.when holds: " + stop_.when;
  return why;
}

template class StopConditions<2>;
template class StopConditions<3>;

}  // namespace brunt
