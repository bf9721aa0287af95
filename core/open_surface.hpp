#pragma once
#include <span>

#include "core/surface.hpp"

namespace brunt {

/// Marks the facets of every piece that has a rim, an edge (in 2D an end) of one facet alone: both
/// of its sides can be touched. Facets that share an edge share its nodes.
template <int Dim>
void mark_open(std::span<Facet<Dim>> facets);

}  // namespace brunt
