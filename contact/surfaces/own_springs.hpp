#pragma once
#include "contact/surfaces/entities.hpp"

namespace brunt {

/// Sets the bound 2 sqrt(m/k) of particles on their own springs; that of rings, whose springs go
/// with their radius, limit_of_rings finds at each step.
template <int Dim>
void set_limits_of_particles(const PairTable& pairs, const Section& section,
                             const RigidSprings& rigid, Entities<Dim>& entities);
template <int Dim>
StepLimit limit_of_rings(const Entities<Dim>& entities);

/// Bounds of free rigid bodies on the springs of all their faces at once, in every direction: of
/// K = sum k A J^T J the largest eigenvalue of M^-1 K, found when they are built, and so of
/// their dampers. k is the largest of what may touch them, or their own beside rigid bodies. Their
/// share in a spring between two bodies is bounded by their own, as for elements:
/// 1/(1/k1 + 1/k2) (u1 - u2)^2 <= k1 u1^2 + k2 u2^2. Beside what deforms, whose spring both sides
/// feel whole, the rigid body leaves room: its bound is sqrt(kMostRecoil) of this, and its
/// neighbours' springs are stiffer by recoil_factor. entities  of the whole scene
template <int Dim>
RigidSprings springs_of_rigid(const PairTable& pairs, const Section& section,
                              const Entities<Dim>& entities);

}  // namespace brunt
