#pragma once
#include "app/deck/deck.hpp"
#include "app/scene/scene.hpp"

namespace brunt {

/// What a run will need, counted from the sizes of its structures; peak_memory of a run is within
/// 15 % of the total (tests/cli/plan.sh).
struct MemoryEstimate {
  Real program = 0;     ///< [byte] the program and its libraries, as measured when it starts, and
                        ///< what of them stepping and writing bring in
  Real elements = 0;    ///< [byte] with their nodes
  Real particles = 0;   ///< [byte] with their points
  Real neighbours = 0;  ///< [byte] lists of particles, at the expected number of neighbours
  Real converted = 0;   ///< [byte] the same where elements may become particles, if all do; not in
                        ///< the total: how many will, no formula foretells
  Real contact = 0;     ///< [byte] faces, nodes, lists
  Real passing = 0;     ///< [byte] what comes and goes, the largest of: lists and tables made
                        ///< anew, a frame, a checkpoint
  Real rows = 0;        ///< [byte] of the history, all of them
  Real total() const {
    return program + elements + particles + neighbours + contact + passing + rows;
  }
};

/// What a deck says that counts in memory.
struct MemoryInputs {
  Real program = 0;     ///< [byte] resident before the scene was built
  int gauss = 1;        ///< most material points of an element
  Real smoothing = 0;   ///< largest smoothing length over spacing, of bodies of particles
  bool bricks = false;  ///< some body is of bricks, whose faces touch from time 0 on
  bool single = false;  ///< some particles have pair_precision: single
  bool total = false;   ///< some have formulation: total
  Real rows = 2000;     ///< of the history
  std::size_t columns = 0;
  bool checkpoints = true;  ///< some are written
};

/// Resident memory of this process now [byte]; 0 where the system does not say.
Real resident_memory();

/// What a deck says of them. program  [byte] resident before the scene was built
template <int Dim>
MemoryInputs memory_inputs(const Deck& deck, const Scene<Dim>& scene, Real program);

template <int Dim>
MemoryEstimate memory_of(const Scene<Dim>& scene, const MemoryInputs& inputs);

}  // namespace brunt
