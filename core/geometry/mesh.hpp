#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/elements/box_element.hpp"
#include "core/geometry/closed_surface.hpp"
#include "core/geometry/grading.hpp"
#include "core/geometry/shape.hpp"
#include "core/surface.hpp"

namespace brunt {

/// Elements of one body, absolute coordinates: hexes or quads with positive volumes.
template <int Dim>
struct Mesh {
  std::vector<Vec<Dim>> nodes;  ///< [m]
  std::vector<std::array<int, Shape<Dim>::kCorners>> elements;
  std::vector<Label> piece;              ///< of each element, from 0
  std::vector<std::string> piece_names;  ///< "" for the one piece of a plain body
};

/// Facets of one rigid body, normals outward; the fourth node of a triangle is -1.
template <int Dim>
struct FacetMesh {
  std::vector<Vec<Dim>> nodes;  ///< [m]
  std::vector<std::array<int, Facet<Dim>::kNodes>> facets;
  std::vector<Label> piece;              ///< of each facet, from 0; a brick has its own
  std::vector<std::string> piece_names;  ///< "" for the one piece of a plain body
};

/// Particles of one body.
template <int Dim>
struct Filling {
  std::vector<Vec<Dim>> points;  ///< [m] centres
  std::vector<Label> piece;
  std::vector<std::string> piece_names;
  Real volume = 0;        ///< [m^Dim] of the shape itself, so that the mass can be exact
  std::size_t empty = 0;  ///< rooms of a surface in which no particle fits
};

/// Element size along each axis of the shape, or numbers of cells. Round shapes take the first for
/// their radius and the last for their axis.
struct Sizing {
  std::optional<std::vector<Real>> size;  ///< [m]: the next whole number of cells, none larger
  std::optional<std::vector<int>> cells;
  std::vector<Grading> gradings{};  ///< of elements: none twice along one axis

  /// Cells along axis c of a shape that is `length` [m] long there. Throws std::invalid_argument
  /// where neither size nor cells is given.
  int count(std::size_t c, Real length) const;
  /// The grading along an axis of the deck; null where there is none.
  const Grading* along(int axis) const;
};

enum class LatticeKind : int { cubic, hexagonal };

/// Meshes a shape that deforms. Throws std::invalid_argument with what is wrong and what would do,
/// GradingError where that is a grading.
template <int Dim>
Mesh<Dim> mesh_shape(const BodyShape& shape, const Sizing& sizing, Geometry geometry);

/// The surface of a shape that is rigid.
template <int Dim>
FacetMesh<Dim> surface_of_shape(const BodyShape& shape, const Sizing& sizing, Geometry geometry);

/// Fills a shape with particles of the given spacing [m], an axis each.
template <int Dim>
Filling<Dim> fill_shape(const BodyShape& shape, const std::vector<Real>& spacing,
                        LatticeKind lattice);

/// Fills a closed surface where it lies, by one lattice; each of its rooms is a piece, "1", "2" ...
/// where there are several. Throws std::invalid_argument where its shells overlap, and
/// where no particle fits in, or too many.
Filling<3> fill_surface(const ClosedSurface& surface, const std::vector<Real>& spacing,
                        LatticeKind lattice);

/// Outer faces of a mesh: those that exactly one element has, normals outward.
template <int Dim>
std::vector<std::array<int, Facet<Dim>::kNodes>> outer_faces(const Mesh<Dim>& mesh);

}  // namespace brunt
