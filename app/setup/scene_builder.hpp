#pragma once
#include <memory>

#include "app/deck/deck.hpp"
#include "app/scene/scene.hpp"

namespace brunt {

/// Builds what the deck describes. Throws DeckError with all that does not fit together.
template <int Dim>
std::unique_ptr<Scene<Dim>> build_scene(const LoadedDeck& loaded);

}  // namespace brunt
