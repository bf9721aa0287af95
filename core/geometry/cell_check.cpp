#include "core/geometry/cell_check.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace brunt {

namespace {
/// The edges of a corner: `next` and `before` go round one of its faces, `inner` leaves it.
struct CornerEdges {
  std::size_t corner, next, before, inner;
};

std::vector<CornerEdges> corner_edges(const ElementType& type) {
  std::vector<CornerEdges> edges;
  for (std::size_t c = 0; c < slot_of(type.corners); ++c) {
    CornerEdges found{c, c, c, c};
    std::vector<std::size_t> neighbours;
    for (std::size_t f = 0; f < slot_of(type.faces); ++f) {
      const auto& face = type.face[f];
      const auto n =
          slot_of(std::count_if(face.begin(), face.end(), [](int node) { return node >= 0; }));
      for (std::size_t k = 0; k < n; ++k) {
        if (face[k] != static_cast<int>(c)) continue;
        const auto next = slot_of(face[(k + 1) % n]);
        const auto before = slot_of(face[(k + n - 1) % n]);
        if (type.dim == 2) {
          (k == 0 ? found.next : found.before) = k == 0 ? next : before;
        } else {
          if (neighbours.empty()) found.next = next, found.before = before;
          neighbours.push_back(next), neighbours.push_back(before);
        }
      }
    }
    for (const std::size_t each : neighbours) {
      if (each != found.next && each != found.before) found.inner = each;
    }
    edges.push_back(found);
  }
  return edges;
}

/// True where the edges of every corner span a positive volume.
bool is_convex(const CellMesh& mesh, std::size_t cell, const std::vector<CornerEdges>& corners) {
  constexpr Real kFlat = 1e-9;  // of the volume of a cube of the same edges
  const auto nodes = mesh[cell];
  const auto at = [&](std::size_t c) { return mesh.nodes[slot_of(nodes[c])]; };
  for (const CornerEdges& edge : corners) {
    const Vec3 x = at(edge.corner);
    Vec3 next = at(edge.next) - x, before = at(edge.before) - x;
    if (mesh.type->dim == 2) {
      const Real area = next[0] * before[1] - next[1] * before[0];
      const Real whole = next.head<2>().norm() * before.head<2>().norm();
      if (!(area > kFlat * whole)) return false;
      continue;
    }
    const Vec3 inner = at(edge.inner) - x;
    const Real volume = -next.cross(before).dot(inner);
    if (!(volume > kFlat * next.norm() * before.norm() * inner.norm())) return false;
  }
  return true;
}

using Face = std::array<int, 4>;

/// The nodes of face f of a cell; -1: no fourth.
Face face_of(const CellMesh& mesh, std::size_t cell, std::size_t f) {
  Face face{-1, -1, -1, -1};
  for (std::size_t k = 0; k < face.size(); ++k) {
    const int local = mesh.type->face[f][k];
    if (local >= 0) face[k] = mesh[cell][slot_of(local)];
  }
  return face;
}

/// Sorted nodes of a thing and what it is, in lists by the least node.
template <std::size_t n>
struct Keyed {
  std::array<int, n> key;
  int index;
};

/// Calls use(range) for all that have the same key, in the order of their least nodes.
template <std::size_t n, class Use>
void for_equal(std::vector<Keyed<n>> all, std::size_t n_nodes, const Use& use) {
  // By the least node in one pass; few are of one.
  std::vector<std::size_t> start(n_nodes + 1, 0);
  const auto least = [](const Keyed<n>& one) {
    return slot_of(
        *std::find_if(one.key.begin(), one.key.end(), [](int node) { return node >= 0; }));
  };
  for (const auto& one : all) ++start[least(one) + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<Keyed<n>> sorted(all.size());
  std::vector<std::size_t> next(start.begin(), start.end() - 1);
  for (const auto& one : all) sorted[next[least(one)]++] = one;
  for (std::size_t node = 0; node < n_nodes; ++node) {
    const std::span<Keyed<n>> list(sorted.data() + start[node], start[node + 1] - start[node]);
    std::sort(list.begin(), list.end(), [](const auto& a, const auto& b) {
      return a.key != b.key ? a.key < b.key : a.index < b.index;
    });
    for (std::size_t from = 0; from < list.size();) {
      std::size_t to = from;
      while (to < list.size() && list[to].key == list[from].key) ++to;
      use(list.subspan(from, to - from));
      from = to;
    }
  }
}

/// All faces, index = cell * faces + face.
std::vector<Keyed<4>> all_faces(const CellMesh& mesh) {
  std::vector<Keyed<4>> faces;
  const auto per_cell = slot_of(mesh.type->faces);
  faces.reserve(mesh.size() * per_cell);
  for (std::size_t cell = 0; cell < mesh.size(); ++cell) {
    for (std::size_t f = 0; f < per_cell; ++f) {
      Face face = face_of(mesh, cell, f);
      std::sort(face.begin(), face.end());
      faces.push_back({face, static_cast<int>(cell * per_cell + f)});
    }
  }
  return faces;
}

/// Sets that grow together.
class Components {
 public:
  explicit Components(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }
  int root(int i) {
    while (parent_[slot_of(i)] != i) {
      int& up = parent_[slot_of(i)];
      up = parent_[slot_of(up)];
      i = up;
    }
    return i;
  }
  void join(int a, int b) {
    a = root(a), b = root(b);
    parent_[slot_of(std::max(a, b))] = std::min(a, b);
  }

 private:
  std::vector<int> parent_;
};

/// Nodes about which cells are joined by no chain of faces. across[cell * faces + face]: the cell
/// behind it, -1: none.
std::vector<int> find_hinges(const CellMesh& mesh, const std::vector<int>& across) {
  const auto per_cell = slot_of(mesh.type->faces);
  const auto corners = slot_of(mesh.type->corners);
  std::vector<std::size_t> start(mesh.nodes.size() + 1, 0);
  for (const int node : mesh.corner) ++start[slot_of(node) + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<int> about(mesh.corner.size());
  std::vector<std::size_t> next(start.begin(), start.end() - 1);
  for (std::size_t i = 0; i < mesh.corner.size(); ++i) {
    about[next[slot_of(mesh.corner[i])]++] = static_cast<int>(i / corners);
  }
  std::vector<int> hinges;
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node) {
    const std::span<const int> cells(about.data() + start[node], start[node + 1] - start[node]);
    if (cells.size() < 2) continue;
    Components joined(cells.size());
    std::size_t separate = cells.size();
    for (std::size_t k = 0; k < cells.size() && separate > 1; ++k) {
      const auto cell = slot_of(cells[k]);
      for (std::size_t f = 0; f < per_cell; ++f) {
        const int other = across[cell * per_cell + f];
        if (other < cells[k]) continue;  // joined from there, or none
        const Face face = face_of(mesh, cell, f);
        if (std::find(face.begin(), face.end(), static_cast<int>(node)) == face.end()) continue;
        const auto found = std::lower_bound(cells.begin(), cells.end(), other);
        const int a = joined.root(static_cast<int>(k));
        const int b = joined.root(static_cast<int>(found - cells.begin()));
        if (a != b) joined.join(a, b), --separate;
      }
    }
    if (separate > 1) hinges.push_back(static_cast<int>(node));
  }
  return hinges;
}

void find_components(const CellMesh& mesh, CellFindings& findings) {
  Components joined(mesh.nodes.size());
  for (std::size_t cell = 0; cell < mesh.size(); ++cell) {
    for (const int node : mesh[cell]) joined.join(mesh[cell][0], node);
  }
  std::vector<int> number(mesh.nodes.size(), -1);
  for (std::size_t cell = 0; cell < mesh.size(); ++cell) {
    int& place = number[slot_of(joined.root(mesh[cell][0]))];
    if (place < 0) place = findings.n_components++;
    findings.component.push_back(place);
  }
}

void find_repeated(const CellMesh& mesh, CellFindings& findings) {
  std::vector<Keyed<kMostCorners>> cells;
  for (std::size_t cell = 0; cell < mesh.size(); ++cell) {
    Keyed<kMostCorners> one{};
    one.key.fill(-1);
    std::copy(mesh[cell].begin(), mesh[cell].end(), one.key.begin());
    std::sort(one.key.begin(), one.key.end());
    one.index = static_cast<int>(cell);
    cells.push_back(one);
  }
  for_equal(std::move(cells), mesh.nodes.size(), [&](auto same) {
    for (std::size_t k = 1; k < same.size(); ++k) {
      findings.repeated.push_back({same[0].index, same[k].index});
    }
  });
}
}  // namespace

CellFindings check_cells(const CellMesh& mesh) {
  CellFindings findings;
  const auto corners = corner_edges(*mesh.type);
  for (std::size_t cell = 0; cell < mesh.size(); ++cell) {
    std::array<int, kMostCorners> nodes{};
    const auto last = std::copy(mesh[cell].begin(), mesh[cell].end(), nodes.begin());
    std::sort(nodes.begin(), last);
    if (std::adjacent_find(nodes.begin(), last) != last) {
      findings.collapsed.push_back(static_cast<int>(cell));
    } else if (!is_convex(mesh, cell, corners)) {
      findings.inverted.push_back(static_cast<int>(cell));
    }
  }
  find_repeated(mesh, findings);
  if (!findings.sound()) return findings;
  const auto per_cell = slot_of(mesh.type->faces);
  std::vector<int> across(mesh.size() * per_cell, -1);
  for_equal(all_faces(mesh), mesh.nodes.size(), [&](auto same) {
    const auto cell = [&](std::size_t k) { return same[k].index / mesh.type->faces; };
    if (same.size() > 2) findings.crowded.push_back({cell(0), cell(1), cell(2)});
    if (same.size() != 2) return;
    across[slot_of(same[0].index)] = cell(1);
    across[slot_of(same[1].index)] = cell(0);
  });
  if (!findings.sound()) return findings;
  findings.hinges = find_hinges(mesh, across);
  find_components(mesh, findings);
  return findings;
}

std::vector<std::array<int, 2>> coincident_nodes(const std::vector<Vec3>& nodes) {
  std::vector<std::array<int, 2>> pairs;
  if (nodes.empty()) return pairs;
  Vec3 low = nodes[0], high = nodes[0];
  for (const Vec3& x : nodes) low = low.cwiseMin(x), high = high.cwiseMax(x);
  const Real near = 1e-9 * (high - low).maxCoeff();
  std::vector<int> order(nodes.size());
  std::iota(order.begin(), order.end(), 0);
  const auto at = [&](int i) -> const Vec3& { return nodes[slot_of(i)]; };
  // Along an axis that few nodes share: neighbours of a plane of nodes are many.
  const Vec3 along = Vec3(0.5412, 0.6314, 0.5555);
  std::vector<Real> place(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) place[i] = along.dot(nodes[i] - low);
  const auto place_of = [&](int i) { return place[slot_of(i)]; };
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    return place_of(a) != place_of(b) ? place_of(a) < place_of(b) : a < b;
  });
  std::vector<bool> taken(nodes.size(), false);
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (taken[slot_of(order[k])]) continue;
    for (std::size_t m = k + 1;
         m < order.size() && place_of(order[m]) - place_of(order[k]) <= 2 * near; ++m) {
      if ((at(order[m]) - at(order[k])).cwiseAbs().maxCoeff() > near) continue;
      taken[slot_of(order[m])] = true;
      pairs.push_back({std::min(order[k], order[m]), std::max(order[k], order[m])});
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

Real shortest_edge(const CellMesh& mesh) {
  Real square = kInfinity;
  for (std::size_t cell = 0; cell < mesh.size(); ++cell) {
    for (std::size_t f = 0; f < slot_of(mesh.type->faces); ++f) {
      const Face face = face_of(mesh, cell, f);
      const auto n =
          slot_of(std::count_if(face.begin(), face.end(), [](int node) { return node >= 0; }));
      for (std::size_t k = 0; k < n; ++k) {
        const Vec3& a = mesh.nodes[slot_of(face[k])];
        const Vec3& b = mesh.nodes[slot_of(face[(k + 1) % n])];
        square = std::min(square, (b - a).squaredNorm());
      }
    }
  }
  return square < kInfinity ? std::sqrt(square) : 0;
}

std::vector<std::array<int, 4>> outer_faces(const CellMesh& mesh) {
  const auto per_cell = slot_of(mesh.type->faces);
  std::vector<bool> outer(mesh.size() * per_cell, false);
  for_equal(all_faces(mesh), mesh.nodes.size(), [&](auto same) {
    if (same.size() == 1) outer[slot_of(same[0].index)] = true;
  });
  std::vector<std::array<int, 4>> faces;
  for (std::size_t i = 0; i < outer.size(); ++i) {
    if (outer[i]) faces.push_back(face_of(mesh, i / per_cell, i % per_cell));
  }
  return faces;
}

}  // namespace brunt
