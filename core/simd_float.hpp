#pragma once
/// Four single-precision numbers side by side, for tests that may err on the safe side, and how to
/// keep the lanes that pass.
#include "core/simd.hpp"

namespace brunt {

using FloatPack = float __attribute__((vector_size(16)));
using FloatMask = decltype(FloatPack{} < FloatPack{});

BRUNT_INLINE FloatPack load_floats(const float* p) {
  FloatPack four;
  std::memcpy(&four, p, sizeof four);
  return four;
}
BRUNT_INLINE FloatPack broadcast_float(float s) { return FloatPack{s, s, s, s}; }
/// One bit a lane.
BRUNT_INLINE unsigned mask_bits(FloatMask m) {
#ifdef __AVX__
  return static_cast<unsigned>(__builtin_ia32_movmskps(reinterpret_cast<FloatPack>(m)));
#else
  return static_cast<unsigned>((m[0] & 1) | (m[1] & 2) | (m[2] & 4) | (m[3] & 8));
#endif
}

/// For each set of lanes: its lanes moved to the front, in their order, and how many they are.
struct Compression {
  alignas(16) std::int32_t lane[16][4];
  int count[16];
};
constexpr Compression compression() {
  Compression table{};
  for (int set = 0; set < 16; ++set) {
    for (int lane = 0; lane < 4; ++lane) {
      if ((set >> lane & 1) != 0) table.lane[set][table.count[set]++] = lane;
    }
  }
  return table;
}
inline constexpr Compression kCompression = compression();

}  // namespace brunt
// Tested by tests/unit/core/simd_test.cpp.
