#include "core/geometry/closed_surface.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
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

/// The number of each triangle's shell, of what hangs together at nodes, as their first ones come.
std::vector<Label> connected(std::size_t n_nodes,
                             const std::vector<std::array<int, 3>>& triangles) {
  std::vector<std::size_t> parent(n_nodes);
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root = [&](int node) {
    auto i = slot_of(node);
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  for (const auto& [a, b, c] : triangles) {
    parent[root(b)] = root(a);
    parent[root(c)] = root(a);
  }
  std::map<std::size_t, Label> number;
  std::vector<Label> shell;
  shell.reserve(triangles.size());
  for (const auto& triangle : triangles) {
    const auto next = static_cast<Label>(number.size());
    shell.push_back(number.try_emplace(root(triangle[0]), next).first->second);
  }
  return shell;
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
  find_rooms();
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

/// Visits the triangles below a point with what each adds to the winding, 1 or -1.
template <class Visit>
void ClosedSurface::visit_below(const Vec3& x, const Visit& visit) const {
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
    if (height / whole < x[2]) visit(t, -sides[0]);
  }
}

int ClosedSurface::winding(const Vec3& x) const {
  int winding = 0;
  visit_below(x, [&](int, int adds) { winding += adds; });
  return winding;
}

Label ClosedSurface::room_at(const Vec3& x) const {
  if (n_rooms_ == 1) return 0;
  std::map<Label, int> windings;
  visit_below(x, [&](int t, int adds) { windings[room_[slot_of(t)]] += adds; });
  for (const auto& [room, winding] : windings) {
    if (winding > 0) return room;
  }
  return 0;
}

/// The smallest shell that goes round a place and bounds a volume; shell 0 where none does.
Label ClosedSurface::shell_round(const Vec3& x, const std::vector<Real>& volume) const {
  std::map<Label, int> windings;
  visit_below(x, [&](int t, int adds) { windings[room_[slot_of(t)]] += adds; });
  Label smallest = 0;
  Real least = kInfinity;
  for (const auto& [shell, winding] : windings) {
    if (winding > 0 && volume[shell] > 0 && volume[shell] < least) {
      smallest = shell, least = volume[shell];
    }
  }
  return smallest;
}

/// A hollow belongs to the smallest of the shells round it that face outwards.
void ClosedSurface::find_rooms() {
  room_ = connected(nodes_.size(), triangles_);  // shells until their rooms are known
  std::vector<Real> volume(*std::max_element(room_.begin(), room_.end()) + std::size_t{1});
  if (volume.size() == 1) return;
  const auto at = [&](int node) { return Vec3(nodes_[slot_of(node)] - low_); };
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    const auto& [a, b, c] = triangles_[t];
    volume[room_[t]] += at(a).dot(at(b).cross(at(c))) / 6;
  }
  std::vector<Label> owner(volume.size()), number(volume.size());
  std::vector<char> seen(volume.size(), 0);
  n_rooms_ = 0;
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    const Label shell = room_[t];
    if (seen[shell] != 0) continue;
    seen[shell] = 1, owner[shell] = shell;
    if (volume[shell] > 0) {
      number[shell] = static_cast<Label>(n_rooms_++);
      continue;
    }
    const auto& [a, b, c] = triangles_[t];
    owner[shell] = shell_round((nodes_[a] + nodes_[b] + nodes_[c]) / 3, volume);
  }
  for (Label& room : room_) room = number[owner[room]];
}

}  // namespace brunt
