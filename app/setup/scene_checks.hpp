#pragma once
/// What only the built scene shows: meshes, chosen points, columns, bodies inside each other.
#include <string>
#include <vector>

#include "app/deck/deck.hpp"
#include "app/scene/scene.hpp"

namespace brunt {

/// Prescribed velocities that are not numbers, or that contradict each other at shared points.
template <int Dim>
void check_constraints(const LoadedDeck& loaded, const Scene<Dim>& scene,
                       std::vector<DeckProblem>& problems);

/// Bodies that may touch and are inside each other at time 0 by more than half an element.
template <int Dim>
void check_overlaps(const LoadedDeck& loaded, Scene<Dim>& scene,
                    std::vector<DeckProblem>& problems);

/// Adds what is to be said of pairs of bodies: those that overlap at time 0 by less, how deep, and
/// what comes of it; elements that may touch surfaces with a rim; heat_every where no heat is
/// conducted; and what suspicious.hpp finds. Prints it too where asked. Of a whole scene.
template <int Dim>
void warn_of_scene(const LoadedDeck& loaded, const Scene<Dim>& scene, bool print,
                   std::vector<DeckProblem>& warnings);

/// Bodies that mass scaling makes heavier than the deck allows; notes how much it adds to each.
template <int Dim>
void check_added_mass(const LoadedDeck& loaded, Scene<Dim>& scene,
                      std::vector<DeckProblem>& problems);

/// Bodies that it makes heavier by more than 1 %; or that it adds nothing at all.
template <int Dim>
std::vector<std::string> added_mass_warnings(const LoadedDeck& loaded, const Scene<Dim>& scene);

/// Measures and stops of columns that history.csv does not have, and measures of fields that a body
/// does not have.
template <int Dim>
void check_measures(const LoadedDeck& loaded, const Scene<Dim>& scene,
                    std::vector<DeckProblem>& problems);

}  // namespace brunt
