#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/search/search.hpp"

namespace brunt {

/// What a pair of bodies may be given; a key not given comes from `default`.
struct PairOptions {
  bool ignore = false;
  Real stiffness = 0.5;  ///< phi: fraction of the springs of both sides in series
  Real damping = 0.1;    ///< zeta: fraction of critical
};

/// Contact as the scene hands it to the manager: options resolved for each pair of body labels.
struct ContactOptions {
  PairOptions fallback;                                  ///< `default`
  std::map<std::pair<Label, Label>, PairOptions> pairs;  ///< keys with first <= second
  std::map<std::pair<Label, Label>, std::string> pair_names;
  SearchMode search = SearchMode::grid;
  std::optional<Real> skin;  ///< [m]; none: tuned on counted work
};

}  // namespace brunt
