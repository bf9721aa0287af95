#include "core/geometry/closed_surface.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace brunt {

namespace {
/// On which side of the line from a to b a point lies, seen from above: 1 left, -1 right; 0 where a
/// and b lie above each other. On the line itself the side of (x + e, y + e^2) for a tiny e > 0.
int side(const Vec3& a, const Vec3& b, const Vec3& x) {
  const Real dx = b[0] - a[0], dy = b[1] - a[1];
  const Real turn = dx * (x[1] - a[1]) - dy * (x[0] - a[0]);
  const Real decides = turn != 0 ? turn : dy != 0 ? -dy : dx;
  return decides > 0 ? 1 : decides < 0 ? -1 : 0;
}

std::string place_text(const Vec3& x) {
  std::ostringstream text;
  text << "(" << x[0] << ", " << x[1] << ", " << x[2] << ")";
  return text.str();
}
}  // namespace

ClosedSurface::ClosedSurface(std::vector<Vec3> nodes, std::vector<std::array<int, 3>> triangles,
                             Real cell)
    : nodes_(std::move(nodes)), triangles_(std::move(triangles)) {
  require_closed();
  low_ = high_ = nodes_.front();
  for (const Vec3& x : nodes_) low_ = low_.cwiseMin(x), high_ = high_.cwiseMax(x);
  const auto at = [&](int node) { return Vec3(nodes_[static_cast<std::size_t>(node)] - low_); };
  for (const auto& [a, b, c] : triangles_) volume_ += at(a).dot(at(b).cross(at(c))) / 6;
  if (volume_ < 0) {
    for (auto& triangle : triangles_) std::swap(triangle[0], triangle[1]);
    volume_ = -volume_;
  }
  constexpr Real kFlat = 1e-12;  // of its box
  if (!(volume_ > kFlat * (high_ - low_).prod())) {
    throw std::invalid_argument("the surface encloses no volume");
  }
  sort_into_columns(cell);
}

void ClosedSurface::require_closed() const {
  std::map<std::pair<int, int>, int> edges;  // times that it is run along, less against, its nodes
  std::map<std::pair<int, int>, int> uses;
  for (const auto& triangle : triangles_) {
    for (std::size_t c = 0; c < 3; ++c) {
      const int a = triangle[c], b = triangle[(c + 1) % 3];
      edges[std::minmax(a, b)] += a < b ? 1 : -1;
      ++uses[std::minmax(a, b)];
    }
  }
  std::size_t open = 0, turned = 0;
  std::pair<int, int> first_open, first_turned;
  for (const auto& [edge, balance] : edges) {
    if (balance == 0) continue;
    if (uses[edge] % 2 == 1) {
      if (open++ == 0) first_open = edge;
    } else if (turned++ == 0) {
      first_turned = edge;
    }
  }
  const auto text = [&](const std::pair<int, int>& edge) {
    return "from " + place_text(nodes_[static_cast<std::size_t>(edge.first)]) + " to " +
           place_text(nodes_[static_cast<std::size_t>(edge.second)]) + " m";
  };
  if (open > 0) {
    throw std::invalid_argument(
        "the surface is open, and has no inside to fill: " + std::to_string(open) +
        " of its edges have a triangle on one side alone, the first " + text(first_open) +
        "; close it where it was drawn");
  }
  if (turned > 0) {
    throw std::invalid_argument("at " + std::to_string(turned) +
                                " edges neighbouring triangles face opposite ways, the first " +
                                text(first_turned) + "; turn the normals to one side");
  }
}

std::size_t ClosedSurface::column_of(Real x, int axis) const {
  const auto c = static_cast<std::size_t>(axis);
  const Real steps = std::floor((x - low_[axis]) / width_[c]);
  return static_cast<std::size_t>(std::clamp(steps, 0.0, static_cast<Real>(count_[c] - 1)));
}

void ClosedSurface::sort_into_columns(Real cell) {
  constexpr Real kMost = 1000;  // columns along an axis
  for (int axis = 0; axis < 2; ++axis) {
    const auto c = static_cast<std::size_t>(axis);
    const Real length = high_[axis] - low_[axis];
    const Real count = std::clamp(std::ceil(length / cell), 1.0, kMost);
    count_[c] = static_cast<std::size_t>(count);
    width_[c] = length / count;
  }
  columns_.resize(count_[0] * count_[1]);
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    Vec3 low = Vec3::Constant(kInfinity), high = Vec3::Constant(-kInfinity);
    for (const int node : triangles_[t]) {
      low = low.cwiseMin(nodes_[static_cast<std::size_t>(node)]);
      high = high.cwiseMax(nodes_[static_cast<std::size_t>(node)]);
    }
    for (std::size_t i = column_of(low[0], 0); i <= column_of(high[0], 0); ++i) {
      for (std::size_t j = column_of(low[1], 1); j <= column_of(high[1], 1); ++j) {
        columns_[i * count_[1] + j].push_back(static_cast<int>(t));
      }
    }
  }
}

int ClosedSurface::winding(const Vec3& x) const {
  int winding = 0;
  for (const int t : columns_[column_of(x[0], 0) * count_[1] + column_of(x[1], 1)]) {
    const auto& triangle = triangles_[static_cast<std::size_t>(t)];
    int sides[3];
    Real height = 0, whole = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const int a = triangle[c], b = triangle[(c + 1) % 3];
      const Vec3 &xa = nodes_[static_cast<std::size_t>(a)],
                 &xb = nodes_[static_cast<std::size_t>(b)];
      // Both triangles of an edge take it the same way, and rounding does not part them.
      sides[c] = a < b ? side(xa, xb, x) : -side(xb, xa, x);
      const Real share = (xa[0] - x[0]) * (xb[1] - x[1]) - (xa[1] - x[1]) * (xb[0] - x[0]);
      height += share * nodes_[static_cast<std::size_t>(triangle[(c + 2) % 3])][2];
      whole += share;
    }
    if (sides[0] == 0 || sides[0] != sides[1] || sides[1] != sides[2] || whole == 0) continue;
    if (height / whole < x[2]) winding -= sides[0];
  }
  return winding;
}

}  // namespace brunt
