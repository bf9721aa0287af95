#include "core/geometry/one_side.hpp"

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

std::vector<Shell> shells_of(const std::vector<Face>& faces) {
  std::vector<std::size_t> parent(faces.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root = [&](std::size_t f) {
    while (parent[f] != f) f = parent[f] = parent[parent[f]];
    return f;
  };
  struct Use {
    std::size_t first = 0, times = 0;
  };
  std::map<std::pair<int, int>, Use> edges;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const int n = corners_of(faces[f]);
    for (int c = 0; c < n; ++c) {
      const int a = faces[f][slot_of(c)], b = faces[f][slot_of((c + 1) % n)];
      Use& use = edges.try_emplace(std::minmax(a, b), Use{f, 0}).first->second;
      ++use.times;
      parent[root(f)] = root(use.first);
    }
  }
  std::map<std::size_t, Shell> shells;
  for (std::size_t f = 0; f < faces.size(); ++f) shells[root(f)].faces.push_back(f);
  for (const auto& [edge, use] : edges) {
    if (use.times % 2 == 1) shells[root(use.first)].closed = false;
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

/// True where a shell is inside another, all of it: of its faces some, spread over it, are asked.
bool is_inside(const std::vector<Vec3>& nodes, const std::vector<Face>& faces, const Shell& shell,
               const Shell& other) {
  constexpr std::size_t kAsked = 64;
  if ((shell.low - other.low).minCoeff() < 0 || (other.high - shell.high).minCoeff() < 0) {
    return false;
  }
  const std::size_t n = shell.faces.size(), step = n / kAsked + 1;
  for (std::size_t k = 0; k < n; k += step) {
    const Vec3& x = nodes[slot_of(faces[shell.faces[k]][0])];
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
