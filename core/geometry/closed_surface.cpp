#include "core/geometry/closed_surface.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "core/geometry/one_side.hpp"

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

/// Edges of triangles at which something is wrong.
struct BadEdges {
  std::size_t count = 0;
  std::pair<int, int> first;  ///< nodes

  void add(const std::pair<int, int>& edge) {
    if (count++ == 0) first = edge;
  }
  std::string first_text(const std::vector<Vec3>& nodes) const {
    return "from " + place_text(nodes[first.first]) + " to " + place_text(nodes[first.second]) +
           " m";
  }
};

/// Where a surface is open, and where neighbours face opposite ways.
struct EdgeFaults {
  BadEdges open, turned;
};

EdgeFaults edge_faults(const std::vector<std::array<int, 3>>& triangles) {
  struct Use {
    int balance = 0;  ///< times that it is run along, less against, its nodes
    int times = 0;
  };
  std::map<std::pair<int, int>, Use> edges;
  for (const auto& triangle : triangles) {
    for (std::size_t c = 0; c < 3; ++c) {
      const int a = triangle[c], b = triangle[(c + 1) % 3];
      Use& use = edges[std::minmax(a, b)];
      use.balance += a < b ? 1 : -1;
      ++use.times;
    }
  }
  EdgeFaults faults;
  for (const auto& [edge, use] : edges) {
    if (use.balance != 0) (use.times % 2 == 1 ? faults.open : faults.turned).add(edge);
  }
  return faults;
}

void refuse_turned(const BadEdges& turned, const std::vector<Vec3>& nodes) {
  if (turned.count == 0) return;
  throw std::invalid_argument("at " + std::to_string(turned.count) +
                              " edges neighbouring triangles face opposite ways, the first " +
                              turned.first_text(nodes) + "; turn the normals to one side");
}
}  // namespace

void require_one_side(const std::vector<Vec3>& nodes,
                      const std::vector<std::array<int, 3>>& triangles) {
  refuse_turned(edge_faults(triangles).turned, nodes);
}

ClosedSurface::ClosedSurface(std::vector<Vec3> nodes, std::vector<std::array<int, 3>> triangles,
                             Real cell)
    : nodes_(std::move(nodes)), triangles_(std::move(triangles)) {
  require_closed();
  low_ = high_ = nodes_.front();
  for (const Vec3& x : nodes_) low_ = low_.cwiseMin(x), high_ = high_.cwiseMax(x);
  const auto at = [&](int node) { return Vec3(nodes_[node] - low_); };
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
  const EdgeFaults faults = edge_faults(triangles_);
  if (faults.open.count > 0) {
    throw std::invalid_argument(
        "the surface is open, and has no inside to fill: " + std::to_string(faults.open.count) +
        " of its edges have a triangle on one side alone, the first " +
        faults.open.first_text(nodes_) + "; close it where it was drawn");
  }
  refuse_turned(faults.turned, nodes_);
}

std::size_t ClosedSurface::column_of(Real x, int axis) const {
  const auto c = slot_of(axis);
  const Real steps = std::floor((x - low_[axis]) / width_[c]);
  return static_cast<std::size_t>(std::clamp(steps, 0.0, static_cast<Real>(count_[c] - 1)));
}

void ClosedSurface::sort_into_columns(Real cell) {
  constexpr Real kMost = 1000;  // columns along an axis
  for (int axis = 0; axis < 2; ++axis) {
    const auto c = slot_of(axis);
    const Real length = high_[axis] - low_[axis];
    const Real count = std::clamp(std::ceil(length / cell), 1.0, kMost);
    count_[c] = static_cast<std::size_t>(count);
    width_[c] = length / count;
  }
  columns_.resize(count_[0] * count_[1]);
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    Vec3 low = Vec3::Constant(kInfinity), high = Vec3::Constant(-kInfinity);
    for (const int node : triangles_[t]) {
      low = low.cwiseMin(nodes_[node]);
      high = high.cwiseMax(nodes_[node]);
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
    const auto& triangle = triangles_[t];
    int sides[3];
    Real height = 0, whole = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const int a = triangle[c], b = triangle[(c + 1) % 3];
      const Vec3 &xa = nodes_[a], &xb = nodes_[b];
      // Both triangles of an edge take it the same way, and rounding does not part them.
      sides[c] = a < b ? side(xa, xb, x) : -side(xb, xa, x);
      const Real share = (xa[0] - x[0]) * (xb[1] - x[1]) - (xa[1] - x[1]) * (xb[0] - x[0]);
      height += share * nodes_[triangle[(c + 2) % 3]][2];
      whole += share;
    }
    if (sides[0] == 0 || sides[0] != sides[1] || sides[1] != sides[2] || whole == 0) continue;
    if (height / whole < x[2]) winding -= sides[0];
  }
  return winding;
}

}  // namespace brunt
