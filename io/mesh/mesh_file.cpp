#include "io/mesh/mesh_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <stdexcept>

namespace brunt {

namespace {
constexpr std::array<CellKindInfo, 12> kCellKinds = {{{"points", 0, 1},
                                                      {"lines (beams)", 1, 2},
                                                      {"lines of higher order", 1, 0},
                                                      {"triangles", 2, 3},
                                                      {"quadrilaterals", 2, 4},
                                                      {"faces of higher order", 2, 0},
                                                      {"tetrahedra", 3, 4},
                                                      {"pyramids", 3, 5},
                                                      {"wedges", 3, 6},
                                                      {"hexahedra", 3, 8},
                                                      {"solids of higher order", 3, 0},
                                                      {"elements of no known kind", 3, 0}}};

std::string named(const char* what, std::int64_t id, const MeshFile& mesh, int line) {
  const std::string text = std::string(what) + " " + std::to_string(id);
  return line == 0 ? text : text + " (" + mesh.place(line) + ")";
}
}  // namespace

const CellKindInfo& info(CellKind kind) { return kCellKinds[slot_of(kind)]; }

void MeshFile::add_node(std::int64_t id, const Vec3& x, int line) {
  nodes.push_back(x);
  node_id.push_back(id);
  node_line.push_back(line);
}

void MeshFile::add_cell(CellKind of, std::int64_t id, std::span<const std::int64_t> corner_ids,
                        int line) {
  kind.push_back(of);
  cell_id.push_back(id);
  cell_line.push_back(line);
  const auto kept = std::min(corner_ids.size(), slot_of(info(of).corners));
  corner_id_.insert(corner_id_.end(), corner_ids.begin(),
                    corner_ids.begin() + static_cast<std::ptrdiff_t>(kept));
  first.push_back(corner_id_.size());
}

MeshSet& MeshFile::set(const std::string& name) {
  for (MeshSet& one : sets) {
    if (one.name == name) return one;
  }
  return sets.emplace_back(MeshSet{name, {}, {}});
}

const MeshSet* MeshFile::find(const std::string& name) const {
  for (const MeshSet& one : sets) {
    if (one.name == name) return &one;
  }
  return nullptr;
}

std::string MeshFile::place(int line) const {
  return std::filesystem::path(path).filename().string() + ":" + std::to_string(line);
}

std::string MeshFile::cell_name(std::size_t cell) const {
  std::string name =
      named("element", cell_id[cell], *this, cell_line.empty() ? 0 : cell_line[cell]);
  if (kind[cell] != CellKind::other) return name;
  std::string type;
  for (const auto& [from, of] : other_types) {
    if (from <= cell) type = of;
  }
  return name + " of TYPE=" + type;
}

std::string MeshFile::node_name(std::size_t node) const {
  return named("node", node_id[node], *this, node_line.empty() ? 0 : node_line[node]);
}

void MeshFile::resolve_corners() {
  const IdTable table(node_id);
  const auto wrong = [&](const std::string& what) { throw std::runtime_error(path + ": " + what); };
  if (const int again = table.repeated(); again >= 0) {
    wrong(node_name(slot_of(again)) + " has the number of another node");
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!nodes[i].allFinite()) wrong(node_name(i) + " has a coordinate that is no number");
  }
  corner.resize(corner_id_.size());
  for (std::size_t cell = 0; cell < n_cells(); ++cell) {
    for (std::size_t c = first[cell]; c < first[cell + 1]; ++c) {
      corner[c] = table[corner_id_[c]];
      if (corner[c] >= 0) continue;
      wrong(cell_name(cell) + " has node " + std::to_string(corner_id_[c]) +
            ", which is not among the nodes of the file");
    }
  }
  corner_id_ = {};
}

IdTable::IdTable(const std::vector<std::int64_t>& ids) : ids_(ids) {
  if (ids.empty()) return;
  const auto [low, high] = std::minmax_element(ids.begin(), ids.end());
  low_ = *low;
  // Unsigned: the difference of two ids of a broken file may not fit.
  const auto range = static_cast<std::uint64_t>(*high) - static_cast<std::uint64_t>(*low);
  if (range < 8 * ids.size() + 1024) {
    dense_.assign(slot_of(range) + 1, -1);
    for (std::size_t i = 0; i < ids.size(); ++i) {
      int& place = dense_[slot_of(ids[i] - low_)];
      if (place >= 0 && repeated_ < 0) repeated_ = static_cast<int>(i);
      place = static_cast<int>(i);
    }
    return;
  }
  sorted_.resize(ids.size());
  std::iota(sorted_.begin(), sorted_.end(), 0);
  const auto id_at = [&](int i) { return ids[slot_of(i)]; };
  std::stable_sort(sorted_.begin(), sorted_.end(),
                   [&](int a, int b) { return id_at(a) < id_at(b); });
  for (std::size_t k = 1; k < sorted_.size() && repeated_ < 0; ++k) {
    if (id_at(sorted_[k]) == id_at(sorted_[k - 1])) repeated_ = sorted_[k];
  }
}

int IdTable::operator[](std::int64_t id) const {
  if (!dense_.empty()) {
    const auto at = static_cast<std::uint64_t>(id) - static_cast<std::uint64_t>(low_);
    return at < dense_.size() ? dense_[slot_of(at)] : -1;
  }
  const auto found =
      std::lower_bound(sorted_.begin(), sorted_.end(), id,
                       [&](int i, std::int64_t wanted) { return ids_[slot_of(i)] < wanted; });
  if (found == sorted_.end() || ids_[slot_of(*found)] != id) return -1;
  return *found;
}

std::string set_list(const MeshFile& mesh) {
  constexpr std::size_t kMost = 12;
  std::string text;
  for (std::size_t s = 0; s < std::min(kMost, mesh.sets.size()); ++s) {
    const MeshSet& set = mesh.sets[s];
    text += (s == 0 ? "'" : ", '") + set.name + "' (";
    std::array<std::size_t, kCellKinds.size()> count{};
    for (const int cell : set.cells) {
      ++count[slot_of(mesh.kind[slot_of(cell)])];
    }
    std::string held;
    for (std::size_t k = 0; k < count.size(); ++k) {
      if (count[k] == 0) continue;
      held += (held.empty() ? "" : ", ") + std::to_string(count[k]) + " " + kCellKinds[k].name;
    }
    if (held.empty()) held = std::to_string(set.nodes.size()) + " nodes";
    text += held + ")";
  }
  if (mesh.sets.size() > kMost) {
    text += " and " + std::to_string(mesh.sets.size() - kMost) + " more";
  }
  if (text.empty()) text = "none";
  for (std::size_t s = 0; s < std::min(kMost, mesh.unread_sets.size()); ++s) {
    text += (s == 0 ? "; not read: " : ", ") + mesh.unread_sets[s];
  }
  return text;
}

}  // namespace brunt
// Tested by tests/unit/io/gmsh_test.cpp.
