// Meshes and fillings of shapes: volumes, orientation, watertightness. A curved shape meshed with
// chords loses volume of second order in the cell: 2 (1 - sin(a)/a) with a the angle of a chord.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>
#include <set>

#include "core/geometry/curve.hpp"
#include "core/geometry/mesh.hpp"

namespace brunt {
namespace {

Sizing sized(Real h) { return {std::vector<Real>{h}, {}, {}}; }

/// Volume by the tetrahedra from the origin to the outer faces (divergence theorem); each quad is
/// split at its centre, which both neighbours share.
Real volume(const std::vector<Vec3>& nodes, const std::vector<std::array<int, 4>>& facets) {
  Real sum = 0;
  for (const auto& f : facets) {
    const int n = f[3] < 0 ? 3 : 4;
    Vec3 center = Vec3::Zero();
    for (int c = 0; c < n; ++c) center += nodes[static_cast<std::size_t>(f[c])] / n;
    for (int c = 0; c < n; ++c) {
      const Vec3& a = nodes[static_cast<std::size_t>(f[c])];
      const Vec3& b = nodes[static_cast<std::size_t>(f[(c + 1) % n])];
      sum += a.dot(b.cross(center)) / 6;
    }
  }
  return sum;
}

/// Each edge belongs to two facets that run along it in opposite directions.
void expect_watertight(const std::vector<std::array<int, 4>>& facets) {
  std::map<std::pair<int, int>, int> edges;
  for (const auto& f : facets) {
    const int n = f[3] < 0 ? 3 : 4;
    for (int c = 0; c < n; ++c) ++edges[{f[c], f[(c + 1) % n]}];
  }
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    EXPECT_EQ(edges.count({edge.second, edge.first}), 1u);
  }
}

/// Smallest scaled Jacobian of a mesh of hexes: det of unit edge vectors at each corner.
Real worst_jacobian(const Mesh<3>& mesh) {
  static constexpr int next[8][3] = {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7},
                                     {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}};
  Real worst = 1;
  for (const auto& e : mesh.elements) {
    const auto at = [&](int c) { return mesh.nodes[static_cast<std::size_t>(e[c])]; };
    for (int c = 0; c < 8; ++c) {
      const Vec3 a = (at(next[c][0]) - at(c)).normalized();
      const Vec3 b = (at(next[c][1]) - at(c)).normalized();
      const Vec3 d = (at(next[c][2]) - at(c)).normalized();
      worst = std::min(worst, a.cross(b).dot(d));
    }
  }
  return worst;
}

struct Solid3 {
  const char* name;
  BodyShape shape;
  Real h, volume, tolerance;
};

std::vector<Solid3> solids() {
  Box box{{0, -1, 2}, {1, 1, 2.5}};
  Cylinder cylinder;
  cylinder.radius = 0.5, cylinder.length = 2, cylinder.axis = {1, 1, 0}, cylinder.base = {1, 2, 3};
  Tube tube;
  tube.inner = 0.3, tube.outer = 0.5, tube.length = 1;
  Sphere sphere;
  sphere.radius = 0.7, sphere.center = {1, 0, 0};
  PolygonShape polygon;
  polygon.points = {{0, 0}, {2, 0}, {2, 1}, {1, 1.5}, {0, 1}};
  polygon.thickness = 0.5;
  polygon.corners = std::vector<int>{0, 1, 2, 4};
  BrickWall wall;
  wall.bricks = std::vector<int>{3, 1, 4}, wall.brick = {0.2, 0.1, 0.06};
  // chords of a quarter cell's angle: relative loss below (h/R)^2/2
  return {{"box", {box, {}, {}}, 0.25, 1.0, 1e-12},
          {"cylinder", {cylinder, {}, {}}, 0.05, kPi * 0.25 * 2, 0.01},
          {"tube", {tube, {}, {}}, 0.05, kPi * 0.16, 0.01},
          {"sphere", {sphere, {}, {}}, 0.07, 4.0 / 3 * kPi * 0.343, 0.02},
          {"polygon", {polygon, {}, {}}, 0.1, 1.25 * 2 * 0.5, 0.02},
          {"wall", {wall, {}, {}}, 0.05, 12 * 0.2 * 0.1 * 0.06, 1e-12}};
}

TEST(Shapes, HexMeshesAreRightInsideOut) {
  for (const auto& [name, shape, h, expected, tolerance] : solids()) {
    const auto mesh = mesh_shape<3>(shape, sized(h), Geometry::three_d);
    EXPECT_GT(worst_jacobian(mesh), 0.3) << name;
    const auto faces = outer_faces(mesh);
    EXPECT_NEAR(volume(mesh.nodes, faces), expected, tolerance * expected) << name;
    expect_watertight(faces);
    std::set<std::array<Real, 3>> places;
    for (const auto& x : mesh.nodes) places.insert({x[0], x[1], x[2]});
    // bricks have nodes of their own; all else has one node a place
    if (std::string(name) == "wall") continue;
    EXPECT_EQ(places.size(), mesh.nodes.size()) << name;
  }
}

TEST(Shapes, CylinderConvergesAtSecondOrder) {
  Cylinder c;
  c.radius = 1, c.length = 1;
  Real error[2];
  for (int k = 0; k < 2; ++k) {
    const auto mesh = mesh_shape<3>({c, {}, {}}, sized(k ? 0.125 : 0.25), Geometry::three_d);
    error[k] = kPi - volume(mesh.nodes, outer_faces(mesh));
  }
  EXPECT_NEAR(error[0] / error[1], 4, 0.2);
}

TEST(Shapes, RigidSurfacesAreClosedAndFaceOutward) {
  Ogive ogive;
  ogive.radius = 0.1, ogive.length = 0.6, ogive.nose = 0.3;
  PolygonShape wedge;  // not convex, clockwise
  wedge.points = {{0, 0}, {0, 1}, {0.4, 0.4}, {1, 0}};
  wedge.thickness = 0.3;
  for (const auto& [name, shape, h, expected, tolerance] : solids()) {
    const auto surface = surface_of_shape<3>(shape, sized(h), Geometry::three_d);
    if (std::string(name) == "wall") continue;
    expect_watertight(surface.facets);
    EXPECT_NEAR(volume(surface.nodes, surface.facets), expected, tolerance * expected) << name;
  }
  const auto tip = surface_of_shape<3>({ogive, {}, {}}, sized(0.01), Geometry::three_d);
  expect_watertight(tip.facets);
  const auto filled = fill_shape<3>({ogive, {}, {}}, {0.01}, LatticeKind::cubic);
  EXPECT_NEAR(volume(tip.nodes, tip.facets), filled.volume, 0.02 * filled.volume);
  const auto tool = surface_of_shape<3>({wedge, {}, {}}, {}, Geometry::three_d);
  expect_watertight(tool.facets);
  EXPECT_NEAR(volume(tool.nodes, tool.facets), 0.3 * 0.4, 1e-12);
}

TEST(Shapes, PlaneFacesItsNormal) {
  Plane plane{{1, 2, 3}, {0, 0, 1}, 2};
  const auto surface = surface_of_shape<3>({plane, {}, {}}, {}, Geometry::three_d);
  ASSERT_EQ(surface.facets.size(), 1u);
  const auto& f = surface.facets[0];
  const Vec3 a = surface.nodes[f[1]] - surface.nodes[f[0]],
             b = surface.nodes[f[3]] - surface.nodes[f[0]];
  EXPECT_EQ(a.cross(b)[2], 4);
  Plane line{{0, 0}, {0, 1}, 2};
  const auto flat = surface_of_shape<2>({line, {}, {}}, {}, Geometry::plane_strain);
  const Vec<2> d = flat.nodes[1] - flat.nodes[0];
  EXPECT_EQ(-d[0], 2);  // normal = (dy, -dx) = (0, 2)
}

TEST(Shapes, QuadMeshesAreCounterClockwise) {
  Cylinder c;
  c.radius = 1, c.length = 3, c.base = {0.5, 0.5};
  Sphere ball;
  ball.radius = 1, ball.center = {0, 0};
  struct Case {
    BodyShape shape;
    Geometry geometry;
    Real area;
  };
  const Case cases[] = {{{c, {}, {}}, Geometry::plane_strain, kPi},
                        {{c, {}, {}}, Geometry::axisymmetric, 3},
                        {{ball, {}, {}}, Geometry::axisymmetric, kPi / 2}};
  for (const auto& [shape, geometry, expected] : cases) {
    const auto mesh = mesh_shape<2>(shape, sized(0.1), geometry);
    Real sum = 0;
    for (const auto& e : mesh.elements) {
      Real area = 0;
      for (int k = 0; k < 4; ++k) {
        const auto& a = mesh.nodes[static_cast<std::size_t>(e[k])];
        const auto& b = mesh.nodes[static_cast<std::size_t>(e[(k + 1) % 4])];
        area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
      }
      EXPECT_GT(area, 0);
      sum += area;
    }
    EXPECT_NEAR(sum, expected, 0.01 * expected);
  }
}

TEST(Shapes, RunningBondClosesItsEnds) {
  BrickWall wall;
  wall.bricks = std::vector<int>{4, 3}, wall.brick = {2, 1};
  const auto mesh = mesh_shape<2>({wall, {}, {}}, sized(1), Geometry::plane_strain);
  EXPECT_EQ(mesh.piece_names.size(), 4u + 5u + 4u);
  Vec<2> low(kInfinity, kInfinity), high = -low;
  for (const auto& x : mesh.nodes) low = low.cwiseMin(x), high = high.cwiseMax(x);
  EXPECT_EQ(low, Vec<2>(0, 0));
  EXPECT_EQ(high, Vec<2>(8, 3));
}

// Courses along the last axis are stacked along the one before: the same wall, turned.
TEST(Shapes, CoursesMayStandUpright) {
  BrickWall flat, upright;
  flat.bricks = std::vector<int>{4, 3}, flat.brick = {2, 1};
  upright.bricks = std::vector<int>{3, 4}, upright.brick = {1, 2}, upright.course = {0, 1, 0};
  const auto lying = mesh_shape<2>({flat, {}, {}}, sized(0.5), Geometry::plane_strain);
  const auto standing = mesh_shape<2>({upright, {}, {}}, sized(0.5), Geometry::plane_strain);
  const auto places = [](const Mesh<2>& mesh, bool turned) {
    std::vector<std::pair<Real, Real>> all;
    for (const auto& x : mesh.nodes) all.emplace_back(x[turned ? 1 : 0], x[turned ? 0 : 1]);
    std::sort(all.begin(), all.end());
    return all;
  };
  EXPECT_EQ(places(standing, true), places(lying, false));
  upright.bricks = std::vector<int>{3, 2, 4}, upright.brick = {1, 5, 2}, upright.course = {0, 0, 1};
  const auto solid = mesh_shape<3>({upright, {}, {}}, sized(1), Geometry::three_d);
  EXPECT_EQ(solid.piece_names.size(), 3u * (4u + 5u));
  Vec3 high = Vec3::Zero();
  for (const auto& x : solid.nodes) high = high.cwiseMax(x);
  EXPECT_EQ(high, Vec3(3, 10, 8));
}

TEST(Shapes, FillingsAreCentredAndInside) {
  const auto box = fill_shape<3>({Box{{0, 0, 0}, {1, 2, 3}}, {}, {}}, {0.5}, LatticeKind::cubic);
  EXPECT_EQ(box.points.size(), 2u * 4u * 6u);
  EXPECT_EQ(box.volume, 6);
  Vec3 center = Vec3::Zero();
  for (const auto& x : box.points) center += x / static_cast<Real>(box.points.size());
  EXPECT_NEAR((center - Vec3(0.5, 1, 1.5)).norm(), 0, 1e-14);

  Cylinder c;
  c.radius = 0.0032, c.length = 0.0324, c.axis = {0, 0, 1};
  const auto bar = fill_shape<3>({c, {}, {}}, {0.00032}, LatticeKind::cubic);
  EXPECT_NEAR(bar.volume, kPi * c.radius * c.radius * c.length, 1e-9 * bar.volume);
  const Real count = bar.volume / std::pow(0.00032, 3);
  EXPECT_NEAR(static_cast<Real>(bar.points.size()), count, 0.03 * count);
  const auto dense = fill_shape<3>({c, {}, {}}, {0.00032}, LatticeKind::hexagonal);
  // 1/(sqrt(3)/2 sqrt(2/3)) = sqrt(2) points a cube of the spacing; rows are a whole number: 24
  // where 23.1 would fit, 4 %, and 2 % for the rim
  EXPECT_NEAR(static_cast<Real>(dense.points.size()) / (std::sqrt(2.0) * count), 1, 0.06);
}

TEST(Shapes, BadShapesSayWhatWouldDo) {
  PolygonShape bow;
  bow.points = {{0, 0}, {1, 1}, {1, 0}, {0, 1}};
  EXPECT_THROW(surface_of_shape<2>({bow, {}, {}}, {}, Geometry::plane_strain),
               std::invalid_argument);
  EXPECT_THROW(mesh_shape<2>({bow, {}, {}}, sized(0.1), Geometry::plane_strain),
               std::invalid_argument);  // no corners
  EXPECT_THROW(mesh_shape<3>({Ogive{}, {}, {}}, sized(0.1), Geometry::three_d),
               std::invalid_argument);
  EXPECT_THROW(mesh_shape<3>({Box{{0, 0, 0}, {1, 1, 1}}, {}, {}}, {}, Geometry::three_d),
               std::invalid_argument);  // neither size nor cells
}

TEST(Curve, NeighboursOnTheCurveAreNeighboursInSpace) {
  std::vector<Vec<2>> x;
  for (int i = 0; i < 64; ++i) x.emplace_back(i % 8, i / 8);
  const auto keys = curve_keys<2>(x);
  EXPECT_EQ(std::set<std::uint64_t>(keys.begin(), keys.end()).size(), 64u);
  auto moved = x;
  for (auto& p : moved) p = 4.0 * p + Vec<2>(16, 32);  // exact in binary: the same keys
  EXPECT_EQ(curve_keys<2>(moved), keys);
}

/// Bit b of coordinate c is bit Dim b + c of the key, of 31 in the plane and 20 in space. Of points
/// as far apart as there are cells, but for a part of 1e-9, each is in the cell of its whole part.
template <int Dim>
void expect_interleaved(int bits) {
  const Real extent = std::exp2(bits) * (1 - 1e-9);
  std::mt19937 random(7);
  std::uniform_int_distribution<std::uint64_t> cell(0, (std::uint64_t{1} << bits) - 4);
  std::vector<Vec<Dim>> x{Vec<Dim>::Zero(), Vec<Dim>::Constant(extent)};
  for (int i = 0; i < 200; ++i) {
    auto& at = x.emplace_back();
    for (int c = 0; c < Dim; ++c) at[c] = static_cast<Real>(cell(random)) + 0.5;  // its middle
  }
  std::vector<std::uint64_t> expected;
  for (const auto& at : x) {
    std::uint64_t key = 0;
    for (int c = 0; c < Dim; ++c) {
      const auto n = static_cast<std::uint64_t>(at[c]);
      for (int b = 0; b < bits; ++b) key |= (n >> b & 1) << (Dim * b + c);
    }
    expected.push_back(key);
  }
  EXPECT_EQ(curve_keys<Dim>(x), expected);
}

TEST(Curve, KeysHaveTheBitsOfCoordinatesInTurn) {
  expect_interleaved<2>(31);
  expect_interleaved<3>(20);
}

TEST(Curve, OrderIsThatOfAStableSort) {
  std::mt19937_64 random(11);
  for (const int shift : {0, 30, 52, 63, 64}) {  // few different keys, or none
    for (const std::size_t n : {0, 1, 2, 1000}) {
      std::vector<std::uint64_t> keys(n);
      for (auto& key : keys) key = shift == 64 ? 5 : random() >> shift;
      std::vector<std::uint32_t> expected(n);
      std::iota(expected.begin(), expected.end(), 0U);
      std::stable_sort(expected.begin(), expected.end(),
                       [&](std::uint32_t a, std::uint32_t b) { return keys[a] < keys[b]; });
      EXPECT_EQ(order_of(keys), expected);
    }
  }
}

}  // namespace
}  // namespace brunt
