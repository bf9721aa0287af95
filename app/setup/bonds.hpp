#pragma once
/// Which bodies touch by which options, and which particles share one SPH sum: what the deck's
/// `bonded` means.
#include "app/deck/deck.hpp"
#include "app/setup/bodies.hpp"

namespace brunt {

/// Options of each pair of labels; `any` stands for every body, and a pair named in full goes
/// before it. What is bonded to the same body is bonded too.
ContactOptions contact_options(const Deck& deck);

/// By body, the smallest label of those that are bonded with it, over any way.
std::vector<Label> first_bonded(const Deck& deck);

/// Bodies whose particles share one sum with those of this one, ascending, itself among them; no
/// other: the pieces of a body are sums of their own unless it is bonded to itself.
std::vector<Label> bonded_with(const Deck& deck, Label body);

/// A label of the sum in which each piece takes part, by piece.
template <int Dim>
std::vector<Label> sums_of_pieces(const Deck& deck, const std::vector<BodyGeometry<Dim>>& bodies);

/// Bonded bodies that are not of particles, or whose sums differ.
void check_bonds(const LoadedDeck& loaded, std::vector<DeckProblem>& problems);

}  // namespace brunt
