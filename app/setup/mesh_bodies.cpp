#include "app/setup/mesh_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <stdexcept>

#include "app/deck/findings.hpp"
#include "app/setup/mesh_part.hpp"
#include "core/geometry/cell_check.hpp"
#include "core/geometry/one_side.hpp"
#include "core/geometry/placement.hpp"
#include "io/mesh/catalog.hpp"

namespace brunt {

const MeshFile& MeshFiles::read(const std::string& path) {
  auto& file = files_[path];
  if (!file) file = std::make_unique<MeshFile>(mesh_reader(path)->read(path));
  return *file;
}

namespace {
/// The nodes that some cells have, scaled, and the cells over them. Nodes keep the file's order.
struct Taken {
  CellMesh cells;
  std::vector<int> node;  ///< of the file
  std::vector<int> cell;  ///< of the file
};

Taken take_cells(const deck::Body& body, const MeshFile& mesh, std::vector<int> cells) {
  Taken taken;
  std::vector<int> place(mesh.nodes.size(), -1);
  for (const int cell : cells) {
    for (const int node : mesh.corners(slot_of(cell))) {
      place[slot_of(node)] = 0;
    }
  }
  for (std::size_t node = 0; node < place.size(); ++node) {
    if (place[node] < 0) continue;
    place[node] = static_cast<int>(taken.node.size());
    taken.node.push_back(static_cast<int>(node));
    taken.cells.nodes.push_back(body.scale * mesh.nodes[node]);
  }
  for (const int cell : cells) {
    for (const int node : mesh.corners(slot_of(cell))) {
      taken.cells.corner.push_back(place[slot_of(node)]);
    }
  }
  taken.cell = std::move(cells);
  return taken;
}

/// In two dimensions all nodes lie at one z, and elements may run round either way.
void flatten(const MeshFile& mesh, Taken& taken) {
  const auto& nodes = taken.cells.nodes;
  Real extent = 0;
  for (const Vec3& x : nodes) extent = std::max(extent, (x - nodes[0]).cwiseAbs().maxCoeff());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (std::fabs(nodes[i][2] - nodes[0][2]) <= 1e-9 * extent) continue;
    refuse_mesh(mesh.node_name(slot_of(taken.node[i])) +
                " lies beside the plane of the others: a body in two dimensions lies in a plane of "
                "constant z");
  }
  for (std::size_t e = 0; e < taken.cells.corner.size() / 4; ++e) {
    int* corner = &taken.cells.corner[4 * e];
    const auto at = [&](int c) { return nodes[slot_of(corner[c])]; };
    const Vec3 a = at(2) - at(0), b = at(3) - at(1);
    if (a[0] * b[1] - a[1] * b[0] < 0) std::swap(corner[1], corner[3]);
  }
}

/// Names up to five of many cells or nodes.
template <class All, class Name>
std::string named(const All& all, const Name& name) {
  std::string text;
  const std::size_t shown = std::min<std::size_t>(5, all.size());
  for (std::size_t i = 0; i < shown; ++i) text += (i == 0 ? "" : ", ") + name(all[i]);
  if (all.size() > shown) text += " and " + std::to_string(all.size() - shown) + " more";
  return text;
}

/// Throws what is wrong with the cells, all at once; returns what is right.
CellFindings sound_cells(const deck::Body& body, const MeshFile& mesh, const Taken& taken) {
  CellFindings findings = check_cells(taken.cells);
  if (findings.sound()) return findings;
  const auto name = [&](int cell) {
    const auto in_file = taken.cell[slot_of(cell)];
    return mesh.cell_name(slot_of(in_file));
  };
  const auto group = [&](const auto& cells) {
    std::string text;
    for (const int cell : cells) text += (text.empty() ? "" : " = ") + name(cell);
    return text;
  };
  std::string wrong;
  const auto add = [&](const std::string& what) { wrong += (wrong.empty() ? "" : "; ") + what; };
  if (!findings.collapsed.empty()) {
    add("degenerate, with a node twice: " + named(findings.collapsed, name) +
        ": mesh it with hexahedra alone, or with tetrahedra alone");
  }
  if (!findings.inverted.empty()) {
    const bool all = findings.inverted.size() == taken.cells.size();
    add("flat, folded or inverted: " + named(findings.inverted, name) +
        (all ? ": all of them, the file numbers corners the other way round"
             : ": the corner where edges span no volume, or a negative one; mesh it finer there, "
               "or smooth the mesh"));
  }
  if (!findings.repeated.empty()) {
    add("duplicate: " + named(findings.repeated, group) +
        ": delete one of each, or name the set that has it as `part`");
  }
  if (!findings.crowded.empty()) {
    add("not a manifold, three elements at one face: " + named(findings.crowded, group));
  }
  refuse_mesh(part_name(body) + ": " + wrong);
}

/// What is not wrong, but seldom meant.
void add_notes(const MeshFile& mesh, const Taken& taken, const CellFindings& findings,
               std::vector<std::string>& notes) {
  const auto name = [&](int node) {
    const auto in_file = taken.node[slot_of(node)];
    return mesh.node_name(slot_of(in_file));
  };
  if (!findings.hinges.empty()) {
    notes.push_back("elements hang together at single nodes or edges, and turn about them: " +
                    named(findings.hinges, name));
  }
  const auto pairs = coincident_nodes(taken.cells.nodes);
  if (pairs.empty()) return;
  notes.push_back(std::to_string(pairs.size()) + " nodes lie in the places of others, as " +
                  name(pairs[0][1]) + " in that of " + name(pairs[0][0]) +
                  ": elements are not joined there; merge them (Gmsh: Coherence Mesh) where they "
                  "should be");
}

/// The body's points of each set of the file.
void name_points(const MeshFile& mesh, const Taken& taken, std::vector<NamedPoints>& sets) {
  std::vector<int> place(mesh.nodes.size(), -1);
  for (std::size_t i = 0; i < taken.node.size(); ++i) {
    place[slot_of(taken.node[i])] = static_cast<int>(i);
  }
  for (const MeshSet& set : mesh.sets) {
    NamedPoints named{set.name, {}};
    const auto add = [&](int node) {
      const int point = place[slot_of(node)];
      if (point >= 0) named.points.push_back(point);
    };
    for (const int node : set.nodes) add(node);
    for (const int cell : set.cells) {
      for (const int node : mesh.corners(slot_of(cell))) add(node);
    }
    std::sort(named.points.begin(), named.points.end());
    named.points.erase(std::unique(named.points.begin(), named.points.end()), named.points.end());
    if (!named.points.empty()) sets.push_back(std::move(named));
  }
}

template <int Dim>
void place_points(const deck::Body& body, const std::vector<Vec3>& nodes,
                  std::vector<Vec<Dim>>& points) {
  for (const Vec3& x : nodes) points.push_back(x.template head<Dim>());
  place_all<Dim>(body.shape, points);
}

/// Cells that are elements, checked; of `Dim`.
template <int Dim>
Taken take_elements_of(const deck::Body& body, const MeshFile& mesh, CellFindings& findings) {
  const auto cells = elements_among(body, mesh, cells_of(body, mesh), Dim);
  Taken taken = take_cells(body, mesh, cells);
  const CellKind kind = mesh.kind[slot_of(cells.front())];
  taken.cells.type = element_type(Dim, info(kind).corners);
  if constexpr (Dim == 2) flatten(mesh, taken);
  findings = sound_cells(body, mesh, taken);
  return taken;
}
}  // namespace

template <int Dim>
void take_mesh_elements(const deck::Body& body, const MeshFile& mesh, int max_cells,
                        BodyGeometry<Dim>& geometry, std::vector<Label>& piece) {
  CellFindings findings;
  const Taken taken = take_elements_of<Dim>(body, mesh, findings);
  const Formulation<Dim>& asked = formulation_of<Dim>(body.element.type);
  BodyElements& elements = geometry.elements;
  elements.type = taken.cells.type;
  if (taken.cells.type->corners == Shape<Dim>::kCorners) {
    elements.type = &asked.type();
    for (std::size_t e = 0; e < taken.cells.size(); ++e) {
      asked.cut_box(taken.cells[e], elements.corner);
      piece.resize(elements.size(), static_cast<Label>(findings.component[e]));
    }
  } else {
    elements.corner = taken.cells.corner;
    piece.assign(findings.component.begin(), findings.component.end());
  }
  if (elements.size() > slot_of(max_cells)) {
    refuse_mesh(part_name(body) + " has " + std::to_string(elements.size()) +
                " elements, more than max_cells, " + std::to_string(max_cells) +
                "; where so many are meant, raise max_cells");
  }
  place_points<Dim>(body, taken.cells.nodes, geometry.points);
  geometry.shortest_edge = shortest_edge(taken.cells);
  geometry.piece_names = {""};
  if (findings.n_components > 1) {
    geometry.piece_names.clear();
    for (int k = 1; k <= findings.n_components; ++k) {
      geometry.piece_names.push_back(std::to_string(k));
    }
  }
  add_notes(mesh, taken, findings, geometry.notes);
  name_points(mesh, taken, geometry.sets);
}

namespace {
/// The faces of a part: of its solid elements, or of a part of faces alone these themselves.
template <int Dim>
std::vector<std::array<int, 4>> faces_of(const deck::Body& body, const MeshFile& mesh,
                                         Taken& taken) {
  const auto cells = cells_of(body, mesh);
  const auto dim = [&](int cell) { return info(mesh.kind[slot_of(cell)]).dim; };
  if (std::any_of(cells.begin(), cells.end(), [&](int cell) { return dim(cell) >= Dim; })) {
    CellFindings findings;
    taken = take_elements_of<Dim>(body, mesh, findings);
    return outer_faces(taken.cells);
  }
  std::vector<int> chosen;
  for (const int cell : cells) {
    if (dim(cell) != Dim - 1) continue;
    const CellKind kind = mesh.kind[slot_of(cell)];
    if (info(kind).corners == 0) {
      refuse_mesh(part_name(body) + " has " + info(kind).name + ": " + instead_of(kind, Dim));
    }
    chosen.push_back(cell);
  }
  if (chosen.empty()) {
    refuse_mesh(part_name(body) + " has " + info(mesh.kind[slot_of(cells[0])]).name +
                ": a rigid body is made of solid elements or of the faces about it");
  }
  taken = take_cells(body, mesh, chosen);
  std::vector<std::array<int, 4>> faces;
  const int* corner = taken.cells.corner.data();
  for (const int cell : chosen) {
    const int n = info(mesh.kind[slot_of(cell)]).corners;
    std::array<int, 4> face{-1, -1, -1, -1};
    std::copy_n(corner, n, face.begin());
    faces.push_back(face);
    corner += n;
  }
  return faces;
}

std::vector<std::array<int, 3>> triangles_of(const std::vector<std::array<int, 4>>& faces) {
  std::vector<std::array<int, 3>> triangles;
  for (const auto& [a, b, c, d] : faces) {
    triangles.push_back({a, b, c});
    if (d >= 0) triangles.push_back({a, c, d});
  }
  return triangles;
}
}  // namespace

void face_outward(const std::vector<Vec3>& nodes, std::vector<std::array<int, 4>>& faces,
                  std::vector<std::string>& notes) {
  const TurnedShells shells = turn_outward(nodes, faces);
  if (shells.turned == 0) return;
  notes.push_back("closed surfaces that faced inwards, and have been turned: " +
                  std::to_string(shells.turned) + " of " + std::to_string(shells.closed));
}

template <int Dim>
void take_mesh_facets(const deck::Body& body, const MeshFile& mesh, BodyGeometry<Dim>& geometry) {
  Taken taken;
  const auto faces = faces_of<Dim>(body, mesh, taken);
  if constexpr (Dim == 3) require_one_side(taken.cells.nodes, triangles_of(faces));
  // Nodes inside carry nothing.
  std::vector<int> place(taken.cells.nodes.size(), -1);
  std::vector<Vec3> nodes;
  for (const auto& face : faces) {
    auto& facet = geometry.facets.emplace_back();
    for (std::size_t c = 0; c < facet.size(); ++c) {
      facet[c] = -1;
      if (face[c] < 0) continue;
      int& at = place[slot_of(face[c])];
      if (at < 0) {
        at = static_cast<int>(nodes.size());
        nodes.push_back(taken.cells.nodes[slot_of(face[c])]);
      }
      facet[c] = at;
    }
  }
  if constexpr (Dim == 3) face_outward(nodes, geometry.facets, geometry.notes);
  place_points<Dim>(body, nodes, geometry.points);
  geometry.piece_names = {""};
}

StlSurface mesh_surface(const deck::Body& body, const MeshFile& mesh) {
  Taken taken;
  const auto faces = faces_of<3>(body, mesh, taken);
  StlSurface surface;
  surface.triangles = triangles_of(faces);
  surface.nodes = std::move(taken.cells.nodes);
  return surface;
}

template void take_mesh_elements<2>(const deck::Body&, const MeshFile&, int, BodyGeometry<2>&,
                                    std::vector<Label>&);
template void take_mesh_elements<3>(const deck::Body&, const MeshFile&, int, BodyGeometry<3>&,
                                    std::vector<Label>&);
template void take_mesh_facets<2>(const deck::Body&, const MeshFile&, BodyGeometry<2>&);
template void take_mesh_facets<3>(const deck::Body&, const MeshFile&, BodyGeometry<3>&);

}  // namespace brunt
// Tested by tests/unit/app/mesh_bodies_test.cpp.
