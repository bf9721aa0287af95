#include "core/boundaries/surface_heat.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace brunt {

namespace {
constexpr Real kStefanBoltzmann = 5.670374419e-8;  // [W/m^2/K^4] CODATA 2018
constexpr Quantity kTemperature{"K", at_least(0), between(50, 5000)};
}  // namespace

void describe(Schema& s, Convection& convection) {
  s.varying({"h", "heat per area and degree", Need::required}, convection.h,
            {"W/m^2/K", at_least(0), between(0, 1e7)}, kTimeOrPlace);
  s.varying({"T", "temperature of the fluid", Need::required}, convection.T, kTemperature,
            kTimeOrPlace);
}

void describe(Schema& s, Radiation& radiation) {
  s.real({"emissivity", "share of what a black surface radiates"}, radiation.emissivity,
         {"1", between(0, 1)});
  s.varying({"T", "temperature of the surroundings", Need::required}, radiation.T, kTemperature,
            kTimeOrPlace);
}

void describe(Schema& s, SurfaceHeat& heat) {
  s.varying({"temperature", "these points are held at it; needs a material with thermal k"},
            heat.temperature, kTemperature, kTimeOrPlace);
  s.varying({"flux",
             "heat per area into the body, on outer facets all of "
             "whose points are chosen"},
            heat.flux, {"W/m^2", {}, between(-1e12, 1e12)}, kTimeOrPlace);
  s.object({"convection", "heat h (T - surface) per area, on such facets"}, heat.convection);
  s.object({"radiation", "heat emissivity sigma (T^4 - surface^4) per area, on such facets"},
           heat.radiation);
  s.require(!heat.temperature || !(heat.flux || heat.convection || heat.radiation), "temperature",
            "holds these points: flux, convection and radiation act elsewhere");
}

template <int Dim>
HeatBoundary<Dim>::HeatBoundary(const SurfaceHeat& given, Patch<Dim> on)
    : patch(std::move(on)),
      temperature(function_of(given.temperature)),
      flux(function_of(given.flux)) {
  if (given.convection) {
    film = function_of(given.convection->h), film_T = function_of(given.convection->T);
  }
  if (given.radiation) {
    emissivity = given.radiation->emissivity;
    radiation_T = function_of(given.radiation->T);
  }
  for (std::size_t k = 0; acts_on_areas() && k < patch.spacing.size(); ++k) {
    const Real width = patch.spacing[k];
    fixed_area.push_back(width * (Dim == 3 ? width : patch.depth));
  }
}

namespace {
/// True where two boundaries hold some point at different temperatures when both begin to act.
template <int Dim>
bool contradict(const HeatBoundary<Dim>& one, const HeatBoundary<Dim>& other) {
  const Patch<Dim>&a = one.patch, &b = other.patch;
  const Real from = std::max(a.from, b.from);
  if (!one.temperature || !other.temperature || a.points != b.points) return false;
  if (!(from < std::min(a.to, b.to))) return false;
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (!std::binary_search(b.chosen.begin(), b.chosen.end(), a.chosen[k])) continue;
    const Vec3 place = a.place(k);
    if ((*one.temperature)(from, place) != (*other.temperature)(from, place)) return true;
  }
  return false;
}
}  // namespace

template <int Dim>
std::string HeatBoundary<Dim>::problem(const std::vector<HeatBoundary>& others) const {
  if (!patch.points->conducts) {
    return "'" + patch.body + "' does not conduct heat: give its material `thermal: {cp, k}`" +
           ", and write heat: conduct or auto";
  }
  if (acts_on_areas() && patch.has_particles() && patch.whole) {
    return "acts on an area, and most of these particles are inside: choose a "
           "side or a plane";
  }
  std::string wrong = acts_on_areas() ? patch.needs_areas() : "";
  if (!wrong.empty()) return wrong;
  for (const auto& other : others) {
    if (contradict(*this, other)) {
      return "shares points with '" + other.patch.name +
             "', which holds them at another temperature";
    }
  }
  return "";
}

namespace {
/// Adds the area [m^2] of a face of space that each of its nodes stands for: equal shares. to(c)
/// where that of node c goes, null: nowhere
template <class To>
void add_area(const Patch<3>& patch, const Facet<3>& facet, const To& to) {
  const auto x = [&](int c) -> const Vec3& { return patch.points->x[facet.node[c]]; };
  const int n = facet.n_nodes();
  const Vec3 a = x(2) - x(0), b = n == 3 ? Vec3(x(1) - x(0)) : Vec3(x(3) - x(1));
  const Vec3 cross = a.cross(b);
  const Real share = 0.5 * std::sqrt(cross.dot(cross)) / n;
  for (std::size_t c = 0; c < slot_of(n); ++c) {
    if (Real* area = to(c)) *area += share;
  }
}
/// The same of an edge: int N_I (constant + radial r) ds.
template <class To>
void add_area(const Patch<2>& patch, const Facet<2>& facet, const To& to) {
  const auto i = slot_of(facet.node[0]);
  const auto j = slot_of(facet.node[1]);
  const auto& x = patch.points->x;
  const Real constant = patch.depth, radial = patch.depth > 0 ? 0 : 2 * kPi;
  const Vec<2> edge = x[j] - x[i];
  const Real length = std::sqrt(edge[0] * edge[0] + edge[1] * edge[1]);
  const Real ri = x[i][0], rj = x[j][0];
  if (Real* area = to(0)) *area += length * (0.5 * constant + radial * (2 * ri + rj) / 6);
  if (Real* area = to(1)) *area += length * (0.5 * constant + radial * (2 * rj + ri) / 6);
}
}  // namespace

/// Areas [m^2] of the chosen points in the present configuration, summed by ascending facet id.
template <int Dim>
std::vector<Real> HeatBoundary<Dim>::areas() const {
  if (!fixed_area.empty()) return fixed_area;
  std::vector<Real> area(patch.size(), 0.0);
  for (std::size_t f = 0; f < patch.facets.size(); ++f) {
    add_area(patch, patch.facets[f], [&](std::size_t c) {
      const LocalIndex k = patch.corners[f][c];
      return k < 0 ? nullptr : &area[k];
    });
  }
  return area;
}

template <int Dim>
void HeatBoundary<Dim>::start() {
  if (!temperature || !patch.acts(0)) return;
  auto& points = *patch.points;
  for (std::size_t k = 0; k < patch.size(); ++k) {
    const std::size_t i = patch.point(k);
    const Real T = (*temperature)(0, patch.place(k));
    const Real needed = points.heat_needed(i, T);
    points.heat[i] += needed, heat[k] += needed;
    points.temperature[i] = T;
  }
}

template <int Dim>
void HeatBoundary<Dim>::add_heat(Real time, Real dt) {
  if (!acts_on_areas()) return;
  auto& points = *patch.points;
  const std::vector<Real> area = areas();
  for (std::size_t k = 0; k < patch.size(); ++k) {
    rate[k] = 0;
    if (!patch.acts(time)) continue;
    const std::size_t i = patch.point(k);
    const Vec3 at = patch.place(k);
    const Real T = points.temperature[i];
    Real flow = 0, conductance = 0;  // per area
    if (flux) flow += (*flux)(time, at);
    if (film) {
      const Real h = (*film)(time, at);
      flow += h * ((*film_T)(time, at) - T);
      conductance += h;
    }
    if (emissivity > 0) {
      const Real around = (*radiation_T)(time, at), hot = std::max(T, around);
      const Real both = (T * T + around * around) * (T + around);
      flow += emissivity * kStefanBoltzmann * both * (around - T);
      conductance += emissivity * kStefanBoltzmann * 4 * hot * hot * hot;
    }
    rate[k] = area[k] * flow;
    heat[k] += dt * rate[k];
    points.heat_rate[i] += rate[k];
    points.conductance[i] += area[k] * conductance;
  }
}

template <int Dim>
void HeatBoundary<Dim>::hold_temperature(Real time, Real dt) {
  if (!temperature) return;
  auto& points = *patch.points;
  for (std::size_t k = 0; k < patch.size(); ++k) {
    rate[k] = 0;
    if (!patch.acts(time)) continue;
    const std::size_t i = patch.point(k);
    const Real T = (*temperature)(time, patch.place(k));
    const Real needed = points.heat_needed(i, T) / dt;
    rate[k] = needed - points.heat_rate[i];
    heat[k] += dt * rate[k];
    points.heat_rate[i] = needed;
  }
}

template <int Dim>
void HeatBoundary<Dim>::add_totals(Totals<Dim>& totals) const {
  for (const Real one : heat) totals.heat.boundary.add(one);
}

template struct HeatBoundary<2>;
template struct HeatBoundary<3>;

}  // namespace brunt
// Tested by tests/verification/conduction_test.cpp.
