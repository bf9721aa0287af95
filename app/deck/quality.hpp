#pragma once
#include <array>

#include "core/types.hpp"
#include "fe/options.hpp"

namespace brunt {
struct Deck;
struct Node;
}  // namespace brunt

namespace brunt::deck {

struct Body;

enum class Quality : int { quick, standard, careful };
inline constexpr std::array<const char*, 3> kQualities{"quick", "default", "careful"};

/// What `quality` sets in keys that a deck leaves out. What each row costs and buys on shipped
/// decks is measured in docs/trade.md; sizes of elements are the deck's own.
struct Levers {
  Real contact_stiffness;   ///< contact.default.stiffness
  Integration integration;  ///< element.integration
  Real smoothing;           ///< smoothing of particles
};
const Levers& levers_of(Quality quality);

/// The quality of a deck, read before anything else of it; `standard` where it says
/// nothing, or nothing that is known.
Quality quality_of(const Node& root);
/// A deck that says nothing but its quality.
Deck deck_of(Quality quality);
/// A body that says nothing, in a deck of that quality.
Body body_of(Quality quality);

}  // namespace brunt::deck
