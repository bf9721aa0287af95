#pragma once
/// The true neighbours of a particle, out of its candidates.
#include <algorithm>
#include <bit>

#include "core/simd_float.hpp"
#include "sph/records.hpp"

namespace brunt {

inline constexpr int kByte = 8;  ///< candidates of which a byte tells

/// Appends those of n candidates, four or eight, whose bits are set; writes n places.
template <int n>
BRUNT_INLINE int append(LocalIndex* out, const LocalIndex* candidate, unsigned bits) {
#ifdef BRUNT_WIDE
  if constexpr (n == kByte) {
    __m256i eight;
    std::memcpy(&eight, candidate, sizeof eight);
    eight = _mm256_maskz_compress_epi32(static_cast<__mmask8>(bits), eight);
    std::memcpy(out, &eight, sizeof eight);
    return std::popcount(bits);
  }
#endif
  const unsigned low = bits & 15U, high = bits >> 4;
  store_permuted(out, candidate, kCompression.lane[low]);
  const int found = kCompression.count[low];
  if constexpr (n == kLanes) return found;
  store_permuted(out + found, candidate + kLanes, kCompression.lane[high]);
  return found + kCompression.count[high];
}

/// The last candidates of a row, fewer than eight, filled up by i.
struct Rest {
  LocalIndex candidate[kByte];
  Rest(const LocalIndex* from, int n, LocalIndex i) {
    std::fill(candidate, candidate + kByte, i);
    std::copy_n(from, n, candidate);
  }
};

/// Which pairs (i, j) of a pack interact, a bit a lane.
template <int Dim, class P>
BRUNT_INLINE unsigned inside_support(const MotionRecord<Dim, typename P::Stored>* records,
                                     const typename P::Number* own, const LocalIndex* j) {
  PairPack<Dim, P> pairs;
  set_arms(records, own, j, pairs);
  return mask_bits(pairs.q2 < number_of<typename P::Pack>(P::kSupport));
}

/// Writes those of n candidates that interact with i to `out`, up to a whole pack more; in space a
/// bit of each to `byte`. Returns how many they are.
template <int Dim, class P>
BRUNT_INLINE int select_row(const MotionRecord<Dim, typename P::Stored>* records, LocalIndex i,
                            const LocalIndex* candidate, int n, LocalIndex* out,
                            std::uint8_t* byte) {
  constexpr bool kKeepsBits = Dim == 3;
  constexpr int kStep = kKeepsBits ? kByte : P::kLanes;
  const auto* own = records[i].data;
  int found = 0;
  const auto take = [&](const LocalIndex* some, unsigned among) __attribute__((always_inline)) {
    unsigned bits = inside_support<Dim, P>(records, own, some);
    if constexpr (kStep > P::kLanes) {
      bits |= inside_support<Dim, P>(records, own, some + P::kLanes) << P::kLanes;
    }
    bits &= among;
    if constexpr (kKeepsBits) *byte++ = static_cast<std::uint8_t>(bits);
    found += append<kStep>(out + found, some, bits);
  };
  int c = 0;
  for (; c + kStep <= n; c += kStep) take(candidate + c, (1U << kStep) - 1U);
  if (c < n) take(Rest(candidate + c, n - c, i).candidate, (1U << (n - c)) - 1U);
  return found;
}

/// Writes those of n candidates whose bits are set to `out`, as select_row does; returns how many.
template <class P>
BRUNT_INLINE int expand_row(LocalIndex i, const LocalIndex* candidate, int n,
                            const std::uint8_t* byte, LocalIndex* out) {
  int found = 0, c = 0;
  for (; c + kByte <= n; c += kByte) found += append<kByte>(out + found, candidate + c, *byte++);
  if (c < n) found += append<kByte>(out + found, Rest(candidate + c, n - c, i).candidate, *byte);
  return found;
}

}  // namespace brunt
// Tested by tests/unit/sph/particles_lists_test.cpp.
