#pragma once
#include "core/surface.hpp"
#include "fe/element_block.hpp"

namespace brunt {

/// Faces that exactly one element has, by ascending id, with stiffness, areal mass and depth of
/// that element. Edges between nodes on the axis are no surface and are left out.
/// axis  nodes on the axis of an axisymmetric scene, ascending
template <int Dim>
std::vector<Facet<Dim>> outer_facets(const std::vector<ElementBlock<Dim>>& blocks,
                                     const Points<Dim>& points,
                                     const std::vector<LocalIndex>& axis);

}  // namespace brunt
