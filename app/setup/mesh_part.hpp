#pragma once
/// Which cells of a mesh file a body takes.
#include <string>
#include <vector>

#include "app/deck/bodies.hpp"
#include "io/mesh/mesh_file.hpp"

namespace brunt {

/// Throws std::invalid_argument.
[[noreturn]] void refuse_mesh(const std::string& what);

/// "'wall' of walls.msh", or the file alone.
std::string part_name(const deck::Body& body);

/// What to do about cells that no element is made of, in `dim` dimensions.
std::string instead_of(CellKind kind, int dim);

/// All cells of the body's part, ascending. Throws std::invalid_argument where there are none.
std::vector<int> cells_of(const deck::Body& body, const MeshFile& mesh);

/// Those of the cells that are of dimension `dim`. Throws std::invalid_argument where no element is
/// made of them, and where they are of two kinds.
std::vector<int> elements_among(const deck::Body& body, const MeshFile& mesh,
                                const std::vector<int>& cells, int dim);

}  // namespace brunt
// Tested by tests/unit/app/mesh_bodies_test.cpp.
