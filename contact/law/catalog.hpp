#pragma once
/// The laws of contact that a deck may choose from. A law is its own file, its name here, and its
/// test (docs/adding.md).
#include <tuple>
#include <variant>

#include "contact/law/chosen_bond.hpp"
#include "contact/law/chosen_closure.hpp"
#include "contact/law/cohesive_bond.hpp"
#include "contact/law/contact_conductance.hpp"
#include "contact/law/contact_heat.hpp"
#include "contact/law/exponential_closure.hpp"
#include "contact/law/hyperbolic_closure.hpp"

namespace brunt {

/// The deck's `heat` of a pair: whether heat passes from body to body where they touch. A law has
///   Real conductance(Real pressure) const;  // [W/m^2/K] under a pressure [Pa]; may be infinite
///   Real gap() const;                       // [m] opening up to which heat passes
using ContactHeat = std::variant<NoContactHeat, PerfectContactHeat, ContactConductance>;

inline Real conductance_of(const ContactHeat& heat, Real pressure) {
  return std::visit([&](const auto& law) { return law.conductance(pressure); }, heat);
}
inline Real gap_of(const ContactHeat& heat) {
  return std::visit([](const auto& law) { return law.gap(); }, heat);
}

/// What may hold faces together from time 0 on, each with keys among those of a pair. A law has
///   bool acts() const;                           // the deck asks for it
///   bool begins(Real gap, Real rounding) const;  // between faces `gap` [m] apart at time 0
///   bool tears(Real pull) const;                 // under a pull [Pa]
///   bool breaks_by_slip() const;
///   Real slip_limit(const ContactState& at, Real coefficient) const;  // [N] at which it slips
using Bonds = std::tuple<CohesiveBond>;

/// The bond of a pair that acts, or none.
using BondLaw = ChosenBond<Bonds>;

/// How a joint closes, each with keys among those of `joint`. A law has, with k [Pa/m] its slope at
/// no closure and u [m] its closure,
///   bool acts() const;                           // the deck asks for it
///   Real most() const;                           // [m] closure at which it would be rigid
///   Real pressure(Real k, Real u) const;         // [Pa] where it has never been so closed
///   Real slope(Real k, Real u) const;            // [Pa/m] of that
///   Real closure_at(Real k, Real slope) const;   // [m] with that slope
///   Real work(Real k, Real u) const;             // [J/m^2] of closing it
///   Real lost(Real k, Real u) const;             // [J/m^2] of that, if it opens by its tangent
using Closures = std::tuple<HyperbolicClosure, ExponentialClosure>;

/// The law of closure of a joint, or a line where none acts.
using ClosureLaw = ChosenClosure<Closures>;

}  // namespace brunt
// Tested by tests/unit/contact/joint_test.cpp.
