#include "core/geometry/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "core/geometry/brick_wall.hpp"
#include "core/geometry/grid.hpp"
#include "core/geometry/placement.hpp"
#include "core/geometry/wedge.hpp"

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
/// The one grading of a disc or ball; null where there is none.
const Grading* round_grading(const Sizing& sizing) {
  if (sizing.gradings.empty()) return nullptr;
  if (sizing.gradings.size() > 1 || sizing.gradings.front().symmetric()) {
    throw GradingError(
        "a round shape is finer towards one point of its rim: keep one axis, toward min or max");
  }
  return &sizing.gradings.front();
}

/// Cells from the centre of a disc or ball to its rim: its map makes the largest sqrt(ratio)
/// larger.
int round_count(const Sizing& sizing, Real radius, const Grading* grading) {
  return sizing.count(0, grading ? std::sqrt(grading->ratio) * radius : radius);
}

/// direction  unit vector of the grading's axis, in the mesh's own frame
template <int Dim>
void grade_round(const Grading* grading, const Vec<Dim>& direction, Real radius, Mesh<Dim>& mesh) {
  if (!grading) return;
  const Real sign = grading->toward == Toward::max ? 1 : -1;
  grade_ball<Dim>(sign * direction, grading->ratio, radius, mesh.nodes);
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

/// Bricks are many, and each would be finer at its own ends.
template <int Dim>
Mesh<Dim> even_wall(const BrickWall& wall, const Sizing& sizing) {
  if (!sizing.gradings.empty()) throw GradingError("the bricks of a wall are meshed evenly");
  return wall_mesh<Dim>(wall, sizing);
}

struct Mesher3 {
  const Sizing& sizing;

  /// The grading along the axis of a shape, as it is seen from the base, and those across it.
  std::pair<std::optional<Grading>, Sizing> split(const Frame3& frame) const {
    std::optional<Grading> along;
    Sizing across;
    for (const Grading& grading : sizing.gradings) {
      const Real cosine = frame.columns(grading.axis, 2);
      constexpr Real kRounding = 1e-12;
      if (std::fabs(cosine) > 1 - kRounding) {
        along = turned(&grading, cosine < 0);
      } else if (std::fabs(cosine) < kRounding) {
        across.gradings.push_back(grading);
      } else {
        throw GradingError(std::string("the shape's own axis runs neither along ") +
                           "xyz"[grading.axis] +
                           " nor across it: stand it along an axis, and turn it by `rotate`");
      }
    }
    return {along, across};
  }

  Mesh<3> operator()(const Box& box) const {
    const Vec3 low = to_vector<3>(box.min), high = to_vector<3>(box.max);
    std::array<Layers, 3> layers;
    for (int c = 0; c < 3; ++c) {
      layers[c] = layers_along(sizing, c, high[c] - low[c]);
    }
    return box_grid<3>(low, high, layers);
  }
  Mesh<3> operator()(const Cylinder& c) const {
    const Frame3 frame = frame_along(c.base, c.axis);
    const auto [along, across] = split(frame);
    const Grading* round = round_grading(across);
    Mesh<2> disc = disc_grid(c.radius, round_count(sizing, c.radius, round));
    if (round) {
      const Vec3 direction = frame.columns.row(round->axis);
      grade_round<2>(round, direction.head<2>(), c.radius, disc);
    }
    return along_axis(extrude(disc, c.length, layers_along(sizing, 2, c.length, along)), frame);
  }
  Mesh<3> operator()(const Tube& t) const {
    const Frame3 frame = frame_along(t.base, t.axis);
    const auto [along, across] = split(frame);
    if (!across.gradings.empty()) {
      throw GradingError("a tube is graded along its own axis alone");
    }
    const int n = sizing.count(0, t.outer - t.inner);
    const Real middle = 0.5 * (t.inner + t.outer);
    const auto ring =
        ring_grid(t.inner, t.outer, n, count_around(sizing, middle, n, t.outer - t.inner));
    return along_axis(extrude(ring, t.length, layers_along(sizing, 2, t.length, along)), frame);
  }
  Mesh<3> operator()(const Sphere& s) const {
    const Grading* grading = round_grading(sizing);
    Mesh<3> mesh = ball_grid(s.radius, round_count(sizing, s.radius, grading));
    if (grading) grade_round<3>(grading, Vec3::Unit(grading->axis), s.radius, mesh);
    for (auto& x : mesh.nodes) x += to_vector<3>(s.center);
    return mesh;
  }
  Mesh<3> operator()(const PolygonShape& p) const {
    if (!(p.thickness > 0)) throw std::invalid_argument("a polygon needs `thickness` in 3D");
    Mesh<3> mesh =
        extrude(polygon_grid(p, sizing), p.thickness, layers_along(sizing, 2, p.thickness));
    if (p.base != 0) {
      for (auto& x : mesh.nodes) x[2] += p.base;
    }
    return mesh;
  }
  Mesh<3> operator()(const Wedge& w) const { return (*this)(polygon_of(w)); }
  Mesh<3> operator()(const BrickWall& wall) const { return even_wall<3>(wall, sizing); }
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
    return box_grid<2>(
        low, high,
        {layers_along(sizing, 0, high[0] - low[0]), layers_along(sizing, 1, high[1] - low[1])});
  }
  Mesh<2> graded_disc(Real radius) const {
    const Grading* grading = round_grading(sizing);
    Mesh<2> disc = disc_grid(radius, round_count(sizing, radius, grading));
    if (grading) grade_round<2>(grading, Vec<2>::Unit(grading->axis), radius, disc);
    return disc;
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
    return shifted(graded_disc(c.radius), c.base);
  }
  Mesh<2> operator()(const Tube& t) const {
    const Vec<2> base = to_vector<2>(t.base);
    if (geometry == Geometry::axisymmetric) {
      return rectangle(Vec<2>(t.inner, base[1]), Vec<2>(t.outer, base[1] + t.length));
    }
    if (!sizing.gradings.empty()) {
      throw GradingError("a ring in plane strain is meshed evenly about its centre");
    }
    const int n = sizing.count(0, t.outer - t.inner);
    const Real middle = 0.5 * (t.inner + t.outer);
    return shifted(
        ring_grid(t.inner, t.outer, n, count_around(sizing, middle, n, t.outer - t.inner)), t.base);
  }
  Mesh<2> operator()(const Sphere& s) const {
    Mesh<2> disc = graded_disc(s.radius);
    if (geometry == Geometry::axisymmetric) {
      if (sizing.along(0)) {
        throw GradingError("a ball about the axis of symmetry is graded along it: axis: y");
      }
      // The half x >= 0 of a disc whose core has an even number of cells: no element is cut.
      Mesh<2> half;
      std::map<int, int> kept;
      for (const auto& quad : disc.elements) {
        Real center = 0;
        for (const int c : quad) center += disc.nodes[c][0];
        if (center < 0) continue;
        std::array<int, 4> corners;
        for (std::size_t c = 0; c < 4; ++c) {
          const auto [found, fresh] = kept.emplace(quad[c], static_cast<int>(half.nodes.size()));
          if (fresh) {
            Vec<2> x = disc.nodes[quad[c]];
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
  Mesh<2> operator()(const Wedge& w) const { return polygon_grid(polygon_of(w), sizing); }
  Mesh<2> operator()(const BrickWall& wall) const { return even_wall<2>(wall, sizing); }
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
      for (const auto& local : Shape<Dim>::kFace) {
        Face face;
        for (std::size_t c = 0; c < face.size(); ++c) {
          face[c] = element[local[c]];
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
// Tested by tests/unit/core/shapes_test.cpp.
