#pragma once
/// Free rigid bodies at planes of symmetry.
#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

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

/// By facet, 1: it lies in a plane across an axis at which a body ends, and is none of its surface.
/// at  [m] by axis, from the origin of the positions
template <int Dim>
std::vector<char> facets_on_planes(const Points<Dim>& points, std::span<const Facet<Dim>> facets,
                                   const std::array<std::optional<Real>, 3>& at);

}  // namespace brunt
// Tested by tests/verification/rigid_symmetry_test.cpp.
