#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "core/types.hpp"

namespace brunt::test {

/// Two convex bodies, thrown at each other: a deck of the seed alone.
struct Impact {
  std::string text;     ///< of the deck
  std::string what;     ///< both bodies in words
  bool flat = false;    ///< 2D
  int n_deforming = 0;  ///< bodies of elements or particles
};

/// Needles, knives, chisels, wedges and boxes of up to 1:20, 2D and 3D; elements and rigid bodies
/// on each other, and particles on both. Points and edges are aimed at the middle of the other
/// body; one pair in three lies as it falls.
Impact random_impact(std::uint64_t seed);

/// What came of it.
struct Outcome {
  std::string failure;  ///< of the run; empty: none
  /// Bodies went into each other: rigid ones and hulls by 15 % of their size about their middles,
  /// and of what bends an element by half of it, or the centre of a particle.
  bool crossed = false;
  Real pairs = 0;        ///< largest energy.contact.pairs, of the largest energy
  Real created = 0;      ///< energy that nobody put in, of it
  std::size_t lost = 0;  ///< pairs of bodies whose contacts were reported
  std::int64_t steps = 0;
};
Outcome outcome_of(const Impact& impact, const std::vector<std::string>& overrides = {});

}  // namespace brunt::test
