#include "core/boundaries/heat.hpp"

#include <algorithm>
#include <utility>

#include "core/points_state.hpp"

namespace brunt {

namespace {
constexpr Real kStefanBoltzmann = 5.670374419e-8;  // [W/m^2/K^4] CODATA 2018
}

template <int Dim>
HeatBoundaries<Dim>::HeatBoundaries(Vec<Dim> origin, Geometry geometry, Real depth)
    : origin_(std::move(origin)),
      constant_(geometry == Geometry::plane_strain ? depth : 0),
      radial_(geometry == Geometry::axisymmetric ? 2 * kPi : 0) {}

template <int Dim>
void HeatBoundaries<Dim>::add(HeatBoundary<Dim> boundary) {
  boundary.rate.assign(boundary.chosen.size(), 0.0);
  boundary.heat.assign(boundary.chosen.size(), 0.0);
  boundaries_.push_back(std::move(boundary));
}

template <int Dim>
void HeatBoundaries<Dim>::follow(const Points<Dim>& old, Points<Dim>& now) {
  const auto here = [&](LocalIndex point) { return now.find(old.id[std::size_t(point)]); };
  for (auto& boundary : boundaries_) {
    if (boundary.points != &old) continue;
    HeatBoundary<Dim> part = boundary;
    part.points = &now;
    part.chosen.clear(), part.fixed_area.clear(), part.facets.clear();
    for (std::size_t k = 0; k < boundary.chosen.size(); ++k) {
      const LocalIndex point = here(boundary.chosen[k]);
      if (point < 0 || point >= now.n_owned) continue;
      part.chosen.push_back(point);
      if (!boundary.fixed_area.empty()) part.fixed_area.push_back(boundary.fixed_area[k]);
    }
    for (auto facet : boundary.facets) {
      bool all = true, owned = false;
      for (int c = 0; c < facet.n_nodes(); ++c) {
        auto& node = facet.node[static_cast<std::size_t>(c)];
        node = here(node);
        all = all && node >= 0;
        owned = owned || (node >= 0 && node < now.n_owned);
      }
      if (all && owned) part.facets.push_back(facet);
    }
    part.rate.assign(part.chosen.size(), 0.0);
    part.heat.assign(part.chosen.size(), 0.0);
    boundary = std::move(part);
  }
}

template <int Dim>
Vec3 HeatBoundaries<Dim>::place(const HeatBoundary<Dim>& boundary, std::size_t k) const {
  Vec3 at = Vec3::Zero();
  const auto i = static_cast<std::size_t>(boundary.chosen[k]);
  at.template head<Dim>() = boundary.points->x_start[i] + origin_;
  return at;
}

namespace {
/// Area [m^2] of a face of space that each of its nodes stands for: equal shares.
void add_area(const Facet<3>& facet, const Points<3>& points, Real, Real, std::vector<Real>& area) {
  const auto x = [&](int c) -> const Vec3& {
    return points.x[static_cast<std::size_t>(facet.node[static_cast<std::size_t>(c)])];
  };
  const int n = facet.n_nodes();
  const Vec3 a = x(2) - x(0), b = n == 3 ? Vec3(x(1) - x(0)) : Vec3(x(3) - x(1));
  const Vec3 cross = a.cross(b);
  const Real share = 0.5 * std::sqrt(cross.dot(cross)) / n;
  for (int c = 0; c < n; ++c) {
    area[static_cast<std::size_t>(facet.node[static_cast<std::size_t>(c)])] += share;
  }
}
/// The same of an edge: int N_I (constant + radial r) ds.
void add_area(const Facet<2>& facet, const Points<2>& points, Real constant, Real radial,
              std::vector<Real>& area) {
  const auto i = static_cast<std::size_t>(facet.node[0]);
  const auto j = static_cast<std::size_t>(facet.node[1]);
  const Vec<2> edge = points.x[j] - points.x[i];
  const Real length = std::sqrt(edge[0] * edge[0] + edge[1] * edge[1]);
  const Real ri = points.x[i][0], rj = points.x[j][0];
  area[i] += length * (0.5 * constant + radial * (2 * ri + rj) / 6);
  area[j] += length * (0.5 * constant + radial * (2 * rj + ri) / 6);
}
}  // namespace

/// Areas [m^2] of the chosen points in the present configuration, summed by ascending facet id.
template <int Dim>
std::vector<Real> HeatBoundaries<Dim>::areas(const HeatBoundary<Dim>& boundary) const {
  if (!boundary.fixed_area.empty() || boundary.chosen.empty()) return boundary.fixed_area;
  std::vector<Real> by_point(boundary.points->x.size(), 0.0), area;
  for (const auto& facet : boundary.facets) {
    add_area(facet, *boundary.points, constant_, radial_, by_point);
  }
  for (const LocalIndex i : boundary.chosen) area.push_back(by_point[std::size_t(i)]);
  return area;
}

template <int Dim>
void HeatBoundaries<Dim>::start() {
  for (auto& boundary : boundaries_) {
    auto& points = *boundary.points;
    for (std::size_t k = 0; k < boundary.chosen.size() && boundary.temperature; ++k) {
      if (!boundary.acts(0)) break;
      const auto i = static_cast<std::size_t>(boundary.chosen[k]);
      const Real T = (*boundary.temperature)(0, place(boundary, k));
      const Real heat = points.heat_needed(i, T);
      points.heat[i] += heat, boundary.heat[k] += heat;
      points.temperature[i] = T;
    }
  }
  add_heat(0, 0);
  for (auto& boundary : boundaries_) {
    if (boundary.points->conducts) {
      std::fill(boundary.points->heat_rate.begin(), boundary.points->heat_rate.end(), 0.0);
    }
  }
}

template <int Dim>
void HeatBoundaries<Dim>::add_heat(Real time, Real dt) {
  for (auto& boundary : boundaries_) {
    if (!boundary.acts_on_areas()) continue;
    auto& points = *boundary.points;
    const std::vector<Real> area = areas(boundary);
    for (std::size_t k = 0; k < boundary.chosen.size(); ++k) {
      boundary.rate[k] = 0;
      if (!boundary.acts(time)) continue;
      const auto i = static_cast<std::size_t>(boundary.chosen[k]);
      const Vec3 at = place(boundary, k);
      const Real T = points.temperature[i];
      Real rate = 0, conductance = 0;  // per area
      if (boundary.flux) rate += (*boundary.flux)(time, at);
      if (boundary.film) {
        const Real h = (*boundary.film)(time, at);
        rate += h * ((*boundary.film_T)(time, at) - T);
        conductance += h;
      }
      if (boundary.emissivity > 0) {
        const Real around = (*boundary.radiation_T)(time, at), hot = std::max(T, around);
        const Real both = (T * T + around * around) * (T + around);
        rate += boundary.emissivity * kStefanBoltzmann * both * (around - T);
        conductance += boundary.emissivity * kStefanBoltzmann * 4 * hot * hot * hot;
      }
      boundary.rate[k] = area[k] * rate;
      boundary.heat[k] += dt * boundary.rate[k];
      points.heat_rate[i] += boundary.rate[k];
      points.conductance[i] += area[k] * conductance;
    }
  }
}

template <int Dim>
void HeatBoundaries<Dim>::hold(Real time, Real dt) {
  for (auto& boundary : boundaries_) {
    if (!boundary.temperature) continue;
    auto& points = *boundary.points;
    for (std::size_t k = 0; k < boundary.chosen.size(); ++k) {
      boundary.rate[k] = 0;
      if (!boundary.acts(time)) continue;
      const auto i = static_cast<std::size_t>(boundary.chosen[k]);
      const Real T = (*boundary.temperature)(time, place(boundary, k));
      const Real needed = points.heat_needed(i, T) / dt;
      boundary.rate[k] = needed - points.heat_rate[i];
      boundary.heat[k] += dt * boundary.rate[k];
      points.heat_rate[i] = needed;
    }
  }
}

template <int Dim>
void HeatBoundaries<Dim>::add_totals(Totals<Dim>& totals) const {
  for (const auto& boundary : boundaries_) {
    for (const Real heat : boundary.heat) totals.heat.boundary.add(heat);
  }
}

namespace {
template <class Row, class Boundary>
void visit_boundary(Row& row, Boundary& boundary, std::size_t k) {
  row(boundary.rate[k]);
  row(boundary.heat[k]);
}
std::string heat_table(const std::string& boundary) { return "heat." + boundary; }
}  // namespace

template <int Dim>
void HeatBoundaries<Dim>::save_state(std::vector<StateTable>& tables) const {
  for (const auto& boundary : boundaries_) {
    save_chosen(
        heat_table(boundary.name), *boundary.points, boundary.chosen,
        [&](auto& row, std::size_t k) { visit_boundary(row, boundary, k); }, tables);
  }
}

template <int Dim>
void HeatBoundaries<Dim>::load_state(const StateTables& tables) {
  for (auto& boundary : boundaries_) {
    load_chosen(
        heat_table(boundary.name), *boundary.points, boundary.chosen,
        [&](auto& row, std::size_t k) { visit_boundary(row, boundary, k); }, tables);
  }
}

template <int Dim>
StepLimit heat_step(const Points<Dim>& points) {
  StepLimit step_limit;
  if (!points.conducts) return step_limit;
  const Real steps = points.conduction_every;
  for (std::size_t i = 0; i < static_cast<std::size_t>(points.n_owned); ++i) {
    // Infinite where nothing flows.
    const Real step = points.least_capacity(i) / (steps * points.conductance[i]);
    step_limit.take({step >= 0 ? step : 0.0, "heat of point", points.body[i], points.id[i]});
  }
  return step_limit;
}

template class HeatBoundaries<2>;
template class HeatBoundaries<3>;
template StepLimit heat_step(const Points<2>&);
template StepLimit heat_step(const Points<3>&);

}  // namespace brunt
