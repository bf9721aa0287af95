#pragma once
#include <memory>
#include <vector>

#include "app/deck/deck.hpp"
#include "app/scene/scene.hpp"
#include "core/materials/initial_stress.hpp"

namespace brunt {

/// The stress at time 0 of each body, by label; null where the deck gives it none. Bodies whose
/// material takes none become problems.
template <int Dim>
std::vector<std::unique_ptr<InitialStress>> make_initial_stress(const LoadedDeck& loaded,
                                                                const Scene<Dim>& scene,
                                                                std::vector<DeckProblem>& problems);

/// What a material says against its stress, at the key of its body.
DeckProblem problem_of(const LoadedDeck& loaded, const InitialStressError& error);

}  // namespace brunt
