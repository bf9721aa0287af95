#include "core/rigid/mass_properties.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace brunt {

namespace {
/// Moments of a region about a point: volume (area in 2D), first and second.
template <int Dim>
struct Moments {
  Real volume = 0;
  Vec<Dim> first = Vec<Dim>::Zero();
  Eigen::Matrix<Real, Dim, Dim> second = Eigen::Matrix<Real, Dim, Dim>::Zero();

  /// Adds the simplex from the point to a facet's corners, which are given from there: a linear
  /// map of the standard simplex, of which integral x_i x_j = V (1 + delta_ij)/((n+1)(n+2)).
  void add(const std::array<Vec<Dim>, Dim>& corner) {
    Vec<Dim> sum = Vec<Dim>::Zero();
    Eigen::Matrix<Real, Dim, Dim> columns, products = Eigen::Matrix<Real, Dim, Dim>::Zero();
    for (int c = 0; c < Dim; ++c) {
      const auto& x = corner[c];
      columns.col(c) = x;
      sum += x;
      products += x * x.transpose();
    }
    const Real part = columns.determinant() / (Dim == 2 ? 2 : 6);
    volume += part;
    first += part / (Dim + 1) * sum;
    second += part / ((Dim + 1) * (Dim + 2)) * (products + sum * sum.transpose());
  }
};

/// The simplices of a facet, corners from `from`.
template <class Take>
void for_simplices(const Points<2>& points, const Facet<2>& facet, const Vec<2>& from,
                   const Take& take) {
  const auto at = [&](std::size_t c) -> Vec<2> { return points.x[facet.node[c]] - from; };
  take(std::array{at(0), at(1)}, (at(1) - at(0)).norm());
}
template <class Take>
void for_simplices(const Points<3>& points, const Facet<3>& facet, const Vec3& from,
                   const Take& take) {
  const auto n = slot_of(facet.n_nodes());
  std::array<Vec3, 4> x;
  Vec3 middle = Vec3::Zero();
  for (std::size_t c = 0; c < n; ++c) {
    x[c] = points.x[facet.node[c]] - from;
    middle += x[c] / static_cast<Real>(n);
  }
  const auto triangle = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
    take(std::array{a, b, c}, 0.5 * (b - a).cross(c - a).norm());
  };
  if (n == 3) return triangle(x[0], x[1], x[2]);
  for (std::size_t c = 0; c < n; ++c) triangle(x[c], x[(c + 1) % n], middle);
}

/// Moments about the axis r = 0 of a section, by the radius: a whole ring.
void make_ring(const Moments<2>& section, const Vec<2>& from, MassProperties& body) {
  const Real radii = from[0] * section.volume + section.first[0];
  const Real heights = from[0] * section.first[1] + section.second(0, 1);  // integral r (y - from)
  body.volume = 2 * kPi * radii;
  body.center = Vec3(0, from[1] + heights / radii, 0);
}
}  // namespace

template <int Dim>
MassProperties mass_properties(const Points<Dim>& points, std::span<const Facet<Dim>> facets,
                               Real density, Geometry geometry, Real depth,
                               std::span<const char> cut) {
  // Moments about a point near the body lose no digits to its distance from the origin.
  const Vec<Dim> from = points.x[facets.front().node[0]];
  Moments<Dim> moments;
  MassProperties body;
  for (std::size_t f = 0; f < facets.size(); ++f) {
    const auto& facet = facets[f];
    Real breadth = geometry == Geometry::plane_strain ? depth : 1;
    if (geometry == Geometry::axisymmetric) {
      breadth = 0;  // 2 pi times the mean radius
      for (const LocalIndex node : facet.node) {
        breadth += kPi * points.x[node][0];
      }
    }
    const bool is_cut = !cut.empty() && cut[f] != 0;
    for_simplices(points, facet, from, [&](const std::array<Vec<Dim>, Dim>& corner, Real area) {
      moments.add(corner);
      if (!is_cut) body.area += breadth * area;
    });
  }
  if (!(moments.volume > 0)) throw std::invalid_argument("encloses no volume");
  if (geometry == Geometry::axisymmetric) {
    if constexpr (Dim == 2) make_ring(moments, from, body);
    body.mass = density * body.volume;
    return body;
  }
  const Real thick = Dim == 2 ? depth : 1;
  body.volume = thick * moments.volume;
  body.mass = density * body.volume;
  const Vec<Dim> center = moments.first / moments.volume;
  body.center.template head<Dim>() = from + center;
  const Eigen::Matrix<Real, Dim, Dim> central =
      density * thick * (moments.second - moments.volume * center * center.transpose());
  body.inertia = central.trace() * Mat3::Identity();
  if constexpr (Dim == 3) body.inertia -= central;
  return body;
}

namespace {
template <int Dim>
Vec<Dim> center_of_area(const Points<Dim>& points, std::span<const Facet<Dim>> facets,
                        Geometry geometry) {
  const Vec<Dim> from = points.x[facets.front().node[0]];
  const bool ring = geometry == Geometry::axisymmetric;
  Real whole = 0;
  Vec<Dim> first = Vec<Dim>::Zero();
  for (const auto& facet : facets) {
    for_simplices(points, facet, from, [&](const std::array<Vec<Dim>, Dim>& corner, Real area) {
      Vec<Dim> middle = Vec<Dim>::Zero();
      for (const auto& x : corner) middle += x / Dim;
      if (!ring) {
        whole += area, first += area * middle;
        return;
      }
      // With r linear along an edge: integral r y = L (r y at the middle + dr dy / 12).
      const Vec<Dim> edge = corner[1] - corner[0];
      const Real radius = from[0] + middle[0];
      whole += area * radius;
      first[1] += area * (radius * middle[1] + edge[0] * edge[1] / 12);
    });
  }
  Vec<Dim> center = from + first / whole;
  if (ring) center[0] = 0;
  return center;
}
}  // namespace

template <int Dim>
Vec<Dim> center_of_shape(const Points<Dim>& points, std::span<const Facet<Dim>> facets,
                         Geometry geometry) {
  const bool open = std::any_of(facets.begin(), facets.end(), [](auto& one) { return one.open; });
  if (open) return center_of_area(points, facets, geometry);
  try {
    constexpr Real kNone = 1e-9;  // of the cube of its size: a sheet that is there twice
    const MassProperties body = mass_properties(points, facets, 1, geometry, 1);
    const bool plane = geometry == Geometry::plane_strain;
    const Real size = plane ? body.area : std::sqrt(body.area);
    const Real cube = plane ? size * size : size * size * size;
    if (body.volume > kNone * cube) return body.center.template head<Dim>();
  } catch (const std::invalid_argument&) {  // inside out, in the plane
  }
  return center_of_area(points, facets, geometry);
}

template Vec<2> center_of_shape<2>(const Points<2>&, std::span<const Facet<2>>, Geometry);
template Vec<3> center_of_shape<3>(const Points<3>&, std::span<const Facet<3>>, Geometry);
template MassProperties mass_properties<2>(const Points<2>&, std::span<const Facet<2>>, Real,
                                           Geometry, Real, std::span<const char>);
template MassProperties mass_properties<3>(const Points<3>&, std::span<const Facet<3>>, Real,
                                           Geometry, Real, std::span<const char>);

}  // namespace brunt
