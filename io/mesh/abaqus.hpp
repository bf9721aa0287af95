#pragma once
#include "io/mesh/mesh_file.hpp"

namespace brunt {

/// Reads nodes, elements and sets of an Abaqus input file: *NODE (SYSTEM=R or C), *ELEMENT, *NSET,
/// *ELSET (lists, other sets, GENERATE) and *SURFACE of elements or nodes, whose nodes are a set.
/// Names are the same in any case of letters, unless in quotes. Elements without ELSET belong to
/// the whole file alone. Masses, springs and their like are points, with a note; elements of a type
/// that is not known are `other`. What makes, moves or changes nodes and elements in other ways
/// (*INCLUDE, INPUT=, *NGEN, several parts, ...) is refused, and so are sets of sets that are
/// nowhere; all else (steps, materials) is passed over. Throws std::runtime_error with file:line.
///   Abaqus keywords reference guide; element libraries of its analysis user's guide
MeshFile read_abaqus(const std::string& path);

}  // namespace brunt
