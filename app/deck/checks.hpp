#pragma once
#include <vector>

#include "app/deck/deck.hpp"

namespace brunt::deck {

/// What must fit together across a deck: names of bodies and materials, pairs, axes, meshes.
void check_references(const Deck& deck, const DeckPlaces& places,
                      std::vector<DeckProblem>& problems, std::vector<DeckProblem>& warnings);

}  // namespace brunt::deck
