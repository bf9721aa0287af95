#pragma once
/// The element library of Abaqus.
#include <string>
#include <vector>

#include "io/mesh/mesh_file.hpp"

namespace brunt {

/// What an element type is: brunt's kind, and how many nodes its lines have; 0: each line is one
/// element, whatever it has.
struct AbaqusType {
  CellKind kind = CellKind::hex8;
  int nodes = 8;
  bool has_no_solid = false;  ///< masses, springs, connectors, ...
};

/// C3D8R, CPS4, DC3D4, S4R, B31, ..., in capitals: a family, and its number of nodes. Masses,
/// springs and their like are points, whatever their nodes; types of no known family are `other`.
AbaqusType abaqus_type(const std::string& name);

/// Corners of face n (from 1) of an element as Abaqus numbers them; none where it has no such face.
std::vector<int> abaqus_face(CellKind kind, int face);

}  // namespace brunt
