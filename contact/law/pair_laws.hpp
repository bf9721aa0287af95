#pragma once
#include "contact/law/options.hpp"

namespace brunt {

/// The laws by which two bodies touch beside their springs, chosen from the options of the pair
/// when candidates are built.
struct PairLaws {
  /// Where something resists sliding, if only a bond; nullptr: they slide freely.
  const CoulombFriction* friction = nullptr;
  BondLaw bond{};
  const FrictionHeat* friction_heat = nullptr;
  const ContactHeat* heat = nullptr;  ///< where heat passes and both sides take any
  InitialOverlap initial_overlap = InitialOverlap::track;
  /// Where they are tied or a joint; bonds are then those of its springs.
  const PairOptions* holds = nullptr;

  PairLaws() = default;
  /// options  outlive it
  PairLaws(const PairOptions& options, bool both_take_heat)
      : friction(options.has_friction() ? &options.coulomb : nullptr),
        bond(options.holds() ? BondLaw{} : BondLaw(options.bonds)),
        friction_heat(&options.friction_heat),
        heat(both_take_heat && options.passes_heat() ? &options.heat : nullptr),
        initial_overlap(options.initial_overlap),
        holds(options.holds() ? &options : nullptr) {}

  bool presses_at_once() const { return initial_overlap == InitialOverlap::press; }
  /// The force [N] at which contact slips. coefficient  out, where the state has one: it may be
  /// infinite at no pressure, c/p, a friction that does not depend on it
  Real slip_limit(const ContactState& at, Real& coefficient) const;
};

}  // namespace brunt
// Tested by tests/unit/contact/cohesive_bond_test.cpp.
