#pragma once
#include <string>
#include <vector>

#include "app/deck/deck.hpp"
#include "core/elements/element_type.hpp"
#include "core/surface.hpp"

namespace brunt {

/// Elements of one kind.
struct BodyElements {
  const ElementType* type = nullptr;  ///< null: there are none
  std::vector<int> corner;            ///< points of each element, one after another

  std::size_t size() const { return type ? corner.size() / n() : 0; }
  std::span<const int> operator[](std::size_t e) const { return {&corner[e * n()], n()}; }

 private:
  std::size_t n() const { return slot_of(type->corners); }
};

/// Points of a body by the name that its mesh file gives them.
struct NamedPoints {
  std::string name;
  std::vector<int> points;  ///< of the body, ascending
};

/// The geometry of one named body, absolute coordinates, before groups are formed.
template <int Dim>
struct BodyGeometry {
  Label label = 0;
  std::vector<Vec<Dim>> points;                             ///< [m] nodes or particles
  BodyElements elements;                                    ///< FE that deforms
  std::vector<std::array<int, Facet<Dim>::kNodes>> facets;  ///< rigid; -1: no fourth node
  std::vector<Label> piece;                                 ///< of each element, particle or facet
  std::vector<std::string> piece_names;                     ///< at least one
  std::vector<Real> spacing;                                ///< [m] particles: one an axis
  Real volume = 0;                 ///< [m^Dim] of the shape: particles' mass is exact
  std::size_t left_out = 0;        ///< triangles without area in the file
  Real shortest_edge = 0;          ///< [m] of elements from a file; elsewhere 0
  std::vector<NamedPoints> sets;   ///< of a mesh file
  std::vector<std::string> notes;  ///< for the log

  /// Gives the room of points, elements and pieces back, once a group has its own.
  void forget_mesh() { points = {}, elements.corner = {}, piece = {}; }
};

/// Meshes or fills every body of the deck; problems are collected, not thrown.
template <int Dim>
std::vector<BodyGeometry<Dim>> make_bodies(const LoadedDeck& loaded,
                                           std::vector<DeckProblem>& problems);

}  // namespace brunt
