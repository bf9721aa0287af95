#pragma once
/// Eight single-precision numbers side by side, as a Pack holds four doubles: the same bits on
/// every instruction set, for what may err by 1e-7 of itself.
#include "core/simd_float.hpp"

namespace brunt {

inline constexpr int kSingleLanes = 8;
using SinglePack = float __attribute__((vector_size(32)));
using SingleMask = decltype(SinglePack{} < SinglePack{});  // 0 or -1 in each lane
using SingleBits = std::uint32_t __attribute__((vector_size(32)));

/// The number in a lane of V: double of Real and Pack, float of SinglePack.
template <class V>
struct NumberIn {
  using Type = Real;
};
template <>
struct NumberIn<SinglePack> {
  using Type = float;
};
/// A constant that is no sum of few powers of two, for arithmetic with V.
template <class V>
constexpr typename NumberIn<V>::Type number_of(Real constant) {
  return static_cast<typename NumberIn<V>::Type>(constant);
}

template <>
BRUNT_INLINE SinglePack broadcast<SinglePack>(Real s) {
  const auto f = static_cast<float>(s);
  return SinglePack{f, f, f, f, f, f, f, f};
}
BRUNT_INLINE SinglePack load(const float* p) {
  SinglePack r;
  std::memcpy(&r, p, sizeof r);
  return r;
}
BRUNT_INLINE SinglePack select(SingleMask m, SinglePack a, SinglePack b) { return m ? a : b; }
BRUNT_INLINE SinglePack vmin(SinglePack a, SinglePack b) { return a < b ? a : b; }
BRUNT_INLINE SinglePack vmax(SinglePack a, SinglePack b) { return a > b ? a : b; }
BRUNT_INLINE SinglePack vsqrt(SinglePack a) {
  SinglePack r;
  for (int lane = 0; lane < kSingleLanes; ++lane) r[lane] = std::sqrt(a[lane]);
  return r;
}
/// a b + c, rounded once.
BRUNT_INLINE SinglePack vfma(SinglePack a, SinglePack b, SinglePack c) {
#if defined(__AVX2__)
  asm("vfmadd231ps %2, %1, %0" : "+x"(c) : "x"(a), "xm"(b));
#else
  for (int lane = 0; lane < kSingleLanes; ++lane) c[lane] = std::fma(a[lane], b[lane], c[lane]);
#endif
  return c;
}
/// One bit a lane.
BRUNT_INLINE unsigned mask_bits(SingleMask m) {
#ifdef __AVX__
  return static_cast<unsigned>(__builtin_ia32_movmskps256(reinterpret_cast<SinglePack>(m)));
#else
  unsigned bits = 0;
  for (int lane = 0; lane < kSingleLanes; ++lane) bits |= (m[lane] != 0 ? 1U : 0U) << lane;
  return bits;
#endif
}
BRUNT_INLINE bool any(SingleMask m) { return mask_bits(m) != 0; }

/// Eight numbers as doubles, four and four.
BRUNT_INLINE Pack low_half(SinglePack a) {
  return __builtin_convertvector(__builtin_shufflevector(a, a, 0, 1, 2, 3), Pack);
}
BRUNT_INLINE Pack high_half(SinglePack a) {
  return __builtin_convertvector(__builtin_shufflevector(a, a, 4, 5, 6, 7), Pack);
}
BRUNT_INLINE SinglePack joined(Pack low, Pack high) {
  const auto a = __builtin_convertvector(low, FloatPack);
  const auto b = __builtin_convertvector(high, FloatPack);
  return __builtin_shufflevector(a, b, 0, 1, 2, 3, 4, 5, 6, 7);
}

/// Eight rows of four numbers: out[c] holds component c of all rows. Two rows are loaded into one
/// register, so that a transposition of four by four is done for both at once.
BRUNT_INLINE void load_transposed(const float* const (&row)[kSingleLanes], SinglePack* out) {
  SinglePack two[4];  // row k, and row k + 4
  for (int k = 0; k < 4; ++k) {
    two[k] = __builtin_shufflevector(load_floats(row[k]), load_floats(row[k + 4]), 0, 1, 2, 3, 4, 5,
                                     6, 7);
  }
  const SinglePack ab_low = __builtin_shufflevector(two[0], two[1], 0, 8, 1, 9, 4, 12, 5, 13);
  const SinglePack ab_high = __builtin_shufflevector(two[0], two[1], 2, 10, 3, 11, 6, 14, 7, 15);
  const SinglePack cd_low = __builtin_shufflevector(two[2], two[3], 0, 8, 1, 9, 4, 12, 5, 13);
  const SinglePack cd_high = __builtin_shufflevector(two[2], two[3], 2, 10, 3, 11, 6, 14, 7, 15);
  out[0] = __builtin_shufflevector(ab_low, cd_low, 0, 1, 8, 9, 4, 5, 12, 13);
  out[1] = __builtin_shufflevector(ab_low, cd_low, 2, 3, 10, 11, 6, 7, 14, 15);
  out[2] = __builtin_shufflevector(ab_high, cd_high, 0, 1, 8, 9, 4, 5, 12, 13);
  out[3] = __builtin_shufflevector(ab_high, cd_high, 2, 3, 10, 11, 6, 7, 14, 15);
}

}  // namespace brunt
// Tested by tests/unit/core/simd_test.cpp.
