#pragma once
#include <cstdint>

#include "core/types.hpp"

namespace brunt {

/// Pairs of neighbour lists: (i, j) and (j, i) are two.
struct PairCount {
  std::int64_t in_support = 0;  ///< within the support of their kernel
  std::int64_t compared = 0;    ///< candidates whose distances are found to choose them

  /// [1] share of candidates that interact; 0 where there are none.
  Real hit_rate() const {
    return compared > 0 ? static_cast<Real>(in_support) / static_cast<Real>(compared) : 0;
  }
};

}  // namespace brunt
// Tested by tests/unit/sph/particles_lists_test.cpp.
