#pragma once
#include "contact/entities.hpp"

namespace brunt {

/// Smallest 2 sqrt(m/k) of the particles on their own springs.
template <int Dim>
StepVote vote_of_particles(const PairTable& pairs, const Section& section,
                           const Entities<Dim>& entities);

/// Bounds of free rigid bodies on the springs of all their faces at once, in every direction: of
/// K = sum k A J^T J the largest eigenvalue of M^-1 K is at most sum k A |J M^-1 J^T|, and so of
/// their dampers. Their share in a spring between two bodies is bounded by their own, as for
/// elements: 1/(1/k1 + 1/k2) (u1 - u2)^2 <= k1 u1^2 + k2 u2^2.
template <int Dim>
StepVote vote_of_rigid(const Section& section, const Entities<Dim>& entities);

}  // namespace brunt
