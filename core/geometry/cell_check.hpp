#pragma once
#include <array>
#include <span>
#include <vector>

#include "core/elements/element_type.hpp"

namespace brunt {

/// Cells of one kind that share nodes, as a mesh file brings them.
struct CellMesh {
  const ElementType* type = nullptr;
  std::vector<Vec3> nodes;  ///< [m]; in 2D z is not read
  std::vector<int> corner;  ///< nodes of each cell, one after another

  std::size_t size() const { return corner.size() / n(); }
  std::span<const int> operator[](std::size_t cell) const { return {&corner[cell * n()], n()}; }

 private:
  std::size_t n() const { return slot_of(type->corners); }
};

/// What elements cannot be made of, by cells and nodes.
struct CellFindings {
  std::vector<int> collapsed;  ///< cells that have a node twice
  /// Cells with a corner whose edges span no volume, or a negative one: flat, folded, inverted.
  std::vector<int> inverted;
  std::vector<std::array<int, 2>> repeated;  ///< pairs of cells that have the same nodes
  std::vector<std::array<int, 3>> crowded;   ///< cells of which three share a face
  /// Nodes at which cells touch that no chain of faces around the node joins. Not wrong: a hinge.
  std::vector<int> hinges;
  std::vector<int> component;  ///< of each cell; cells of one are joined by nodes
  int n_components = 0;

  bool sound() const {
    return collapsed.empty() && inverted.empty() && repeated.empty() && crowded.empty();
  }
};

/// Looks all cells over. Hinges and components are found only where the rest is sound.
CellFindings check_cells(const CellMesh& mesh);

/// Pairs of nodes at one place (to 1e-9 of the extent of all), the first of each pair the first of
/// the place: what meshers leave where parts were not merged.
std::vector<std::array<int, 2>> coincident_nodes(const std::vector<Vec3>& nodes);

/// The shortest edge of all cells [m]; 0: there is none.
Real shortest_edge(const CellMesh& mesh);

/// Faces that exactly one cell has, by their corners (-1: none), normals outwards.
std::vector<std::array<int, 4>> outer_faces(const CellMesh& mesh);

}  // namespace brunt
