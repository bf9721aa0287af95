#include "io/mesh/abaqus_sets.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>

#include "io/deck/suggest.hpp"
#include "io/mesh/abaqus_elements.hpp"

namespace brunt {

namespace {
using AllSets = std::map<std::string, AbaqusSet>;

/// Nodes or elements of a mesh, and the sets of them.
struct Members {
  const char* keyword;  ///< that makes such a set
  const AllSets& sets;
  const std::vector<std::int64_t>& ids;
  const IdTable table;
  const Members* elements;  ///< whose nodes sets of nodes may have; null: these are elements
};

[[noreturn]] void refuse(const MeshFile& mesh, int line, const std::string& what) {
  throw std::runtime_error(mesh.path + ":" + std::to_string(line) + ": " + what);
}

/// user  the set or surface that names it, for the message
const AbaqusSet& find(const MeshFile& mesh, const Members& members, const AbaqusSet::Use& use,
                      const std::string& user) {
  if (const auto found = members.sets.find(use.set.key); found != members.sets.end()) {
    return found->second;
  }
  std::vector<std::string> names;
  for (const auto& [key, set] : members.sets) names.push_back(set.name);
  const std::string near = nearest_word(use.set.text, names);
  std::string instead = "write that set too, or take its name out";
  if (members.elements && members.elements->sets.count(use.set.key) > 0) {
    instead = "its nodes are had by *NSET, NSET=" + user + ", ELSET=" + use.set.text;
  } else if (!near.empty()) {
    instead = "did you mean '" + near + "'? Else " + instead;
  }
  refuse(mesh, use.line,
         "'" + user + "' takes '" + use.set.text + "', and there is no " + members.keyword +
             " of that name in the file: " + instead);
}

void add_corners(const MeshFile& mesh, int cell, std::vector<int>& nodes) {
  const auto corners = mesh.corners(slot_of(cell));
  nodes.insert(nodes.end(), corners.begin(), corners.end());
}

std::vector<int> members_of(const MeshFile& mesh, const Members& members, const AbaqusSet& set);

/// Adds what a set and those that it takes have. Ids that the file has not are left out, as Abaqus
/// does.
void add(const MeshFile& mesh, const Members& members, const AbaqusSet& set,
         std::set<const AbaqusSet*>& done, std::vector<int>& list) {
  if (!done.insert(&set).second) return;
  for (const auto& [from, to, step] : set.ranges) {
    for (std::size_t i = 0; i < members.ids.size(); ++i) {
      const std::int64_t id = members.ids[i];
      if (id < from || id > to || (id - from) % step != 0) continue;
      list.push_back(static_cast<int>(i));
    }
  }
  for (const std::int64_t id : set.ids) {
    if (const int at = members.table[id]; at >= 0) list.push_back(at);
  }
  for (const AbaqusSet::Use& use : set.sets) {
    add(mesh, members, find(mesh, members, use, set.name), done, list);
  }
  for (const AbaqusSet::Use& use : set.of_elements) {
    for (const int cell :
         members_of(mesh, *members.elements, find(mesh, *members.elements, use, set.name))) {
      add_corners(mesh, cell, list);
    }
  }
}

std::vector<int> members_of(const MeshFile& mesh, const Members& members, const AbaqusSet& set) {
  std::vector<int> list;
  std::set<const AbaqusSet*> done;
  add(mesh, members, set, done, list);
  return list;
}

void add_face(const MeshFile& mesh, const Members& elements, const AbaqusSurface& surface,
              const AbaqusSurface::Face& face, std::vector<int>& nodes) {
  std::vector<int> cells;
  if (!face.set.key.empty()) {
    cells = members_of(mesh, elements, find(mesh, elements, {face.set, face.line}, surface.name));
  } else if (const int at = elements.table[face.id]; at >= 0) {
    cells.push_back(at);
  }
  for (const int cell : cells) {
    const CellKind kind = mesh.kind[slot_of(cell)];
    if (face.face == 0) {
      add_corners(mesh, cell, nodes);
      continue;
    }
    const auto corners = abaqus_face(kind, face.face);
    // Of elements that no body takes the corners are not known.
    if (corners.empty() && info(kind).corners > 0) {
      refuse(mesh, face.line,
             "'" + surface.name + "' has face S" + std::to_string(face.face) + " of " +
                 mesh.cell_name(slot_of(cell)) + ", which " + info(kind).name + " do not have");
    }
    for (const int c : corners) nodes.push_back(mesh.corners(slot_of(cell))[slot_of(c)]);
  }
}
}  // namespace

std::set<std::string> AbaqusSets::keys() const {
  std::set<std::string> keys;
  for (const auto& [key, set] : nodes_) keys.insert(key);
  for (const auto& [key, set] : elements_) keys.insert(key);
  for (const auto& [key, surface] : surfaces_) keys.insert(key);
  return keys;
}

void AbaqusSets::resolve(MeshFile& mesh) const {
  const Members elements{"*ELSET", elements_, mesh.cell_id, IdTable(mesh.cell_id), nullptr};
  const Members nodes{"*NSET", nodes_, mesh.node_id, IdTable(mesh.node_id), &elements};
  if (elements.table.repeated() >= 0) {
    throw std::runtime_error(mesh.path + ": " + mesh.cell_name(slot_of(elements.table.repeated())) +
                             " has the number of another element");
  }
  const auto append = [](const std::vector<int>& more, std::vector<int>& list) {
    list.insert(list.end(), more.begin(), more.end());
  };
  for (const auto& [key, set] : elements_) {
    append(members_of(mesh, elements, set), mesh.set(set.name).cells);
  }
  for (const auto& [key, set] : nodes_) {
    append(members_of(mesh, nodes, set), mesh.set(set.name).nodes);
  }
  for (const auto& [key, surface] : surfaces_) {
    auto& list = mesh.set(surface.name).nodes;
    append(members_of(mesh, nodes, surface.nodes), list);
    for (const auto& face : surface.faces) add_face(mesh, elements, surface, face, list);
  }
  std::erase_if(mesh.sets,
                [](const MeshSet& set) { return set.cells.empty() && set.nodes.empty(); });
  for (MeshSet& set : mesh.sets) {
    for (auto* list : {&set.cells, &set.nodes}) {
      std::sort(list->begin(), list->end());
      list->erase(std::unique(list->begin(), list->end()), list->end());
    }
  }
}

}  // namespace brunt
// Tested by tests/unit/io/abaqus_test.cpp.
