#pragma once
/// The true neighbours of a particle, out of its candidates.
#include <algorithm>
#include <array>
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

/// Lanes of a below b, a bit each.
template <class V, class Number>
BRUNT_INLINE unsigned bits_below(V a, Number b) {
#ifdef BRUNT_WIDE
  if constexpr (std::is_same_v<V, Wide>) {
    return _mm512_cmp_pd_mask(a, broadcast<Wide>(b), _CMP_LT_OQ);
  }
#endif
  return mask_bits(a < b);
}

/// Which pairs (i, j) of a pack interact, a bit a lane.
template <int Dim, class P>
BRUNT_INLINE unsigned inside_support(const MotionRecord<Dim, typename P::Stored>* records,
                                     const typename P::Number* own, const LocalIndex* j) {
  PairPack<Dim, P> pairs;
  set_arms(records, own, j, pairs);
  return bits_below(pairs.q2, number_of<typename P::Pack>(P::kSupport));
}

/// Writes those of n candidates that interact with i to `out`, up to a whole pack more; returns how
/// many they are.
template <int Dim, class P>
BRUNT_INLINE int select_row(const MotionRecord<Dim, typename P::Stored>* records, LocalIndex i,
                            const LocalIndex* candidate, int n, LocalIndex* out) {
  const auto* own = records[i].data;
  int found = 0, c = 0;
  for (; c + P::kLanes <= n; c += P::kLanes) {
    const unsigned bits = inside_support<Dim, P>(records, own, candidate + c);
    found += append<P::kLanes>(out + found, candidate + c, bits);
  }
  if (c == n) return found;
  const Rest rest(candidate + c, n - c, i);
  const unsigned among = (1U << (n - c)) - 1U;
  const unsigned bits = inside_support<Dim, P>(records, own, rest.candidate) & among;
  return found + append<P::kLanes>(out + found, rest.candidate, bits);
}

/// Up to eight particles that share candidates; those that lack are the last once more.
using ParticleGroup = std::array<LocalIndex, kByte>;

/// Positions and lengths of a group, a lane each: x_j is compared with all of them at once.
template <int Dim, class P>
struct GroupLanes {
  using Pack = typename P::Pack;
  static constexpr int kPacks = kByte / P::kLanes;
  Pack x[kPacks][Dim], half_inverse[kPacks];

  BRUNT_INLINE GroupLanes(const MotionRecord<Dim, typename P::Stored>* records,
                          const ParticleGroup& group) {
    for (int pack = 0; pack < kPacks; ++pack) {
      Pack part[4];
      load_four<P>(records, group.data() + pack * P::kLanes, 0, part);
      for (int d = 0; d < Dim; ++d) x[pack][d] = part[d];
      half_inverse[pack] = number_of<Pack>(0.5) * part[MotionRecord<Dim>::kInverse];
    }
  }
  /// Which of the group interact with j, a bit each, by the arithmetic of set_arms.
  BRUNT_INLINE unsigned inside_support(const typename P::Number* j) const {
    unsigned bits = 0;
    for (int pack = 0; pack < kPacks; ++pack) {
      Pack arm[Dim];
      for (int d = 0; d < Dim; ++d) arm[d] = difference(j[d], x[pack][d]);
      Pack r2 = arm[0] * arm[0];
      for (int d = 1; d < Dim; ++d) r2 = vfma(arm[d], arm[d], r2);
      const Pack other = broadcast<Pack>(j[MotionRecord<Dim>::kInverse]);
      const Pack inverse_h = vfma(other, broadcast<Pack>(0.5), half_inverse[pack]);
      const Pack q2 = r2 * (inverse_h * inverse_h);
      bits |= bits_below(q2, number_of<Pack>(P::kSupport)) << (pack * P::kLanes);
    }
    return bits;
  }
  /// The same as byte c of a word.
  BRUNT_INLINE std::uint64_t word_of(const typename P::Number* j, int c) const {
    return static_cast<std::uint64_t>(inside_support(j)) << (kByte * c);
  }
};

/// Which of a group are j, a bit each.
BRUNT_INLINE unsigned bits_of(const ParticleGroup& group, LocalIndex j) {
#ifdef BRUNT_WIDE
  __m256i eight;
  std::memcpy(&eight, group.data(), sizeof eight);
  return _mm256_cmpeq_epi32_mask(eight, _mm256_set1_epi32(j));
#else
  using Four = LocalIndex __attribute__((vector_size(16)));
  Four low, high;
  std::memcpy(&low, group.data(), sizeof low);
  std::memcpy(&high, group.data() + kLanes, sizeof high);
  return mask_bits(low == j) | mask_bits(high == j) << kLanes;
#endif
}

/// Eight bytes of eight bits, columns to rows (Warren, Hacker's Delight, 7-3).
BRUNT_INLINE std::uint64_t transposed_bits(std::uint64_t x) {
  std::uint64_t t = (x ^ (x >> 7)) & 0x00AA00AA00AA00AAULL;
  x ^= t ^ (t << 7);
  t = (x ^ (x >> 14)) & 0x0000CCCC0000CCCCULL;
  x ^= t ^ (t << 14);
  t = (x ^ (x >> 28)) & 0x00000000F0F0F0F0ULL;
  return x ^ t ^ (t << 28);
}

/// From the first of a group to its last.
struct GroupRange {
  LocalIndex first, last;

  BRUNT_INLINE explicit GroupRange(const ParticleGroup& group) : first(group[0]), last(group[0]) {
    for (const LocalIndex i : group) {
      first = i < first ? i : first;
      last = i > last ? i : last;
    }
  }
  /// True where any of eight candidates may be of the group. More than a row has do no harm.
  BRUNT_INLINE bool has_any(const LocalIndex* candidate) const {
    std::uint32_t found = 0;
    for (int c = 0; c < kByte; ++c) {
      const auto above = static_cast<std::uint32_t>(candidate[c] - first);
      found |= above <= static_cast<std::uint32_t>(last - first) ? 1U : 0U;
    }
    return found != 0;
  }
};

/// Which of n candidates interact with which of a group, those of the group with themselves left
/// out: of every eight candidates a word, its byte m the bits of member m.
template <int Dim, class P>
BRUNT_INLINE void select_group(const MotionRecord<Dim, typename P::Stored>* records,
                               const ParticleGroup& group, const LocalIndex* candidate, int n,
                               std::uint64_t* word) {
  const GroupLanes<Dim, P> lanes(records, group);
  const GroupRange range(group);
  for (int first = 0; first < n; first += kByte) {
    const int count = n - first < kByte ? n - first : kByte;
    std::uint64_t by_candidate = 0;
    if (count == kByte) {  // a loop of its own, whose shifts are known: 4 % of a step
      for (int c = 0; c < kByte; ++c) {
        by_candidate |= lanes.word_of(records[candidate[first + c]].data, c);
      }
    } else {
      for (int c = 0; c < count; ++c) {
        by_candidate |= lanes.word_of(records[candidate[first + c]].data, c);
      }
    }
    if (range.has_any(candidate + first)) {
      for (int c = 0; c < count; ++c) {
        const std::uint64_t own = bits_of(group, candidate[first + c]);
        by_candidate &= ~(own << (kByte * c));
      }
    }
    *word++ = transposed_bits(by_candidate);
  }
}

/// Writes those of n candidates whose bits are set to `out`, up to two whole packs more; returns
/// how many they are. Reads the candidates in whole eights. byte  every eighth is of this row; the
/// bits beyond n are none
template <class P>
BRUNT_INLINE int expand_row(const LocalIndex* candidate, int n, const std::uint8_t* byte,
                            LocalIndex* out) {
  int found = 0, c = 0;
#ifdef BRUNT_WIDE
  for (; c + kByte < n; c += 2 * kByte) {
    const unsigned bits = byte[c] | static_cast<unsigned>(byte[c + kByte]) << kByte;
    __m512i sixteen;
    std::memcpy(&sixteen, candidate + c, sizeof sixteen);
    sixteen = _mm512_maskz_compress_epi32(static_cast<__mmask16>(bits), sixteen);
    std::memcpy(out + found, &sixteen, sizeof sixteen);
    found += std::popcount(bits);
  }
#endif
  for (; c < n; c += kByte) found += append<kByte>(out + found, candidate + c, byte[c]);
  return found;
}

}  // namespace brunt
// Tested by tests/unit/sph/particles_lists_test.cpp.
