// Graded meshes. n sizes in geometric progression from h to r h: h_i = h r^(i/(n-1)), the sum is
// the length, so that h = L (q - 1)/(q^n - 1) with q = r^(1/(n-1)). Where `size` is given, n is the
// smallest with r h <= size. A disc or ball is mapped onto itself conformally: its scale at the two
// ends of the axis is (1 - a)/(1 + a) and (1 + a)/(1 - a) with a = (sqrt(r) - 1)/(sqrt(r) + 1),
// that is 1/sqrt(r) and sqrt(r).
#include "core/geometry/grading.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "core/geometry/mesh.hpp"

namespace brunt {
namespace {

Real progression(Real length, Real ratio, int n) {
  const Real q = std::pow(ratio, 1.0 / (n - 1));
  return length * (q - 1) / (std::pow(q, n) - 1);
}

/// Places of the layers of a mesh along an axis, without rounding's doubles.
template <int Dim>
std::vector<Real> layers_of(const Mesh<Dim>& mesh, int axis) {
  std::set<Real> places;
  for (const auto& x : mesh.nodes) places.insert(x[axis]);
  std::vector<Real> layers;
  for (const Real x : places) {
    if (layers.empty() || x - layers.back() > 1e-12) layers.push_back(x);
  }
  return layers;
}

/// Area of a mesh of quads, or volume of one of boxes along the axes.
Real area(const Mesh<2>& mesh) {
  Real sum = 0;
  for (const auto& e : mesh.elements) {
    const auto at = [&](int c) { return mesh.nodes[static_cast<std::size_t>(e[c])]; };
    const Vec<2> a = at(2) - at(0), b = at(3) - at(1);
    sum += 0.5 * (a[0] * b[1] - a[1] * b[0]);
  }
  return sum;
}
Real volume(const Mesh<3>& mesh) {
  Real sum = 0;
  for (const auto& e : mesh.elements) {
    sum += (mesh.nodes[static_cast<std::size_t>(e[6])] - mesh.nodes[static_cast<std::size_t>(e[0])])
               .prod();
  }
  return sum;
}

TEST(Grading, SizesOfABoxAreAProgression) {
  const Box box{{0, 0, 1}, {2, 1, 4}};
  for (const Toward toward : {Toward::min, Toward::max}) {
    const Sizing sizing{{}, std::vector<int>{4, 2, 7}, {{2, 5, toward}}};
    const auto mesh = mesh_shape<3>({box, {}, {}}, sizing, Geometry::three_d);
    const auto z = layers_of(mesh, 2);
    ASSERT_EQ(z.size(), 8u);
    EXPECT_EQ(z.front(), 1);  // the ends are met exactly
    EXPECT_EQ(z.back(), 4);
    const Real h = progression(3, 5, 7);
    for (int i = 0; i < 7; ++i) {
      const auto layer = static_cast<std::size_t>(toward == Toward::min ? i : 6 - i);
      EXPECT_NEAR(z[layer + 1] - z[layer], h * std::pow(5, i / 6.0), 1e-14);
    }
    const auto x = layers_of(mesh, 0);  // the other axes are even
    EXPECT_EQ(x[1], 0.5);
    EXPECT_NEAR(volume(mesh), 6, 1e-14);
  }
}

TEST(Grading, TowardBothEndsSizesRiseToTheMiddle) {
  // 7 layers: 1, q, q^2, q^3, q^2, q, 1 with q^3 = 8; their sum is 1 + 2 + 4 + 8 + 4 + 2 + 1 = 22.
  const auto odd = graded_layers({0, 8, Toward::both}, 7);
  const Real sums[] = {0, 1, 3, 7, 15, 19, 21, 22};
  for (std::size_t i = 0; i < 8; ++i) EXPECT_NEAR(odd[i], sums[i] / 22, 1e-15);
  // 6 layers: 1, q, q^2, q^2, q, 1 with q^2 = 4.
  const auto even = graded_layers({0, 4, Toward::both}, 6);
  const Real halves[] = {0, 1, 3, 7, 11, 13, 14};
  for (std::size_t i = 0; i < 7; ++i) EXPECT_NEAR(even[i], halves[i] / 14, 1e-15);
}

TEST(Grading, TowardTheMiddleSizesFallAndRise) {
  // 7 layers: q^3, q^2, q, 1, q, q^2, q^3 with q^3 = 8; their sum is 29.
  const auto odd = graded_layers({0, 8, Toward::middle}, 7);
  const Real sums[] = {0, 8, 12, 14, 15, 17, 21, 29};
  for (std::size_t i = 0; i < 8; ++i) EXPECT_NEAR(odd[i], sums[i] / 29, 1e-15);
  // 6 layers: q^2, q, 1, 1, q, q^2 with q^2 = 4.
  const auto even = graded_layers({0, 4, Toward::middle}, 6);
  const Real halves[] = {0, 4, 6, 7, 8, 10, 14};
  for (std::size_t i = 0; i < 7; ++i) EXPECT_NEAR(even[i], halves[i] / 14, 1e-15);
  // None is thicker than it may be, and one layer less would be: 29 of 8, 14 of 4.
  EXPECT_EQ(graded_count({0, 8, Toward::middle}, 29, 8), 7);
  EXPECT_EQ(graded_count({0, 4, Toward::middle}, 14, 4), 6);
  const Grading middle{0, 4, Toward::middle};
  EXPECT_EQ(turned(&middle, true)->toward, Toward::middle);
}

TEST(Grading, SizeIsTheLargestAndCellsAreTheFewest) {
  for (const Real ratio : {1.0, 3.0, 20.0}) {
    const int n = graded_count({0, ratio, Toward::max}, 10, 0.7);
    EXPECT_LE(ratio * progression(10, ratio + 1e-13, n), 0.7);
    EXPECT_GT(ratio * progression(10, ratio + 1e-13, n - 1), 0.7);
    const auto layers = graded_layers({0, ratio, Toward::max}, n);
    EXPECT_NEAR(layers[1] / (1 - layers[static_cast<std::size_t>(n) - 1]), ratio, 1e-10 * ratio);
  }
  EXPECT_EQ(graded_count({0, 1, Toward::min}, 3.81e-3, 0.381e-3), 10);  // rounding adds none
  EXPECT_THROW(graded_layers({0, 2, Toward::min}, 1), GradingError);
  EXPECT_THROW(graded_layers({0, 2, Toward::both}, 2), GradingError);
}

TEST(Grading, PolygonsTakeItAlongTheSidesThatRunThatWay) {
  // A trapezium whose points start anywhere and run clockwise: the fine layer lies below.
  PolygonShape shape;
  shape.points = {{3, 2}, {4, 0}, {0, 0}, {1, 2}};
  shape.corners = std::vector<int>{0, 1, 2, 3};
  const Sizing sizing{{}, std::vector<int>{6, 6}, {{1, 9, Toward::min}, {0, 4, Toward::max}}};
  const auto mesh = mesh_shape<2>({shape, {}, {}}, sizing, Geometry::plane_strain);
  const auto y = layers_of(mesh, 1);
  ASSERT_EQ(y.size(), 7u);
  EXPECT_NEAR(y[1] - y[0], progression(2, 9, 6), 1e-14);
  EXPECT_NEAR((y[6] - y[5]) / (y[1] - y[0]), 9, 1e-12);
  std::set<Real> foot;
  for (const auto& x : mesh.nodes) {
    if (x[1] == 0) foot.insert(x[0]);
  }
  const std::vector<Real> x(foot.begin(), foot.end());
  EXPECT_NEAR((x[1] - x[0]) / (x[6] - x[5]), 4, 1e-12);
  EXPECT_NEAR(area(mesh), 6, 1e-14);  // straight sides: exact
  shape.points = {{0, -1}, {1, 0}, {0, 1}, {-1, 0}};
  EXPECT_THROW(mesh_shape<2>({shape, {}, {}}, sizing, Geometry::plane_strain), GradingError);
}

/// Mean edge of the elements at the node nearest to a place.
template <int Dim>
Real size_at(const Mesh<Dim>& mesh, const Vec<Dim>& place) {
  int nearest = 0;
  for (int i = 0; i < static_cast<int>(mesh.nodes.size()); ++i) {
    const auto far = [&](int k) {
      return (mesh.nodes[static_cast<std::size_t>(k)] - place).norm();
    };
    if (far(i) < far(nearest)) nearest = i;
  }
  Real sum = 0;
  int count = 0;
  for (const auto& e : mesh.elements) {
    if (std::find(e.begin(), e.end(), nearest) == e.end()) continue;
    for (const int other : e) {
      const Real edge = (mesh.nodes[static_cast<std::size_t>(other)] -
                         mesh.nodes[static_cast<std::size_t>(nearest)])
                            .norm();
      if (edge > 0) sum += edge, ++count;
    }
  }
  return sum / count;
}

TEST(Grading, BallsAndDiscsAreMappedOntoThemselves) {
  Sphere ball;
  ball.radius = 2, ball.center = {0, 0, 2};
  const int n = 24;
  const Sizing graded{{}, std::vector<int>{n, n, n}, {{2, 9, Toward::min}}};
  const auto mesh = mesh_shape<3>({ball, {}, {}}, graded, Geometry::three_d);
  const auto even = mesh_shape<3>({ball, {}, {}}, {{}, graded.cells, {}}, Geometry::three_d);
  ASSERT_EQ(mesh.elements, even.elements);
  Real low = 1;
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    // What lay on the sphere lies on it.
    const Real before = (even.nodes[i] - Vec3(0, 0, 2)).norm();
    if (std::fabs(before - 2) < 1e-12) {
      EXPECT_NEAR((mesh.nodes[i] - Vec3(0, 0, 2)).norm(), 2, 1e-13);
    }
    low = std::min(low, mesh.nodes[i][2]);
  }
  EXPECT_NEAR(low, 0, 1e-15);
  // The scale over an edge of 1/24 of the radius differs from that at its end by some 1/12.
  const Real fine = size_at<3>(mesh, Vec3(0, 0, 0)) / size_at<3>(even, Vec3(0, 0, 0));
  const Real coarse = size_at<3>(mesh, Vec3(0, 0, 4)) / size_at<3>(even, Vec3(0, 0, 4));
  EXPECT_NEAR(fine, 1.0 / 3, 0.1 / 3);
  EXPECT_NEAR(coarse, 3, 0.3);

  Sphere disc;
  disc.radius = 2;
  const Sizing to_the_right{std::vector<Real>{0.4}, {}, {{0, 4, Toward::max}}};
  const auto flat = mesh_shape<2>({disc, {}, {}}, to_the_right, Geometry::plane_strain);
  EXPECT_LT(size_at<2>(flat, Vec<2>(2, 0)), 0.3 * size_at<2>(flat, Vec<2>(-2, 0)));
  // `size` is the largest radial edge of an O-grid; a rim of 4 n edges has 2 pi R/(4 n) each.
  Real largest = 0;
  for (const auto& e : flat.elements) {
    for (std::size_t c = 0; c < 4; ++c) {
      const Vec<2> edge = flat.nodes[static_cast<std::size_t>(e[c])] -
                          flat.nodes[static_cast<std::size_t>(e[(c + 1) % 4])];
      largest = std::max(largest, edge.norm());
    }
  }
  EXPECT_LT(largest, kPi / 2 * 0.4);
}

TEST(Grading, CylindersTakeItAlongTheirAxisAndAcross) {
  Cylinder bar;
  bar.radius = 1, bar.length = 4, bar.axis = {0, -1, 0}, bar.base = {0, 4, 0};
  const Sizing sizing{{}, std::vector<int>{8, 8, 5}, {{1, 6, Toward::min}, {0, 4, Toward::max}}};
  const auto mesh = mesh_shape<3>({bar, {}, {}}, sizing, Geometry::three_d);
  const auto y = layers_of(mesh, 1);
  ASSERT_EQ(y.size(), 6u);
  EXPECT_NEAR(y[1] - y[0], progression(4, 6, 5), 1e-14);  // the foot at y = 0, away from the base
  Real left = 0, right = 0;
  for (const auto& x : mesh.nodes) (x[0] > 0 ? right : left) += 1;
  EXPECT_GT(right, 1.5 * left);
}

TEST(Grading, IsRefusedWhereItHasNoMeaning) {
  const auto refused = [](const ShapeKind& kind, std::vector<Grading> gradings) {
    const Sizing sizing{{}, std::vector<int>{4, 4, 4}, std::move(gradings)};
    EXPECT_THROW(mesh_shape<3>({kind, {}, {}}, sizing, Geometry::three_d), GradingError);
  };
  BrickWall wall;
  wall.bricks = std::vector<int>{2, 1, 2}, wall.brick = {0.2, 0.1, 0.06};
  refused(wall, {{0, 2, Toward::min}});
  Tube tube;
  tube.inner = 1, tube.outer = 2, tube.length = 1;
  refused(tube, {{0, 2, Toward::min}});
  Cylinder skew;
  skew.radius = 1, skew.length = 1, skew.axis = {1, 1, 0};
  refused(skew, {{0, 2, Toward::min}});
  Sphere ball;
  ball.radius = 1;
  refused(ball, {{0, 2, Toward::both}});
  refused(ball, {{0, 2, Toward::min}, {1, 2, Toward::min}});
  const Sizing sideways{{}, std::vector<int>{4, 4}, {{0, 2, Toward::min}}};
  EXPECT_THROW(mesh_shape<2>({ball, {}, {}}, sideways, Geometry::axisymmetric), GradingError);
  EXPECT_THROW(
      surface_of_shape<2>({Plane{{0, 0}, {0, 1}, 1}, {}, {}}, sideways, Geometry::plane_strain),
      GradingError);
}

}  // namespace
}  // namespace brunt
