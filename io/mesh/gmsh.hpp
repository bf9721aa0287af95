#pragma once
#include "io/mesh/mesh_file.hpp"

namespace brunt {

/// Reads a mesh of Gmsh, file format 2.2 or 4.1, ASCII or binary. Physical groups are its sets; one
/// without a name is called by its dimension and number: "volume 3". A mesh cut into partitions is
/// refused. Throws std::runtime_error with file:line.
///   Gmsh reference manual, "MSH file format" and "MSH file format version 2"
MeshFile read_gmsh(const std::string& path);

}  // namespace brunt
