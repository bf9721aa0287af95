#pragma once
#include "core/simd.hpp"

namespace brunt {

/// Row k of `out` is lane k of a, b, c and d.
BRUNT_INLINE void transpose(Pack a, Pack b, Pack c, Pack d, Pack* out) {
  const Pack ab_even = __builtin_shufflevector(a, b, 0, 4, 2, 6);
  const Pack ab_odd = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Pack cd_even = __builtin_shufflevector(c, d, 0, 4, 2, 6);
  const Pack cd_odd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  out[0] = __builtin_shufflevector(ab_even, cd_even, 0, 1, 4, 5);
  out[1] = __builtin_shufflevector(ab_odd, cd_odd, 0, 1, 4, 5);
  out[2] = __builtin_shufflevector(ab_even, cd_even, 2, 3, 6, 7);
  out[3] = __builtin_shufflevector(ab_odd, cd_odd, 2, 3, 6, 7);
}

}  // namespace brunt
// Tested by tests/unit/contact/near_faces_test.cpp.
