#include "core/geometry/one_side.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "core/geometry/solid_angle.hpp"

namespace brunt {

namespace {
using Face = std::array<int, 4>;

int corners_of(const Face& face) { return face[3] < 0 ? 3 : 4; }

/// One triangle, or the two of a quad: visit(a, b, c) with places of nodes.
template <class Visit>
void for_triangles(const Face& face, const Visit& visit) {
  visit(face[0], face[1], face[2]);
  if (face[3] >= 0) visit(face[0], face[2], face[3]);
}

/// Faces that hang together at edges.
struct Shell {
  std::vector<std::size_t> faces;
  bool closed = true;
  Real volume = 0;  ///< [m^3] negative: it faces inwards
  Vec3 low = Vec3::Constant(kInfinity), high = Vec3::Constant(-kInfinity);
};

/// Sets of faces that are joined one by one (union-find).
class FaceSets {
 public:
  explicit FaceSets(std::size_t n) : parent_(n) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  std::size_t of(std::size_t f) {
    while (parent_[f] != f) f = parent_[f] = parent_[parent_[f]];
    return f;
  }
  void join(std::size_t f, std::size_t g) { parent_[of(f)] = of(g); }

 private:
  std::vector<std::size_t> parent_;
};

using Edge = std::pair<int, int>;

std::map<Edge, std::vector<std::size_t>> faces_at_edges(const std::vector<Face>& faces) {
  std::map<Edge, std::vector<std::size_t>> edges;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const int n = corners_of(faces[f]);
    for (int c = 0; c < n; ++c) {
      const int a = faces[f][slot_of(c)], b = faces[f][slot_of((c + 1) % n)];
      edges[std::minmax(a, b)].push_back(f);
    }
  }
  return edges;
}

/// True where each set has an even number of the faces at an edge.
bool are_pairs(FaceSets& sets, const std::vector<std::size_t>& at_edge) {
  std::map<std::size_t, int> times;
  for (const std::size_t f : at_edge) ++times[sets.of(f)];
  return std::all_of(times.begin(), times.end(),
                     [](const auto& set) { return set.second % 2 == 0; });
}

/// Where more than two faces meet at an edge, bodies touch there: what hangs together elsewhere is
/// a shell by itself, unless it would be open at that edge.
std::vector<Shell> shells_of(const std::vector<Face>& faces) {
  const auto edges = faces_at_edges(faces);
  FaceSets sets(faces.size());
  for (const auto& [edge, at] : edges) {
    if (at.size() == 2) sets.join(at[0], at[1]);
  }
  for (const auto& [edge, at] : edges) {
    if (are_pairs(sets, at)) continue;
    for (const std::size_t f : at) sets.join(f, at.front());
  }
  std::map<std::size_t, Shell> shells;
  for (std::size_t f = 0; f < faces.size(); ++f) shells[sets.of(f)].faces.push_back(f);
  for (const auto& [edge, at] : edges) {
    if (at.size() % 2 == 1) shells[sets.of(at.front())].closed = false;
  }
  std::vector<Shell> list;
  list.reserve(shells.size());
  for (auto& [number, shell] : shells) list.push_back(std::move(shell));
  return list;
}

void measure(const std::vector<Vec3>& nodes, const std::vector<Face>& faces, Shell& shell) {
  const Vec3 from = nodes[slot_of(faces[shell.faces.front()][0])];
  const auto at = [&](int node) -> Vec3 { return nodes[slot_of(node)] - from; };
  Real area = 0;
  for (const std::size_t f : shell.faces) {
    for_triangles(faces[f], [&](int a, int b, int c) {
      shell.volume += at(a).dot(at(b).cross(at(c))) / 6;
      area += 0.5 * (at(b) - at(a)).cross(at(c) - at(a)).norm();
      for (const int node : {a, b, c}) {
        shell.low = shell.low.cwiseMin(nodes[slot_of(node)]);
        shell.high = shell.high.cwiseMax(nodes[slot_of(node)]);
      }
    });
  }
  constexpr Real kNone = 1e-9;  // of the cube of its size: a sheet that is there twice
  if (!(std::fabs(shell.volume) > kNone * area * std::sqrt(area))) shell.volume = 0;
}

/// True where a closed shell, however it faces, goes round x: x sees it under the full angle.
bool goes_round(const std::vector<Vec3>& nodes, const std::vector<Face>& faces, const Shell& shell,
                const Vec3& x) {
  Real angle = 0;  // [sr]
  for (const std::size_t f : shell.faces) {
    for_triangles(faces[f], [&](int i, int j, int k) {
      angle += solid_angle(nodes[slot_of(i)], nodes[slot_of(j)], nodes[slot_of(k)], x);
    });
  }
  return std::fabs(angle) > 2 * kPi;
}

Vec3 center_of(const std::vector<Vec3>& nodes, const Face& face) {
  Vec3 sum = Vec3::Zero();
  const int n = corners_of(face);
  for (int c = 0; c < n; ++c) sum += nodes[slot_of(face[slot_of(c)])];
  return sum / n;
}

/// True where a shell is inside another, all of it: of its faces some, spread over it, are asked.
/// Their corners would not do: they may lie on the other where the two touch.
bool is_inside(const std::vector<Vec3>& nodes, const std::vector<Face>& faces, const Shell& shell,
               const Shell& other) {
  constexpr std::size_t kAsked = 64;
  if ((shell.low - other.low).minCoeff() < 0 || (other.high - shell.high).minCoeff() < 0) {
    return false;
  }
  const std::size_t n = shell.faces.size(), step = n / kAsked + 1;
  for (std::size_t k = 0; k < n; k += step) {
    const Vec3 x = center_of(nodes, faces[shell.faces[k]]);
    if (!goes_round(nodes, faces, other, x)) return false;
  }
  return true;
}
}  // namespace

TurnedShells turn_outward(const std::vector<Vec3>& nodes, std::vector<Face>& faces) {
  auto shells = shells_of(faces);
  for (auto& shell : shells) measure(nodes, faces, shell);
  std::erase_if(shells, [](const Shell& shell) { return !shell.closed || shell.volume == 0; });
  std::vector<char> turns(shells.size(), 0);
  for (std::size_t outer = 0; outer < shells.size(); ++outer) {
    if (shells[outer].volume > 0) continue;
    std::vector<std::size_t> with{outer};
    bool outermost = true;
    for (std::size_t k = 0; k < shells.size() && outermost; ++k) {
      if (k == outer) continue;
      outermost = !is_inside(nodes, faces, shells[outer], shells[k]);
      if (is_inside(nodes, faces, shells[k], shells[outer])) with.push_back(k);
    }
    if (!outermost) continue;
    for (const std::size_t k : with) turns[k] = 1;
  }
  TurnedShells result{0, shells.size()};
  for (std::size_t k = 0; k < shells.size(); ++k) {
    if (turns[k] == 0) continue;
    ++result.turned;
    for (const std::size_t f : shells[k].faces) std::swap(faces[f][0], faces[f][2]);
  }
  return result;
}

}  // namespace brunt
// Tested by tests/unit/core/turn_outward_test.cpp.
