#pragma once
#include "app/scene.hpp"

namespace brunt {

/// Turns a whole scene at time 0, which every rank has built, into the part that this rank
/// computes; supports and loads keep what is owned here. Collective; nothing on a lone rank.
template <int Dim>
void distribute(Scene<Dim>& scene, const Communicator& ranks, std::unique_ptr<const Deal> deal);

/// The same by a first deal: recursive bisection, weighted by the elements and particles that hang
/// on the points.
template <int Dim>
void distribute(Scene<Dim>& scene, const Communicator& ranks);

}  // namespace brunt
