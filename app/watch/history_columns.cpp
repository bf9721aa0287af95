#include "app/watch/history_columns.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "app/watch/column_names.hpp"
#include "app/watch/rigid_reports.hpp"

namespace brunt {

namespace {
/// The energy [J] that rounding alone may put into a scene at rest: strains of 1e-12 in all of it,
/// 1e-24 M V = 1e-24 m c^2. Drift is never measured against less, so that a body to which nothing
/// happens yet does not drift by its whole energy of rounding. Collective.
template <int Dim>
Real energy_of_rounding(const Scene<Dim>& scene) {
  ExactSum mass;
  for (const auto& solid : scene.solids) {
    const auto& points = solid->points();
    for (std::size_t i = 0; i < points.owned(); ++i) mass.add(points.mass[i]);
  }
  scene.ranks->reduce_all(std::span(&mass, 1), [](ExactSum& a, const ExactSum& b) { a.add(b); });
  if (scene.rigid) {  // all of them on all ranks
    for (const auto& body : scene.rigid->all()) mass.add(body.state.mass);
  }
  Real stiffest = 0;  // [m^2/s^2] c^2
  for (const auto& material : scene.materials) {
    stiffest = std::max(stiffest, (material->bulk + 4.0 / 3 * material->shear) / material->density);
  }
  return 1e-24 * stiffest * mass.value();
}
}  // namespace

template <int Dim>
HistoryColumns<Dim>::HistoryColumns(const Scene<Dim>& scene) {
  ColumnNames columns = column_names(scene);
  names_ = std::move(columns.names), whole_ = std::move(columns.whole);
  largest_ = energy_of_rounding(scene);
  energies_ = EnergyWatch(scene.body_names.size());
  energies_.start(1e6 * largest_);  // strains of 1e-9, speeds of 1e-9 c: no run stops for less
}

/// What boundaries report of their points, summed; all in one reduction.
template <int Dim>
void HistoryColumns<Dim>::add_boundaries(const Scene<Dim>& scene, std::vector<Real>& values) {
  std::vector<ExactSum> sums;
  const auto add = [&](const auto& of_points) {
    if constexpr (std::is_same_v<decltype(of_points), const std::vector<Real>&>) {
      auto& sum = sums.emplace_back();
      for (const Real one : of_points) sum.add(one);
    } else {
      for (int c = 0; c < Dim; ++c) {
        auto& sum = sums.emplace_back();
        for (const auto& one : of_points) sum.add(one[c]);
      }
    }
  };
  const auto add_torque = [&](const Patch<Dim>& patch, const std::vector<Vec<Dim>>& of_points) {
    const std::size_t first = sums.size();
    const int torque = first_torque(scene);
    sums.resize(first + slot_of(3 - torque));
    for (std::size_t k = 0; k < of_points.size(); ++k) {
      const Vec<Dim> place = scene.origin + patch.points->x[patch.point(k)];
      const Vec3 moment = in_space<Dim>(place).cross(in_space<Dim>(of_points[k]));
      for (int c = torque; c < 3; ++c) sums[first + slot_of(c - torque)].add(moment[c]);
    }
  };
  scene.boundaries.each([&](const auto& boundary) {
    if constexpr (requires { boundary.visit_reports([](const char*, const auto&) {}); }) {
      boundary.visit_reports([&](const char* what, const auto& of_points) {
        add(of_points);
        if constexpr (!std::is_same_v<decltype(of_points), const std::vector<Real>&>) {
          if (is_reaction(what)) add_torque(boundary.patch, of_points);
        }
      });
    }
  });
  scene.ranks->reduce_all(std::span(sums), [](ExactSum& a, const ExactSum& b) { a.add(b); });
  for (const auto& sum : sums) values.push_back(sum.value());
}

/// Probes and sections.
template <int Dim>
void HistoryColumns<Dim>::add_watched(const Scene<Dim>& scene, std::vector<Real>& values) {
  for (const auto& probe : scene.probes) {
    const auto view = scene.own_view(probe.body, fields_of(probe));
    const auto watched = probe_values(probe, view, *scene.ranks);
    values.insert(values.end(), watched.begin(), watched.end());
  }
  for (const auto& section : scene.sections.all()) {
    const auto total = scene.sections.force(section, scene.solids, scene.origin, *scene.ranks);
    for (std::size_t c = 0; c < Dim; ++c) values.push_back(total.force[c]);
    for (int c = first_torque(scene); c < 3; ++c) {
      values.push_back(total.moment[c]);
    }
  }
}

/// Sums of each body, and how much of its tension artificial stress carries.
template <int Dim>
void HistoryColumns<Dim>::add_bodies(const Scene<Dim>& scene, const Totals<Dim>& totals, Real time,
                                     Row& row) {
  const auto rigid = rigid_reports(scene, time);
  auto& values = row.values;
  Label label = 0;
  for (const auto& body : totals.bodies) {
    const Real mass = body.mass.value();
    const auto found = rigid.find(label);
    values.push_back(mass);
    for (int c = 0; c < Dim; ++c) {
      values.push_back(mass > 0 ? body.mass_position[c].value() / mass + scene.origin[c]
                       : found != rigid.end() ? found->second.position[c] + scene.origin[c]
                                              : 0.0);
    }
    for (int c = 0; c < Dim; ++c) {
      values.push_back(mass > 0               ? body.momentum[c].value() / mass
                       : found != rigid.end() ? found->second.velocity[c]
                                              : 0.0);
    }
    for (const auto* sum : {&body.kinetic, &body.internal, &body.hourglass, &body.heat}) {
      values.push_back(sum->value());
    }
    row.thin_share.push_back(mass > 0 ? body.thin_mass.value() / mass : 0.0);
    const Real tension = body.tension.value();
    row.artificial_share.push_back(
        tension > 0 ? std::fabs(body.artificial_tension.value()) / tension : 0.0);
    if (label < scene.erodes.size() && scene.erodes[label] != 0) {
      values.push_back(body.eroded.value()), values.push_back(body.eroded_mass.value());
    }
    ++label;
    if (found == rigid.end()) continue;
    const auto add = [&](const Vec3& vector, int first, int last) {
      for (int c = first; c < last; ++c) values.push_back(vector[c]);
    };
    const auto& report = found->second;
    const int turning = report.one_piece ? first_torque(scene) : 3;
    add(report.rotation, turning, 3), add(report.spin, turning, 3);
    add(report.force, 0, Dim), add(report.torque, first_torque(scene), 3);
  }
}

/// Pairs of bodies in contact; of them the deepest, and contacts that did not hold.
template <int Dim>
void HistoryColumns<Dim>::add_pairs(const Scene<Dim>& scene, Row& row) {
  auto& values = row.values;
  row.lost = scene.contact->lost_pairs(scene.origin);
  Real deepest = 0;
  for (const auto& pair : scene.contact->reports(scene.origin)) {
    if (pair.max_penetration > deepest) {
      deepest = pair.max_penetration, row.deepest_pair = pair.name;
    }
    for (int c = 0; c < Dim; ++c) values.push_back(pair.force[c]);
    for (int c = first_torque(scene); c < 3; ++c) {
      values.push_back(pair.torque[c]);
    }
    values.insert(values.end(), {pair.area, pair.heat_rate, pair.friction_heat,
                                 pair.max_penetration, static_cast<Real>(pair.planes)});
    if (!scene.conducts()) continue;
    values.insert(values.end(), {pair.temperature_max, pair.temperature_mean});
  }
}

/// The balance of heat.
template <int Dim>
void HistoryColumns<Dim>::add_heat(const Totals<Dim>& totals, std::vector<Real>& values) {
  ExactSum left = totals.heat.stored;
  const auto& heat = totals.heat;
  for (const auto* from : {&heat.plastic, &heat.compression, &heat.friction, &heat.boundary})
    left.subtract(*from);
  for (const auto* sum :
       {&heat.stored, &heat.plastic, &heat.compression, &heat.friction, &heat.boundary}) {
    values.push_back(sum->value());
    largest_heat_ = std::max(largest_heat_, std::fabs(values.back()));
  }
  // Points and bodies that only exchange heat among themselves store none together.
  largest_heat_ = std::max(largest_heat_, heat.moved.value());
  for (const auto& body : totals.bodies) {
    largest_heat_ = std::max(largest_heat_, std::fabs(body.heat.value()));
  }
  values.push_back(largest_heat_ > 0 ? left.value() / largest_heat_ : 0.0);
}

template <int Dim>
typename HistoryColumns<Dim>::Row HistoryColumns<Dim>::collect(const Scene<Dim>& scene,
                                                               const Clock& clock, bool keeps,
                                                               bool hashes) {
  const Totals<Dim> totals = scene.totals(clock.dt(), hashes);
  Row row;
  auto& values = row.values;
  values = {clock.time(), static_cast<Real>(clock.step()), clock.dt(),
            static_cast<Real>(clock.whose().body)};
  row.whole = whole_;
  ExactSum total;
  for (const auto& column : totals.columns) {
    values.push_back(column.value());
    largest_ = std::max(largest_, std::fabs(values.back()));
    total.add(column);
  }
  row.total = total.value();
  if (first_) total_start_ = row.total;
  first_ = false;
  row.drift = largest_ > 0 ? (row.total - total_start_) / largest_ : 0.0;
  row.energies = energy_look(totals, scene.sum_of_body);
  if (keeps) energies_.keep(row.energies);
  row.created = energies_.created(row.energies);
  values.insert(values.end(), {row.total, row.drift, sum(row.created)});

  for (int c = 0; c < Dim; ++c) {
    ExactSum momentum;
    for (const auto& body : totals.bodies) momentum.add(body.momentum[c]);
    values.push_back(momentum.value());
  }
  add_bodies(scene, totals, clock.time(), row);
  if (scene.contact) add_pairs(scene, row);
  add_boundaries(scene, values);
  add_watched(scene, values);
  if (scene.conducts()) add_heat(totals, values);
  row.state_hash = totals.state_hash;
  return row;
}

template <int Dim>
void HistoryColumns<Dim>::save_state(std::vector<StateTable>& tables) const {
  save_row(
      "history.energies", [&](auto& row) { EnergyWatch::visit(row, energies_); }, tables);
  save_row(
      "history.drift",
      [&](auto& row) { row(first_), row(total_start_), row(largest_), row(largest_heat_); },
      tables);
}

template <int Dim>
void HistoryColumns<Dim>::load_state(const StateTables& tables) {
  load_row(
      "history.energies", [&](auto& row) { EnergyWatch::visit(row, energies_); }, tables);
  load_row(
      "history.drift",
      [&](auto& row) { row(first_), row(total_start_), row(largest_), row(largest_heat_); },
      tables);
}

template class HistoryColumns<2>;
template class HistoryColumns<3>;

}  // namespace brunt
