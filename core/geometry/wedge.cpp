#include "core/geometry/wedge.hpp"

#include <cmath>

namespace brunt {

namespace {
constexpr Real kRight = kPi / 2;

/// [rad] between the two faces
Real angle_of(const Wedge& wedge) { return kRight - wedge.rake - wedge.clearance; }
}  // namespace

Real length_of_edge(const Wedge& wedge) {
  return wedge.edge_radius / std::tan(0.5 * angle_of(wedge));
}

PolygonShape polygon_of(const Wedge& wedge) {
  constexpr Real kTurn = kPi / 18;
  const Real x = wedge.tip[0], y = wedge.tip[1], r = wedge.edge_radius;
  const Real turn = kPi - angle_of(wedge);  // of the edge, in all
  const Real bisector = 0.5 * (kRight - wedge.rake + wedge.clearance);
  const Real off = r / std::sin(0.5 * angle_of(wedge));
  const Real center[2] = {x + off * std::cos(bisector), y + off * std::sin(bisector)};
  const int half = r > 0 ? static_cast<int>(std::ceil(0.5 * turn / kTurn)) : 0;
  const auto on_edge = [&](int k) {  // 0: its middle; half: where the clearance face begins
    const Real angle = bisector + kPi + (half > 0 ? 0.5 * turn * k / half : 0);
    return std::vector<Real>{center[0] + r * std::cos(angle), center[1] + r * std::sin(angle)};
  };
  PolygonShape polygon;
  auto& points = polygon.points;
  for (int k = 0; k <= half; ++k) points.push_back(on_edge(k));
  const int back = static_cast<int>(points.size());
  points.push_back({x + wedge.length, y + wedge.length * std::tan(wedge.clearance)});
  points.push_back({x + wedge.length, y + wedge.height});
  points.push_back({x + wedge.height * std::tan(wedge.rake), y + wedge.height});
  for (int k = -half; k < 0; ++k) points.push_back(on_edge(k));
  polygon.corners = {0, back, back + 1, back + 2};
  polygon.thickness = wedge.thickness;
  polygon.base = wedge.tip.size() > 2 ? wedge.tip[2] : 0;
  return polygon;
}

}  // namespace brunt
// Tested by tests/unit/core/wedge_test.cpp.
