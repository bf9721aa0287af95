#pragma once
#include <span>

#include "core/surface.hpp"

namespace brunt {

/// Gives the facets of closed rigid bodies `half_thickness`: from places on each a ray goes
/// inwards, and where it first leaves the body, t behind, through a facet of the opposite normal
/// within 30 degrees, the points as far from one as from the other are t c/(1 + c) behind it, c the
/// cosine between them. Of the facet the least; sharper edges than that are no plates.
/// x     [m] of the points, at time 0
/// most  [m] thicker halves do not matter, and are taken as infinite; > 0
template <int Dim>
void find_half_thickness(std::span<const Vec<Dim>> x, Real most, std::span<Facet<Dim>> facets);

}  // namespace brunt
