#pragma once
/// Free rigid bodies at planes of symmetry.
#include <span>
#include <string>

#include "app/deck/deck.hpp"
#include "core/rigid/free_bodies.hpp"

namespace brunt {

/// Holds a free body that ends at a plane of symmetry on it: as its mirror image would, it neither
/// moves across the plane nor turns but about its normal.
/// points, facets  of the body;  origin  [m] of positions
/// made  its freedom, inertia and motion at time 0; in out
/// Returns what is wrong, "": nothing.
template <int Dim>
std::string hold_on_plane(const Points<Dim>& points, std::span<const Facet<Dim>> facets, int axis,
                          Real at, FreeBody<Dim>& made);

}  // namespace brunt
// Tested by tests/verification/rigid_symmetry_test.cpp.
