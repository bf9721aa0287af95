#pragma once
/// What stands at planes of symmetry.
#include <vector>

#include "app/deck/deck.hpp"
#include "app/scene/scene.hpp"
#include "app/setup/suspicious.hpp"

namespace brunt {

/// Bodies on both sides of a plane, and planes that are none.
template <int Dim>
void check_planes(const LoadedDeck& loaded, const Scene<Dim>& scene,
                  std::vector<DeckProblem>& problems);

/// Planes at which no body ends, or nearly, and gravity across them.
/// boxes  of bodies
template <int Dim>
void warn_of_planes(const LoadedDeck& loaded, const Scene<Dim>& scene,
                    const std::vector<BodyBox<Dim>>& boxes, const Warn& warn);

}  // namespace brunt
// Tested by tests/unit/app/mirrors_test.cpp.
