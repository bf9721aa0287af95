#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "core/geometry/grid.hpp"
#include "core/geometry/placement.hpp"
#include "core/geometry/profile.hpp"

namespace brunt {

namespace {
/// Four sides of a polygon between its corners, each a polyline.
std::array<std::vector<Vec<2>>, 4> sides_of(const PolygonShape& polygon) {
  if (!polygon.corners) {
    throw std::invalid_argument(
        "a polygon of finite elements needs `corners: [i, j, k, l]`, four of its points; fill "
        "other polygons with particles (method: sph)");
  }
  const int n = static_cast<int>(polygon.points.size());
  std::vector<Vec<2>> outline;
  for (const auto& point : polygon.points) outline.push_back(to_vector<2>(point));
  require_simple(outline);
  std::array<std::vector<Vec<2>>, 4> sides;
  Real area = 0;
  for (int i = 0; i < n; ++i) {
    const auto a = to_vector<2>(polygon.points[i]);
    const auto b = to_vector<2>(polygon.points[(i + 1) % n]);
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
    sides[s].push_back(to_vector<2>(polygon.points[i]));
    while (i != last) {
      i = (i + step + n) % n;
      sides[s].push_back(to_vector<2>(polygon.points[i]));
    }
  }
  return sides;
}

Real length_of(const std::vector<Vec<2>>& line) {
  Real sum = 0;
  for (std::size_t i = 1; i < line.size(); ++i) sum += (line[i] - line[i - 1]).norm();
  return sum;
}

/// Which of the two directions of a polygon's grid runs along each axis, and which way.
struct PolygonGrading {
  std::array<std::optional<Grading>, 2> along;

  PolygonGrading(const std::array<std::vector<Vec<2>>, 4>& sides, const Sizing& sizing) {
    const Vec<2>&a = sides[0].front(), &b = sides[1].front(), &c = sides[2].front();
    const Vec<2>& d = sides[3].front();
    const std::array<Vec<2>, 2> way{(b + c - a - d).normalized(), (c + d - a - b).normalized()};
    for (int axis = 0; axis < 2; ++axis) {
      const Grading* grading = sizing.along(axis);
      if (!grading) continue;
      constexpr Real kClear = 0.1;
      const Real first = std::fabs(way[0][axis]), second = std::fabs(way[1][axis]);
      const std::size_t chosen = first > second ? 0 : 1;
      if (std::fabs(first - second) < kClear || along[chosen]) {
        throw GradingError(std::string("neither pair of its sides runs along ") + "xy"[axis] +
                           " more than the other: draw it along the axes, and turn it by `rotate`");
      }
      along[chosen] = turned(grading, way[chosen][axis] < 0);
    }
  }
};

}  // namespace

Mesh<2> polygon_grid(const PolygonShape& polygon, const Sizing& sizing) {
  const auto sides = sides_of(polygon);
  const PolygonGrading grading(sides, sizing);
  const Real along = std::max(length_of(sides[0]), length_of(sides[2]));
  const Real across = std::max(length_of(sides[1]), length_of(sides[3]));
  return transfinite_grid(sides, {layers_along(sizing, 0, along, grading.along[0]),
                                  layers_along(sizing, 1, across, grading.along[1])});
}

}  // namespace brunt
// Tested by tests/unit/core/shapes_test.cpp.
