#pragma once
#include "io/mesh/mesh_file.hpp"

namespace brunt {

/// Reads nodes, elements, parts and sets of an LS-DYNA keyword file: *NODE, *ELEMENT_SOLID, _SHELL
/// and _BEAM, *PART, *SET_NODE, _SOLID, _SHELL, _PART and _SEGMENT (whose nodes are a set), each
/// _LIST, _GENERATE and _TITLE, in columns or between commas, in the standard or the I10 format
/// (%). Parts are sets of their elements, called by their titles, or "part 3"; sets so by theirs,
/// or "set_node 7". Solids with repeated corners are the tetrahedra, pyramids and wedges that they
/// stand for. Keywords that change or add nodes and elements (*INCLUDE, ...) are refused; all else
/// is passed over. Throws std::runtime_error with file:line.
///   LS-DYNA keyword user's manual, vol. I
MeshFile read_ls_dyna(const std::string& path);

}  // namespace brunt
