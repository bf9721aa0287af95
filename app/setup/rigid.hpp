#pragma once
#include <span>
#include <vector>

#include "app/deck/deck.hpp"
#include "app/scene/scene.hpp"

namespace brunt {

/// The bodies of a surface that follow their forces, each piece by itself, with mass and inertia of
/// what its facets enclose; gives the facets what contact needs of a body that moves. Problems are
/// collected.
///   stiffness M/h, areal mass m/A = rho h/2, depth h/2 with h = 2 V/A: the thickness of a thin
///   plate, a third of a cube's edge
template <int Dim>
std::vector<FreeBody<Dim>> free_bodies_of(const LoadedDeck& loaded, const Scene<Dim>& scene,
                                          Surface<Dim>& surface,
                                          std::vector<DeckProblem>& problems);

/// Centres [m] of the bodies of a surface that are held or have a prescribed motion, at time 0.
template <int Dim>
void find_rigid_centers(const Deck& deck, const Surface<Dim>& surface, Scene<Dim>& scene);

/// Sets how thick the body is behind the facets of rigid bodies, as far as the particles of
/// the scene ask.
template <int Dim>
void find_half_thicknesses(Scene<Dim>& scene);

/// Shares [kg] of the bodies' masses for their points, with the centre of each as their mean: m/n,
/// and more towards it, as little as squares allow: w = m/n + b.(x - mean), where
/// sum w x = m center. Other points have none.
template <int Dim>
std::vector<Real> mass_shares(std::span<const FreeBody<Dim>> bodies, const Points<Dim>& points);

/// The prescribed motion of a rigid body; components that are free are 0.
template <int Dim>
RigidMotion<Dim> motion_of(const deck::Body& body, Label label, const Vec<Dim>& origin);

}  // namespace brunt
