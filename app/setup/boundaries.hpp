#pragma once
#include <vector>

#include "app/deck/deck.hpp"
#include "app/scene/scene.hpp"

namespace brunt {

/// Turns the deck's boundaries, gravity and damping into supports and loads of a scene whose
/// groups exist; problems are collected.
template <int Dim>
void add_boundaries(const LoadedDeck& loaded, Scene<Dim>& scene,
                    std::vector<DeckProblem>& problems);

/// Holds rigid bodies at the temperatures of their motions.
template <int Dim>
void hold_temperatures(const LoadedDeck& loaded, Scene<Dim>& scene);

}  // namespace brunt
