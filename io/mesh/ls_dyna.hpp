#pragma once
#include "io/mesh/mesh_file.hpp"

namespace brunt {

/// Reads nodes, elements, parts and sets of an LS-DYNA keyword file: *NODE, *ELEMENT_SOLID in one
/// line or two ("(ten nodes format)"), _SHELL and _BEAM, *PART, *SET_NODE, _SOLID, _SHELL, _PART
/// and _SEGMENT (whose nodes are a set), each _LIST, _GENERATE and _TITLE, in columns or between
/// commas, in the standard, the I10 (%) or the long format (+). Parts are sets of their elements,
/// called by their titles, or "part 3"; sets so by theirs, or "set_node 7". Solids with repeated
/// corners are the tetrahedra, pyramids and wedges that they stand for. Keywords that make, move or
/// change nodes or elements in other ways (*INCLUDE, *ELEMENT_SOLID_ORTHO, ...) are refused;
/// elements without solids (*ELEMENT_MASS, ...) are passed over with a note, and all else without.
/// Throws std::runtime_error with file:line.
///   LS-DYNA keyword user's manual, vol. I
MeshFile read_ls_dyna(const std::string& path);

}  // namespace brunt
