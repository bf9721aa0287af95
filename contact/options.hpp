#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/schema.hpp"
#include "core/search/search.hpp"

namespace brunt {

/// What a pair of bodies may be given; a key not given comes from `default`.
struct PairOptions {
  bool ignore = false;
  Real stiffness = 0.5;  ///< phi: fraction of the springs of both sides in series
  Real damping = 0.1;    ///< zeta: fraction of critical
};

inline void describe(Schema& s, PairOptions& pair) {
  static constexpr const char* kLater[] = {"tied",  "shear_limit", "cohesion",      "tension",
                                           "joint", "heat",        "friction_heat", "bonded"};
  Real friction = 0;  // contact without friction is all that there is
  s.flag({"ignore", "these bodies do not touch each other"}, pair.ignore);
  s.real({"friction", "coefficient of friction; only 0 in this version, friction comes later"},
         friction, {"1", between(0, 0)});
  s.real({"stiffness", "fraction of the springs of both sides in series"}, pair.stiffness,
         {"1", positive(), between(0.01, 10)});
  s.real({"damping", "fraction of critical damping"}, pair.damping, {"1", between(0, 2)});
  s.later(kLater);
}

/// Contact as the scene hands it to the manager: options resolved for each pair of body labels.
struct ContactOptions {
  PairOptions fallback;                                  ///< `default`
  std::map<std::pair<Label, Label>, PairOptions> pairs;  ///< keys with first <= second
  std::map<std::pair<Label, Label>, std::string> pair_names;
  SearchMode search = SearchMode::grid;
  std::optional<Real> skin;  ///< [m]; none: tuned on counted work
};

}  // namespace brunt
