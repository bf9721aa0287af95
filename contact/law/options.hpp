#pragma once
#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "contact/law/catalog.hpp"
#include "contact/law/coulomb_friction.hpp"
#include "contact/law/friction_heat.hpp"
#include "contact/law/initial_overlap.hpp"
#include "contact/law/joint.hpp"
#include "contact/law/plane_rule.hpp"
#include "core/search/search.hpp"

namespace brunt {

/// [1] Stiffness of pairs with `step_by_area` up to which each face bounds the step as if all of it
/// were pressed, whether anything is near or not: by a fifth of the step of the elements behind.
inline constexpr Real kFreeStiffness = 2;

/// What a pair of bodies may be given; a key not given comes from `default`.
struct PairOptions {
  bool ignore = false;
  Real stiffness = 0.5;  ///< phi: fraction of the springs of both sides in series
  Real damping = 0.1;    ///< zeta: fraction of critical
  CoulombFriction coulomb{};
  Bonds bonds{};
  /// What touches at time 0 stays together by springs between places of both sides, until it breaks
  /// where `cohesion` or `tension` say so.
  bool tied = false;
  std::optional<JointSpring> joint{};  ///< by these springs, and so does what meets later
  InitialOverlap initial_overlap = InitialOverlap::track;
  PlaneRule plane = PlaneRule::integrated;
  /// Faces that press bound the step by their area under pressure, where the pair is stiff: not
  /// whole faces always.
  bool step_by_area = false;
  /// Pressure, in weights of the body that rests, as far as which a soft layer lets it come to
  /// rest.
  Real resting_layer = 3;

  ContactHeat heat{};
  FrictionHeat friction_heat{};
  bool bonded = false;  ///< particles of both bodies share one SPH sum

  bool passes_heat() const { return heat.index() != 0; }
  /// True where places of both sides are held from time 0 on.
  bool holds() const { return tied || joint.has_value(); }
  /// True where anything resists sliding, a bond too.
  bool has_friction() const { return BondLaw(bonds).any() || coulomb.acts(); }
  /// True where faces bound the step by the area that they press. What is held, bonded or a joint
  /// has springs where nothing is pressed.
  bool watched() const {
    return step_by_area && stiffness > kFreeStiffness && !holds() && !BondLaw(bonds).any();
  }
  /// [1] as large a part of the springs of both sides as any spring between them may be.
  Real stiffest() const { return holds() ? std::max(stiffness, kTiedStiffness) : stiffness; }
  /// True where that depends on the temperature or the flow stress of what slides.
  bool needs_material() const {
    return (coulomb.shear_limit && has_friction()) || coulomb.depends_on_material();
  }
};

inline void describe(Schema& s, PairOptions& pair) {
  s.flag({"ignore", "these bodies do not touch each other"}, pair.ignore);
  s.flag({"bonded", "particles of both bodies share one SPH sum, as those of one body"},
         pair.bonded);
  describe(s, pair.coulomb);
  s.real({"stiffness", "fraction of the springs of both sides in series"}, pair.stiffness,
         {"1", positive(), between(0.01, 100)});
  s.real({"damping", "fraction of critical damping"}, pair.damping, {"1", between(0, 2)});
  s.flag({"step_by_area",
          "a stiffness above 2 bounds the step by the area that faces press, not by whole faces "
          "always: for bodies that meet by edges and corners; not of particles, bonds, ties and "
          "joints"},
         pair.step_by_area);
  std::apply([&](auto&... bond) { (describe(s, bond), ...); }, pair.bonds);
  s.flag({"tied",
          "what touches at time 0 stays together: springs hold places of both sides, until "
          "cohesion or tension, where they are given, are exceeded"},
         pair.tied);
  s.object(
      {"joint",
       "faces close and shear as those of a joint, from time 0 on held by cohesion and tension"},
      pair.joint);
  describe(s, pair.initial_overlap);
  describe(s, pair.plane);
  s.real({"resting_layer",
          "pressure, in weights of the body that rests, up to which contact under gravity is soft "
          "and damped, so that bodies come to rest; none where it is 0, or damping is"},
         pair.resting_layer, {"1", at_least(0), between(0, 1000)});
  s.one_of({"heat", "whether heat passes between them where they touch"}, pair.heat);
  s.object({"friction_heat", "what becomes of the heat of friction"}, pair.friction_heat);
  s.require(!pair.tied || !(pair.ignore || pair.bonded), "tied",
            "stands beside ignore or bonded: keep one of them");
  s.require(!pair.ignore || !pair.bonded, "bonded", "stands beside ignore: keep one of them");
}

/// In scenes with more pairs of bodies than this, those of 45 bodies, history.csv has columns of
/// the pairs that the deck names alone: others would be half a million in 1,000 bodies.
inline constexpr std::size_t kMostReportedPairs = 1000;

/// Contact as the scene hands it to the manager: options resolved for each pair of body labels.
struct ContactOptions {
  std::vector<Real> gravity;                             ///< [m/s^2] as of the deck; empty: none
  PairOptions fallback;                                  ///< `default`
  std::map<std::pair<Label, Label>, PairOptions> pairs;  ///< keys with first <= second
  std::map<std::pair<Label, Label>, std::string> pair_names;
  std::set<std::pair<Label, Label>> turned;  ///< those whose name puts the second body first
  SearchMode search = SearchMode::grid;
  std::optional<Real> skin;  ///< [m]; none: tuned on counted work
  Real safety = 1;           ///< fraction of its step limits that a step is
};

}  // namespace brunt
