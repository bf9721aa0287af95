#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/geometry/grid.hpp"
#include "core/geometry/placement.hpp"
#include "core/geometry/profile.hpp"
#include "core/geometry/wedge.hpp"

namespace brunt {

namespace {
constexpr int kAround = 32;  // facets about an axis where no size is given

/// Keeps the nodes that facets use.
template <int Dim>
FacetMesh<Dim> outside(const Mesh<Dim>& mesh) {
  FacetMesh<Dim> surface;
  std::vector<int> kept(mesh.nodes.size(), -1);
  std::vector<Label> piece(mesh.nodes.size(), 0);  // pieces share no nodes
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    for (const int node : mesh.elements[e]) piece[node] = mesh.piece[e];
  }
  surface.piece_names = mesh.piece_names;
  for (auto face : outer_faces(mesh)) {
    surface.piece.push_back(piece[face[0]]);
    for (auto& node : face) {
      int& place = kept[node];
      if (place < 0) {
        place = static_cast<int>(surface.nodes.size());
        surface.nodes.push_back(mesh.nodes[node]);
      }
      node = place;
    }
    surface.facets.push_back(face);
  }
  return surface;
}

/// A segment in 2D, a square in 3D, of edge length `extent`, seen by its normal from outside.
template <int Dim>
FacetMesh<Dim> flat(const Plane& plane, const Sizing& sizing) {
  FacetMesh<Dim> surface;
  const Real half = 0.5 * plane.extent;
  const int n = sizing.size || sizing.cells ? sizing.count(0, plane.extent) : 1;
  const auto at = [&](int i) { return i == n ? half : -half + plane.extent * i / n; };
  if constexpr (Dim == 2) {
    const Vec<2> normal = to_vector<2>(plane.normal).normalized();
    const Vec<2> along(-normal[1], normal[0]), origin = to_vector<2>(plane.origin);
    for (int i = 0; i <= n; ++i) surface.nodes.push_back(origin + at(i) * along);
    for (int i = 0; i < n; ++i) surface.facets.push_back({i, i + 1});
  } else {
    const Frame3 frame = frame_along(plane.origin, plane.normal);
    for (int j = 0; j <= n; ++j) {
      for (int i = 0; i <= n; ++i) surface.nodes.push_back(frame.place(Vec3(at(i), at(j), 0)));
    }
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        const int first = j * (n + 1) + i;
        surface.facets.push_back({first, first + 1, first + n + 2, first + n + 1});
      }
    }
  }
  return surface;
}

std::vector<Vec<2>> counter_clockwise(const PolygonShape& polygon) {
  std::vector<Vec<2>> points;
  Real area = 0;
  for (const auto& point : polygon.points) points.push_back(to_vector<2>(point));
  require_simple(points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& a = points[i];
    const auto& b = points[(i + 1) % points.size()];
    area += a[0] * b[1] - a[1] * b[0];
  }
  if (area < 0) std::reverse(points.begin(), points.end());
  return points;
}

Real turn(const Vec<2>& a, const Vec<2>& b, const Vec<2>& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// Triangles of a simple polygon by cutting ears (Meisters 1975).
std::vector<std::array<int, 3>> triangulate(const std::vector<Vec<2>>& points) {
  std::vector<int> left(points.size());
  for (std::size_t i = 0; i < left.size(); ++i) left[i] = static_cast<int>(i);
  const auto at = [&](int i) -> const Vec<2>& { return points[i]; };
  std::vector<std::array<int, 3>> triangles;
  while (left.size() > 3) {
    bool cut = false;
    for (std::size_t i = 0; i < left.size() && !cut; ++i) {
      const int a = left[(i + left.size() - 1) % left.size()], b = left[i];
      const int c = left[(i + 1) % left.size()];
      if (turn(at(a), at(b), at(c)) <= 0) continue;
      const bool clear = std::none_of(left.begin(), left.end(), [&](int p) {
        return p != a && p != b && p != c && turn(at(a), at(b), at(p)) >= 0 &&
               turn(at(b), at(c), at(p)) >= 0 && turn(at(c), at(a), at(p)) >= 0;
      });
      if (!clear) continue;
      triangles.push_back({a, b, c});
      left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
      cut = true;
    }
    if (!cut) throw std::invalid_argument("the polygon crosses itself");
  }
  triangles.push_back({left[0], left[1], left[2]});
  return triangles;
}

FacetMesh<2> polygon_surface2(const PolygonShape& polygon) {
  FacetMesh<2> surface;
  surface.nodes = counter_clockwise(polygon);
  const int n = static_cast<int>(surface.nodes.size());
  for (int i = 0; i < n; ++i) surface.facets.push_back({i, (i + 1) % n});
  return surface;
}

FacetMesh<3> polygon_surface3(const PolygonShape& polygon) {
  if (!(polygon.thickness > 0)) throw std::invalid_argument("a polygon needs `thickness` in 3D");
  const auto flat = counter_clockwise(polygon);
  const int n = static_cast<int>(flat.size());
  FacetMesh<3> surface;
  for (const Real z : {polygon.base, polygon.base + polygon.thickness}) {
    for (const auto& x : flat) surface.nodes.emplace_back(x[0], x[1], z);
  }
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    surface.facets.push_back({i, j, j + n, i + n});
  }
  for (const auto& [a, b, c] : triangulate(flat)) {
    surface.facets.push_back({a, c, b, -1});
    surface.facets.push_back({a + n, b + n, c + n, -1});
  }
  return surface;
}

/// The surface of a profile about its axis, closed by triangles at its ends.
FacetMesh<3> revolved_surface(const Ogive& ogive, const Sizing& sizing) {
  const Profile profile = ogive_profile(ogive);
  const Frame3 frame = frame_along(ogive.base, ogive.axis);
  const int around =
      sizing.size ? 4 * std::max(3, sizing.count(0, kPi / 2 * ogive.radius)) : kAround;
  const Real step = 2 * kPi * ogive.radius / around;
  std::vector<Real> stations{0};
  for (std::size_t part = 0; part + 1 < profile.breaks.size(); ++part) {
    const Real from = profile.breaks[part], to = profile.breaks[part + 1];
    const int n = std::max(1, static_cast<int>(std::ceil((to - from) / step)));
    for (int i = 1; i <= n && to > from; ++i) stations.push_back(from + (to - from) * i / n);
  }
  FacetMesh<3> surface;
  surface.nodes.push_back(frame.place(Vec3::Zero()));
  const int rings = static_cast<int>(stations.size()) - 1;  // the last station is the tip
  const auto node = [&](int ring, int k) { return 1 + ring * around + k % around; };
  for (int ring = 0; ring < rings; ++ring) {
    const Real r = profile.radius(stations[ring]);
    for (int k = 0; k < around; ++k) {
      const Real angle = 2 * kPi * k / around;
      surface.nodes.push_back(
          frame.place(Vec3(r * std::cos(angle), r * std::sin(angle), stations[ring])));
    }
  }
  surface.nodes.push_back(frame.place(Vec3(0, 0, ogive.length)));
  const int tip = static_cast<int>(surface.nodes.size()) - 1;
  for (int k = 0; k < around; ++k) {
    surface.facets.push_back({0, node(0, k + 1), node(0, k), -1});
    for (int ring = 0; ring + 1 < rings; ++ring) {
      surface.facets.push_back(
          {node(ring, k), node(ring, k + 1), node(ring + 1, k + 1), node(ring + 1, k)});
    }
    surface.facets.push_back({node(rings - 1, k), node(rings - 1, k + 1), tip, -1});
  }
  return surface;
}

FacetMesh<2> ogive_surface2(const Ogive& ogive) {
  const Profile profile = ogive_profile(ogive);
  const Vec<2> along = to_vector<2>(ogive.axis).normalized(), base = to_vector<2>(ogive.base);
  const Vec<2> across(-along[1], along[0]);
  constexpr int n = 16;  // edges of each side of the nose
  FacetMesh<2> surface;
  const Real shank = ogive.length - ogive.nose;
  surface.nodes.push_back(base - ogive.radius * across);
  for (int i = 0; i < n; ++i) {
    const Real s = shank + ogive.nose * i / n;
    surface.nodes.push_back(base + s * along - profile.radius(s) * across);
  }
  surface.nodes.push_back(base + ogive.length * along);
  for (int i = n - 1; i >= 0; --i) {
    const Real s = shank + ogive.nose * i / n;
    surface.nodes.push_back(base + s * along + profile.radius(s) * across);
  }
  surface.nodes.push_back(base + ogive.radius * across);
  const int count = static_cast<int>(surface.nodes.size());
  for (int i = 0; i < count; ++i) surface.facets.push_back({i, (i + 1) % count});
  return surface;
}

/// Sizing of a rigid body that names none: one cell along straight sides, kAround about an axis.
Sizing or_coarse(const Sizing& sizing, const BodyShape& shape) {
  if (sizing.size || sizing.cells) return sizing;
  Sizing coarse;
  const bool round = std::holds_alternative<Cylinder>(shape.kind) ||
                     std::holds_alternative<Sphere>(shape.kind) ||
                     std::holds_alternative<Tube>(shape.kind);
  coarse.cells = round ? std::vector<int>{kAround / 4, kAround / 4, 1} : std::vector<int>{1, 1, 1};
  return coarse;
}
}  // namespace

template <int Dim>
FacetMesh<Dim> surface_of_shape(const BodyShape& shape, const Sizing& sizing, Geometry geometry) {
  if (const auto* wedge = std::get_if<Wedge>(&shape.kind)) {
    BodyShape outline = shape;
    outline.kind = polygon_of(*wedge);
    return surface_of_shape<Dim>(outline, sizing, geometry);
  }
  FacetMesh<Dim> surface;
  const bool meshed = !std::holds_alternative<Plane>(shape.kind) &&
                      !std::holds_alternative<PolygonShape>(shape.kind) &&
                      !std::holds_alternative<Ogive>(shape.kind);
  if (!meshed && !sizing.gradings.empty()) {
    throw GradingError("the surface of this rigid shape has no sizes along an axis");
  }
  if (const auto* plane = std::get_if<Plane>(&shape.kind)) {
    surface = flat<Dim>(*plane, sizing);
  } else if (const auto* polygon = std::get_if<PolygonShape>(&shape.kind)) {
    if constexpr (Dim == 2) surface = polygon_surface2(*polygon);
    if constexpr (Dim == 3) surface = polygon_surface3(*polygon);
  } else if (const auto* ogive = std::get_if<Ogive>(&shape.kind)) {
    if constexpr (Dim == 2) surface = ogive_surface2(*ogive);
    if constexpr (Dim == 3) surface = revolved_surface(*ogive, sizing);
  } else {
    // mesh_shape places the nodes itself
    return outside(mesh_shape<Dim>(shape, or_coarse(sizing, shape), geometry));
  }
  place_all<Dim>(shape, surface.nodes);
  surface.piece.assign(surface.facets.size(), 0);
  surface.piece_names = {""};
  return surface;
}

template FacetMesh<2> surface_of_shape<2>(const BodyShape&, const Sizing&, Geometry);
template FacetMesh<3> surface_of_shape<3>(const BodyShape&, const Sizing&, Geometry);

}  // namespace brunt
// Tested by tests/unit/core/shapes_test.cpp.
