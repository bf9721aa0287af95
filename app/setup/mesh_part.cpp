#include "app/setup/mesh_part.hpp"

#include <algorithm>
#include <filesystem>
#include <numeric>
#include <stdexcept>

#include "fe/elements/catalog.hpp"
#include "io/deck/suggest.hpp"

namespace brunt {

void refuse_mesh(const std::string& what) { throw std::invalid_argument(what); }

std::string part_name(const deck::Body& body) {
  const std::string file = std::filesystem::path(body.file).filename().string();
  return body.part.empty() ? file : "'" + body.part + "' of " + file;
}

std::vector<int> cells_of(const deck::Body& body, const MeshFile& mesh) {
  if (body.part.empty()) {
    std::vector<int> all(mesh.n_cells());
    std::iota(all.begin(), all.end(), 0);
    return all;
  }
  const MeshSet* set = mesh.find(body.part);
  if (!set) {
    std::vector<std::string> names;
    for (const MeshSet& one : mesh.sets) names.push_back(one.name);
    const std::string near = nearest_word(body.part, names);
    refuse_mesh(part_name(body) + " is not there" +
                (near.empty() ? "" : "; did you mean '" + near + "'?") +
                " The sets of the file are: " + set_list(mesh));
  }
  if (set->cells.empty()) {
    refuse_mesh(part_name(body) +
                " is a set of nodes; a body is made of elements. The sets are: " + set_list(mesh));
  }
  std::vector<int> cells = set->cells;
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  return cells;
}

std::string instead_of(CellKind kind, int dim) {
  using enum CellKind;
  switch (kind) {
    case point1:
    case line2:
      return "beams and points are not in this version: mesh the body itself";
    case higher1:
    case higher2:
    case higher3:
      return "write first order (Gmsh: Mesh.ElementOrder = 1), with nodes at corners";
    case tri3:
      return dim == 2 ? "elements in two dimensions have four corners: recombine the triangles "
                        "(Gmsh: Mesh.RecombineAll = 1, Mesh.SubdivisionAlgorithm = 1)"
                      : "shells are not in this version: mesh the volume, or take them as a "
                        "surface with rigid: true";
    case quad4:
      return "shells are not in this version: mesh the volume, or take them as a surface with "
             "rigid: true; in geometry: plane-strain or axisymmetric they are elements";
    case tet4:
    case hex8:
      return "these are elements of geometry: 3d";
    case pyramid5:
    case wedge6:
      return "mesh it with hexahedra alone, or with tetrahedra alone";
    case other:
      return "take a `part` without them, or leave them out of the file";
  }
  return "";
}

namespace {
bool is_element(CellKind kind, int dim) {
  return info(kind).dim == dim && element_type(dim, info(kind).corners) != nullptr;
}
}  // namespace

std::vector<int> elements_among(const deck::Body& body, const MeshFile& mesh,
                                const std::vector<int>& cells, int dim) {
  std::vector<int> chosen;
  const auto kind = [&](int cell) { return mesh.kind[slot_of(cell)]; };
  const auto refuse = [&](int cell) {
    refuse_mesh(part_name(body) + " has " + info(kind(cell)).name + ", as " +
                mesh.cell_name(slot_of(cell)) + ": " + instead_of(kind(cell), dim));
  };
  // They may be solids: to leave them out would leave a hole.
  for (const int cell : cells) {
    if (kind(cell) == CellKind::other) refuse(cell);
  }
  for (const int cell : cells) {
    if (info(kind(cell)).dim == dim) chosen.push_back(cell);
  }
  if (chosen.empty()) {
    const int first = cells.front();  // a file has an element, and so has a set of elements
    const int highest = *std::max_element(cells.begin(), cells.end(), [&](int a, int b) {
      return info(kind(a)).dim < info(kind(b)).dim;
    });
    const CellKind found = kind(cells.empty() ? first : highest);
    refuse_mesh(part_name(body) + " has " + info(found).name + ": " + instead_of(found, dim));
  }
  for (const int cell : chosen) {
    if (!is_element(kind(cell), dim)) refuse(cell);
    if (kind(cell) != kind(chosen.front())) {
      refuse_mesh(part_name(body) + " has " + info(kind(chosen.front())).name + " and " +
                  info(kind(cell)).name + ", as " + mesh.cell_name(slot_of(cell)) +
                  ": a body has elements of one kind; make two bodies of two sets");
    }
  }
  return chosen;
}

}  // namespace brunt
// Tested by tests/unit/app/mesh_bodies_test.cpp.
