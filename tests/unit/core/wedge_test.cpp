// The outline of a cutting tool. rake gamma, clearance alpha, beta = 90 deg - gamma - alpha between
// its faces. The sharp one is a rectangle of length L and height H less two triangles, L H - (H^2
// tan gamma + L^2 tan alpha)/2. A circle of radius r that touches both faces does so t =
// r/tan(beta/ 2) from the tip; rounding takes the kite r t and gives back n triangles r^2/2
// sin(turn/n) of chords that turn by pi - beta in all, each by at most 10 deg.
#include "core/geometry/wedge.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/geometry/mesh.hpp"

namespace brunt {
namespace {

constexpr Real kDegree = kPi / 180;

Wedge tool(Real edge_radius) {
  Wedge wedge;
  wedge.tip = {0.5, 0.25, 0.125};
  wedge.rake = 6 * kDegree, wedge.clearance = 8 * kDegree;
  wedge.edge_radius = edge_radius;
  wedge.height = 2, wedge.length = 3, wedge.thickness = 1.5;
  return wedge;
}

Real area(const PolygonShape& polygon) {
  Real sum = 0;
  const auto& points = polygon.points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto &a = points[i], &b = points[(i + 1) % points.size()];
    sum += 0.5 * (a[0] * b[1] - a[1] * b[0]);
  }
  return sum;
}

const Real kSharp = 2 * 3 - (4 * std::tan(6 * kDegree) + 9 * std::tan(8 * kDegree)) / 2;

TEST(Wedge, IsSharpWithoutARadius) {
  const PolygonShape polygon = polygon_of(tool(0));
  ASSERT_EQ(polygon.points.size(), 4u);
  EXPECT_EQ(polygon.points[0], (std::vector<Real>{0.5, 0.25}));
  EXPECT_NEAR(polygon.points[1][1], 0.25 + 3 * std::tan(8 * kDegree), 1e-15);
  EXPECT_NEAR(polygon.points[3][0], 0.5 + 2 * std::tan(6 * kDegree), 1e-15);
  EXPECT_NEAR(area(polygon), kSharp, 1e-14);
}

TEST(Wedge, RoundsItsEdgeByACircleThatTouchesBothFaces) {
  constexpr Real r = 0.2;
  const Real beta = 76 * kDegree, turn = kPi - beta, t = r / std::tan(beta / 2);
  EXPECT_NEAR(length_of_edge(tool(r)), t, 1e-15);
  const PolygonShape polygon = polygon_of(tool(r));
  const int n = static_cast<int>(polygon.points.size()) - 4;  // chords
  EXPECT_GE(n * 10 * kDegree, turn);
  EXPECT_NEAR(area(polygon), kSharp - r * t + 0.5 * r * r * n * std::sin(turn / n), 1e-14);
  // Its lowest point lies r below the centre, which is as far above the clearance face.
  const Real off = r / std::sin(beta / 2), bisector = (90 - 6 + 8) / 2 * kDegree;
  Real lowest = kInfinity, foremost = kInfinity;
  for (const auto& point : polygon.points) {
    lowest = std::min(lowest, point[1]), foremost = std::min(foremost, point[0]);
  }
  EXPECT_NEAR(lowest, 0.25 + off * std::sin(bisector) - r, r * (1 - std::cos(5 * kDegree)));
  EXPECT_NEAR(foremost, 0.5 + off * std::cos(bisector) - r, r * (1 - std::cos(5 * kDegree)));
}

TEST(Wedge, IsMeshedFilledAndClosedFromItsTipAlongZ) {
  BodyShape shape;
  shape.kind = tool(0.2);
  const Real exact = area(polygon_of(tool(0.2)));
  const Sizing sizing{std::vector<Real>{0.1}, {}, {}};
  const auto surface = surface_of_shape<3>(shape, sizing, Geometry::three_d);
  const auto mesh = mesh_shape<3>(shape, sizing, Geometry::three_d);
  for (const auto* nodes : {&surface.nodes, &mesh.nodes}) {
    Real low = kInfinity, high = -kInfinity;
    for (const auto& x : *nodes) low = std::min(low, x[2]), high = std::max(high, x[2]);
    EXPECT_DOUBLE_EQ(low, 0.125);
    EXPECT_DOUBLE_EQ(high, 1.625);
  }
  const auto flat = mesh_shape<2>(shape, sizing, Geometry::plane_strain);
  Real sum = 0;
  for (const auto& element : flat.elements) {
    const auto at = [&](std::size_t c) { return flat.nodes[static_cast<std::size_t>(element[c])]; };
    const Vec<2> a = at(2) - at(0), b = at(3) - at(1);
    sum += 0.5 * (a[0] * b[1] - a[1] * b[0]);
  }
  EXPECT_NEAR(sum / exact, 1, 2e-3);  // elements cut the corners of the edge
  const auto filled = fill_shape<3>(shape, {0.05, 0.05, 0.05}, LatticeKind::cubic);
  EXPECT_NEAR(filled.volume / (1.5 * exact), 1, 1e-12);
}

TEST(Wedge, LeansForwardWithANegativeRake) {
  Wedge wedge = tool(0.1);
  wedge.rake = -10 * kDegree;
  const auto points = polygon_of(wedge).points;
  const Real foremost = std::min_element(points.begin(), points.end())->front();
  EXPECT_NEAR(foremost, 0.5 - 2 * std::tan(10 * kDegree), 1e-14);
}

}  // namespace
}  // namespace brunt
