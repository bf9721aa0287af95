#pragma once
#include <array>
#include <string>
#include <vector>

#include "app/deck/deck.hpp"
#include "app/scene/scene.hpp"

namespace brunt {

/// What a plan says of one pair of bodies.
struct PlannedPair {
  std::string name;      ///< "a-b"
  bool modelled = true;  ///< contact is evaluated where they come near
  std::string what;      ///< friction, heat; or why it is not modelled
};

/// The pairs of bodies of a deck: what acts between them and what does not, and why; when they
/// meet as they move at time 0, by the boxes around them.
template <int Dim>
std::vector<PlannedPair> planned_pairs(const Deck& deck, const Scene<Dim>& scene);

/// When two boxes that move evenly touch [s]: 0 where they do at once, infinity where never.
/// low, high  [m] corners of the first and the second; speed  [m/s] of the second to the first
Real meeting_time(const std::array<std::array<Real, 3>, 2>& low,
                  const std::array<std::array<Real, 3>, 2>& high, const std::array<Real, 3>& speed);

}  // namespace brunt
