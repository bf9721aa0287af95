#pragma once
#include "core/simd.hpp"

namespace brunt {

/// The sum of four lanes.
BRUNT_INLINE Real sum_of(const Pack& lanes) {
  return (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]);
}
/// Those of four packs at once, a lane each, in the same order.
BRUNT_INLINE Pack sums_of(const Pack& a, const Pack& b, const Pack& c, const Pack& d) {
  const Pack ab =
      __builtin_shufflevector(a, b, 0, 4, 2, 6) + __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Pack cd =
      __builtin_shufflevector(c, d, 0, 4, 2, 6) + __builtin_shufflevector(c, d, 1, 5, 3, 7);
  return __builtin_shufflevector(ab, cd, 0, 1, 4, 5) + __builtin_shufflevector(ab, cd, 2, 3, 6, 7);
}

}  // namespace brunt
// Tested by tests/unit/core/simd_test.cpp.
