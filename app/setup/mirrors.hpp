#pragma once
/// Planes of symmetry of particles, as the deck's `symmetry` has them.
#include <vector>

#include "app/deck/deck.hpp"
#include "app/scene/scene.hpp"
#include "sph/mirrors.hpp"

namespace brunt {

/// The planes across which the sums of particles are reflected: those that a particle of the sum
/// has within three quarters of a spacing at time 0.
/// points  particles with positions from the scene's origin, bodies and pieces
/// spacing  [m] by body, the longest of its lattice
/// sums  by piece, the label of its sum
/// Throws DeckError where a body lies on both sides of a plane, or particles on it.
template <int Dim>
Mirrors<Dim> mirrors_of(const LoadedDeck& loaded, const Scene<Dim>& scene,
                        const Points<Dim>& points, const std::vector<Real>& spacing,
                        const std::vector<Label>& sums);

}  // namespace brunt
// Tested by tests/unit/app/mirrors_test.cpp.
