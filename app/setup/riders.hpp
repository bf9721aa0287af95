#pragma once
#include "app/setup/groups.hpp"

namespace brunt {

/// Particles, asleep yet, on the nodes of elements that the deck turns into particles where they
/// fail (`erode: {to: sph}`): one a node, a group for each group of elements, behind all others.
/// Nothing else of the scene knows them: their nodes carry, touch and are loaded.
template <int Dim>
void add_riders(const LoadedDeck& loaded, Scene<Dim>& scene, NextIds& next);

}  // namespace brunt
