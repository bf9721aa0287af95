#pragma once
#include <span>

#include "core/surface.hpp"

namespace brunt {

/// Marks the facets of every piece that has a rim, an edge (in 2D an end) of one facet alone: both
/// of its sides can be touched. Facets that share an edge share its nodes.
template <int Dim>
void mark_open(std::span<Facet<Dim>> facets);

/// Marks the edges (in 2D the ends) where the surface of a facet ends for what lies on it: no facet
/// goes on there, or one that turns away from it by more than 40 degrees.
/// x  [m] of the points, at time 0
template <int Dim>
void mark_borders(std::span<Facet<Dim>> facets, std::span<const Vec<Dim>> x);

/// Sets how sharp the body is at the corners of each facet: sin(a/2), a the smallest angle between
/// two facets that share a corner, cos a = -n1.n2; not above that of a box, nor below that of half
/// a degree.
/// x  [m] of the points, at time 0
template <int Dim>
void mark_sharpness(std::span<Facet<Dim>> facets, std::span<const Vec<Dim>> x);

}  // namespace brunt
