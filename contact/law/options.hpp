#pragma once
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "contact/law/catalog.hpp"
#include "contact/law/coulomb_friction.hpp"
#include "contact/law/friction_heat.hpp"
#include "contact/law/initial_overlap.hpp"
#include "core/search/search.hpp"

namespace brunt {

/// What a pair of bodies may be given; a key not given comes from `default`.
struct PairOptions {
  bool ignore = false;
  Real stiffness = 0.5;  ///< phi: fraction of the springs of both sides in series
  Real damping = 0.1;    ///< zeta: fraction of critical
  CoulombFriction coulomb{};
  Bonds bonds{};
  InitialOverlap initial_overlap = InitialOverlap::track;
  /// Pressure, in weights of the body that rests, as far as which a soft layer lets it come to
  /// rest.
  Real resting_layer = 3;

  ContactHeat heat{};
  FrictionHeat friction_heat{};
  bool bonded = false;  ///< particles of both bodies share one SPH sum

  bool passes_heat() const { return heat.index() != 0; }
  /// True where anything resists sliding, a bond too.
  bool has_friction() const { return BondLaw(bonds).any() || coulomb.acts(); }
  /// True where that depends on the temperature or the flow stress of what slides.
  bool needs_material() const {
    return (coulomb.shear_limit && has_friction()) || coulomb.depends_on_material();
  }
};

inline void describe(Schema& s, PairOptions& pair) {
  static constexpr const char* kLater[] = {"tied", "joint"};
  s.flag({"ignore", "these bodies do not touch each other"}, pair.ignore);
  s.flag({"bonded", "particles of both bodies share one SPH sum, as those of one body"},
         pair.bonded);
  describe(s, pair.coulomb);
  s.real({"stiffness", "fraction of the springs of both sides in series"}, pair.stiffness,
         {"1", positive(), between(0.01, 10)});
  s.real({"damping", "fraction of critical damping"}, pair.damping, {"1", between(0, 2)});
  std::apply([&](auto&... bond) { (describe(s, bond), ...); }, pair.bonds);
  describe(s, pair.initial_overlap);
  s.real({"resting_layer",
          "pressure, in weights of the body that rests, up to which contact under gravity is soft "
          "and damped, so that bodies come to rest; none where it is 0, or damping is"},
         pair.resting_layer, {"1", at_least(0), between(0, 1000)});
  s.one_of({"heat", "whether heat passes between them where they touch"}, pair.heat);
  s.object({"friction_heat", "what becomes of the heat of friction"}, pair.friction_heat);
  s.later(kLater);
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
