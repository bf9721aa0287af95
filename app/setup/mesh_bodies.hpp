#pragma once
/// Bodies from mesh files.
#include <map>
#include <memory>

#include "app/setup/bodies.hpp"
#include "io/mesh/mesh_file.hpp"
#include "io/stl.hpp"

namespace brunt {

/// The mesh files of a deck, each read once.
class MeshFiles {
 public:
  /// Throws std::runtime_error as the reader of its format does.
  const MeshFile& read(const std::string& path);

 private:
  std::map<std::string, std::unique_ptr<MeshFile>> files_;
};

/// Takes the elements of a body's part of a mesh: points as they lie at time 0, elements, pieces
/// (what shares no node is a piece of its own), and the nodes of the file's sets. Throws
/// std::invalid_argument with the element or node that is wrong, and what would do.
/// piece  of each element, from 0
template <int Dim>
void take_mesh_elements(const deck::Body& body, const MeshFile& mesh, int max_cells,
                        BodyGeometry<Dim>& geometry, std::vector<Label>& piece);

/// The same of a rigid body: the outer faces of its solid elements, or else its faces themselves.
template <int Dim>
void take_mesh_facets(const deck::Body& body, const MeshFile& mesh, BodyGeometry<Dim>& geometry);

/// Turns closed surfaces that face inwards, which nothing outside would touch; notes say so.
/// nodes  [m];  faces  of three corners and -1, or of four
void face_outward(const std::vector<Vec3>& nodes, std::vector<std::array<int, 4>>& faces,
                  std::vector<std::string>& notes);

/// The closed surface of a part, as particles fill it, scaled, in the axes of the file.
StlSurface mesh_surface(const deck::Body& body, const MeshFile& mesh);

}  // namespace brunt
