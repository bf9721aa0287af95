#pragma once
#include <vector>

#include "app/deck/deck.hpp"
#include "app/scene.hpp"

namespace brunt {

/// The rigid bodies of the deck that follow their forces, each piece by itself, with mass and
/// inertia of its surface; gives their facets what contact needs of a body that moves. Null where
/// there are none; problems are collected.
///   stiffness M/h, areal mass m/A = rho h/2, depth h/2 with h = 2 V/A: the thickness of a thin
///   plate, a third of a cube's edge
template <int Dim>
std::unique_ptr<FreeBodies<Dim>> make_free_bodies(const LoadedDeck& loaded, const Scene<Dim>& scene,
                                                  RigidSurfaces<Dim>& surfaces,
                                                  std::vector<DeckProblem>& problems);

/// How a rigid body moves that is told; components that are free are 0.
template <int Dim>
RigidMotion<Dim> motion_of(const deck::Body& body, Label label, const Vec<Dim>& origin);

}  // namespace brunt
