#pragma once
#include "io/mesh/mesh_file.hpp"

namespace brunt {

/// Reads nodes, elements and sets of an Abaqus input file: *NODE, *ELEMENT, *NSET, *ELSET (lists,
/// other sets, GENERATE) and *SURFACE of elements, whose nodes are a set. Elements without ELSET
/// belong to the whole file alone. What makes nodes and elements in other ways (*INCLUDE, *NGEN,
/// several parts, ...) is refused; all else (steps, materials) is passed over. Throws
/// std::runtime_error with file:line.
///   Abaqus keywords reference guide; element libraries of its analysis user's guide
MeshFile read_abaqus(const std::string& path);

}  // namespace brunt
