#pragma once
#include <vector>

#include "app/deck/deck.hpp"
#include "app/scene/scene.hpp"

namespace brunt {

/// Finds what the deck's probes are nearest to and which groups its sections cut, in a whole scene
/// at time 0; problems are collected, not thrown.
template <int Dim>
void add_watches(const LoadedDeck& loaded, Scene<Dim>& scene, std::vector<DeckProblem>& problems);

}  // namespace brunt
