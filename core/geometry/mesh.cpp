#include "core/geometry/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "core/geometry/brick_wall.hpp"
#include "core/geometry/grid.hpp"
#include "core/geometry/placement.hpp"
#include "core/geometry/profile.hpp"

namespace brunt {

int Sizing::count(std::size_t c, Real length) const {
  if (cells) {
    const auto& n = *cells;
    return std::max(1, n[std::min(c, n.size() - 1)]);
  }
  if (!size) throw std::invalid_argument("the body needs `size`, its element size, or `cells`");
  const Real h = (*size)[std::min(c, size->size() - 1)];
  // 3.81/0.381 is 10 cells, whatever rounding says.
  return std::max(1, static_cast<int>(std::ceil(length / h * (1 - 1e-9))));
}

namespace {
/// Corners of each face of an element, seen from outside counter-clockwise; in 2D the body lies to
/// the left of an edge.
template <int Dim>
constexpr auto faces() {
  if constexpr (Dim == 2) {
    return std::array<std::array<int, 2>, 4>{{{0, 1}, {1, 2}, {2, 3}, {3, 0}}};
  } else {
    return std::array<std::array<int, 4>, 6>{
        {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
  }
}

/// Four sides of a polygon between its corners, each a polyline.
std::array<std::vector<Vec<2>>, 4> sides_of(const PolygonShape& polygon) {
  if (!polygon.corners) {
    throw std::invalid_argument(
        "a polygon of a deforming FE body needs `corners: [i, j, k, l]`, four of its points; fill "
        "other polygons with particles (method: sph)");
  }
  const int n = static_cast<int>(polygon.points.size());
  std::vector<Vec<2>> outline;
  for (const auto& point : polygon.points) outline.push_back(to_vector<2>(point));
  require_simple(outline);
  std::array<std::vector<Vec<2>>, 4> sides;
  Real area = 0;
  for (int i = 0; i < n; ++i) {
    const auto a = to_vector<2>(polygon.points[static_cast<std::size_t>(i)]);
    const auto b = to_vector<2>(polygon.points[static_cast<std::size_t>((i + 1) % n)]);
    area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
  }
  const int step = area > 0 ? 1 : -1;  // corners and points may run clockwise
  std::vector<int> corners = *polygon.corners;
  for (const int c : corners) {
    if (c < 0 || c >= n) throw std::invalid_argument("a corner is not one of the polygon's points");
  }
  std::sort(corners.begin(), corners.end());
  if (std::adjacent_find(corners.begin(), corners.end()) != corners.end()) {
    throw std::invalid_argument("the four corners must be different points");
  }
  if (step < 0) std::reverse(corners.begin(), corners.end());
  for (std::size_t s = 0; s < 4; ++s) {
    int i = corners[s];
    const int last = corners[(s + 1) % 4];
    sides[s].push_back(to_vector<2>(polygon.points[static_cast<std::size_t>(i)]));
    while (i != last) {
      i = (i + step + n) % n;
      sides[s].push_back(to_vector<2>(polygon.points[static_cast<std::size_t>(i)]));
    }
  }
  return sides;
}

Real length_of(const std::vector<Vec<2>>& line) {
  Real sum = 0;
  for (std::size_t i = 1; i < line.size(); ++i) sum += (line[i] - line[i - 1]).norm();
  return sum;
}

/// Plane meshes and meshes of revolution in local coordinates.
Mesh<2> polygon_grid(const PolygonShape& polygon, const Sizing& sizing) {
  const auto sides = sides_of(polygon);
  const Real along = std::max(length_of(sides[0]), length_of(sides[2]));
  const Real across = std::max(length_of(sides[1]), length_of(sides[3]));
  return transfinite_grid(sides, {sizing.count(0, along), sizing.count(1, across)});
}

int count_around(const Sizing& sizing, Real radius, int n_radius, Real thickness) {
  if (sizing.cells) {
    return std::max(12, 4 * static_cast<int>(std::lround(kPi / 2 * radius / thickness * n_radius)));
  }
  return 4 * std::max(3, sizing.count(0, kPi / 2 * radius));
}

Mesh<3> along_axis(Mesh<3> mesh, const Frame3& frame) {
  for (auto& x : mesh.nodes) x = frame.place(x);
  return mesh;
}

struct Mesher3 {
  const Sizing& sizing;

  Mesh<3> operator()(const Box& box) const {
    const Vec3 low = to_vector<3>(box.min), high = to_vector<3>(box.max);
    std::array<int, 3> n;
    for (std::size_t c = 0; c < 3; ++c) {
      n[c] = sizing.count(c, high[static_cast<int>(c)] - low[static_cast<int>(c)]);
    }
    return box_grid<3>(low, high, n);
  }
  Mesh<3> operator()(const Cylinder& c) const {
    const auto disc = disc_grid(c.radius, sizing.count(0, c.radius));
    return along_axis(extrude(disc, c.length, sizing.count(2, c.length)),
                      frame_along(c.base, c.axis));
  }
  Mesh<3> operator()(const Tube& t) const {
    const int n = sizing.count(0, t.outer - t.inner);
    const Real middle = 0.5 * (t.inner + t.outer);
    const auto ring =
        ring_grid(t.inner, t.outer, n, count_around(sizing, middle, n, t.outer - t.inner));
    return along_axis(extrude(ring, t.length, sizing.count(2, t.length)),
                      frame_along(t.base, t.axis));
  }
  Mesh<3> operator()(const Sphere& s) const {
    Mesh<3> mesh = ball_grid(s.radius, sizing.count(0, s.radius));
    for (auto& x : mesh.nodes) x += to_vector<3>(s.center);
    return mesh;
  }
  Mesh<3> operator()(const PolygonShape& p) const {
    if (!(p.thickness > 0)) throw std::invalid_argument("a polygon needs `thickness` in 3D");
    return extrude(polygon_grid(p, sizing), p.thickness, sizing.count(2, p.thickness));
  }
  Mesh<3> operator()(const BrickWall& wall) const { return wall_mesh<3>(wall, sizing); }
  Mesh<3> operator()(const Plane&) const {
    throw std::invalid_argument("a plane has no volume: it needs `rigid: true`");
  }
  Mesh<3> operator()(const Ogive&) const {
    throw std::invalid_argument(
        "the point of an ogive has no hexes: fill it with particles (method: sph) or make it "
        "rigid");
  }
};

struct Mesher2 {
  const Sizing& sizing;
  Geometry geometry;

  Mesh<2> rectangle(const Vec<2>& low, const Vec<2>& high) const {
    return box_grid<2>(low, high,
                       {sizing.count(0, high[0] - low[0]), sizing.count(1, high[1] - low[1])});
  }
  Mesh<2> shifted(Mesh<2> mesh, const std::vector<Real>& by) const {
    for (auto& x : mesh.nodes) x += to_vector<2>(by);
    return mesh;
  }
  Mesh<2> operator()(const Box& box) const {
    return rectangle(to_vector<2>(box.min), to_vector<2>(box.max));
  }
  Mesh<2> operator()(const Cylinder& c) const {
    const Vec<2> base = to_vector<2>(c.base);
    if (geometry == Geometry::axisymmetric) {
      return rectangle(Vec<2>(0, base[1]), Vec<2>(c.radius, base[1] + c.length));
    }
    return shifted(disc_grid(c.radius, sizing.count(0, c.radius)), c.base);
  }
  Mesh<2> operator()(const Tube& t) const {
    const Vec<2> base = to_vector<2>(t.base);
    if (geometry == Geometry::axisymmetric) {
      return rectangle(Vec<2>(t.inner, base[1]), Vec<2>(t.outer, base[1] + t.length));
    }
    const int n = sizing.count(0, t.outer - t.inner);
    const Real middle = 0.5 * (t.inner + t.outer);
    return shifted(
        ring_grid(t.inner, t.outer, n, count_around(sizing, middle, n, t.outer - t.inner)), t.base);
  }
  Mesh<2> operator()(const Sphere& s) const {
    Mesh<2> disc = disc_grid(s.radius, sizing.count(0, s.radius));
    if (geometry == Geometry::axisymmetric) {
      // The half x >= 0 of a disc whose core has an even number of cells: no element is cut.
      Mesh<2> half;
      std::map<int, int> kept;
      for (const auto& quad : disc.elements) {
        Real center = 0;
        for (const int c : quad) center += disc.nodes[static_cast<std::size_t>(c)][0];
        if (center < 0) continue;
        std::array<int, 4> corners;
        for (std::size_t c = 0; c < 4; ++c) {
          const auto [found, fresh] = kept.emplace(quad[c], static_cast<int>(half.nodes.size()));
          if (fresh) {
            Vec<2> x = disc.nodes[static_cast<std::size_t>(quad[c])];
            if (std::fabs(x[0]) < 1e-9 * s.radius) x[0] = 0;
            half.nodes.push_back(x);
          }
          corners[c] = found->second;
        }
        half.elements.push_back(corners);
      }
      half.piece.assign(half.elements.size(), 0);
      disc = half;
    }
    return shifted(disc, s.center);
  }
  Mesh<2> operator()(const PolygonShape& p) const { return polygon_grid(p, sizing); }
  Mesh<2> operator()(const BrickWall& wall) const { return wall_mesh<2>(wall, sizing); }
  Mesh<2> operator()(const Plane&) const {
    throw std::invalid_argument("a plane has no volume: it needs `rigid: true`");
  }
  Mesh<2> operator()(const Ogive&) const {
    throw std::invalid_argument(
        "the point of an ogive has no quads: fill it with particles (method: sph) or make it "
        "rigid");
  }
};
}  // namespace

template <int Dim>
Mesh<Dim> mesh_shape(const BodyShape& shape, const Sizing& sizing, Geometry geometry) {
  Mesh<Dim> mesh;
  if constexpr (Dim == 3) {
    (void)geometry;
    mesh = std::visit(Mesher3{sizing}, shape.kind);
  } else {
    mesh = std::visit(Mesher2{sizing, geometry}, shape.kind);
  }
  if (mesh.piece_names.empty()) mesh.piece_names = {""};
  place_all<Dim>(shape, mesh.nodes);
  return mesh;
}

template <int Dim>
std::vector<std::array<int, Facet<Dim>::kNodes>> outer_faces(const Mesh<Dim>& mesh) {
  using Face = std::array<int, Facet<Dim>::kNodes>;
  std::map<Face, int> count;
  const auto sorted = [](Face face) {
    std::sort(face.begin(), face.end());
    return face;
  };
  const auto each = [&](const auto& use) {
    for (const auto& element : mesh.elements) {
      for (const auto& local : faces<Dim>()) {
        Face face;
        for (std::size_t c = 0; c < face.size(); ++c) {
          face[c] = element[static_cast<std::size_t>(local[c])];
        }
        use(face);
      }
    }
  };
  each([&](const Face& face) { ++count[sorted(face)]; });
  std::vector<Face> outer;
  each([&](const Face& face) {
    if (count[sorted(face)] == 1) outer.push_back(face);
  });
  return outer;
}

template Mesh<2> mesh_shape<2>(const BodyShape&, const Sizing&, Geometry);
template Mesh<3> mesh_shape<3>(const BodyShape&, const Sizing&, Geometry);
template std::vector<std::array<int, 2>> outer_faces<2>(const Mesh<2>&);
template std::vector<std::array<int, 4>> outer_faces<3>(const Mesh<3>&);

}  // namespace brunt
