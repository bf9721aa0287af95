#pragma once
/// The list of what boundaries do. A new one: its file, its name here (docs/adding.md).
#include <tuple>

#include "core/boundaries/force.hpp"
#include "core/boundaries/motion.hpp"
#include "core/boundaries/nonreflecting.hpp"
#include "core/boundaries/pressure.hpp"
#include "core/boundaries/surface_heat.hpp"

namespace brunt {

/// What one of the deck's boundaries may do to its points, any of them at once; in the order of the
/// manual and of the columns of history.csv. A kind has
///   static constexpr const char* deck_keys;        its keys in the deck
///   bool given() const;                            true where the deck has any of them
///   template <int Dim> using Acting = ...;         what acts in a scene
/// and describe(Schema&, Kind&). An Acting has a `patch`, made with Acting(kind, patch), and of
/// start, impose, add_forces, complete_forces, take_reactions, add_heat, hold_temperature what it
/// needs: core/boundaries/boundaries.hpp says when each is called.
using BoundaryKinds =
    std::tuple<PrescribedMotion, AppliedForce, FollowerPressure, Nonreflecting, SurfaceHeat>;

/// True for kinds that heat: rigid bodies that are held or have a prescribed motion take no others.
template <class Kind>
constexpr bool heats() {
  return requires { Kind::kHeats; };
}
/// True for kinds that are forces, which rigid bodies take that follow them.
template <class Kind>
constexpr bool is_force() {
  return requires { Kind::kIsForce; };
}
/// True where the kind may set a body in motion.
template <class Kind>
bool may_push(const Kind& kind) {
  if constexpr (requires { kind.pushes(); }) return kind.pushes();
  return kind.given();
}

}  // namespace brunt
// Tested by tests/unit/app/deck_keys_test.cpp.
