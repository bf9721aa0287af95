#pragma once
/// What a particle shows to its neighbours, one record a pass: read a pack at a time and
/// transposed, so that lane k holds neighbour k. Volumes are areal in 2D (volume over depth), as
/// kernels are.
#include <algorithm>
#include <bit>
#include <span>

#include "core/transpose.hpp"
#include "sph/kernels.hpp"
#include "sph/pair_precision.hpp"

namespace brunt {

/// Components of a symmetric tensor of the plane or of space: xx, yy(, zz), xy(, yz, zx).
template <int Dim>
inline constexpr int kSymmetric = Dim == 3 ? 6 : 3;

/// Place of component (i, j) among kSymmetric<Dim>.
template <int Dim>
constexpr int symmetric_place(int i, int j) {
  if (i == j) return i;
  if (Dim == 2) return 2;
  return i + j == 1 ? 3 : (i + j == 3 ? 4 : 5);
}

/// Geometry and motion at x(n+1), v(n+1/2); V and h as the density of time n gives them. The h of a
/// pair is the harmonic mean of both: its inverse needs no division. In single precision positions
/// are integers, in steps of 1/kSteps of the unit of length in which arms, h and V are then.
template <int Dim, class P = DoublePairs>
struct alignas(8 * sizeof(typename P::Number)) MotionRecord {
  static constexpr int kInverse = Dim;     ///< [1/m] 1/h, after the position
  static constexpr int kVelocity = 4;      ///< [m/s]
  static constexpr int kVolume = 4 + Dim;  ///< [m^Dim]
  typename P::Number data[8] = {};
};

/// Stress times gradient correction, row by row; then sound speed, density, and 1 in tension.
template <int Dim, class P = DoublePairs>
struct alignas(32) StressRecord {
  static constexpr int kSoundSpeed = Dim * Dim;   ///< [m/s]
  static constexpr int kDensity = Dim * Dim + 1;  ///< [kg/m^3]
  static constexpr int kTension = Dim * Dim + 2;  ///< 1: the artificial stress is not zero
  static constexpr int kSize = Dim == 3 ? 12 : 8;
  static constexpr int kScalars = kSize - 4;  ///< the last four, in space with a stress before
  typename P::Number data[kSize] = {};
};

/// True where neighbours read any stress.
template <int Dim>
bool is_stressed(const StressRecord<Dim>& record) {
  return std::any_of(record.data, record.data + Dim * Dim, [](Real part) { return part != 0; });
}

/// Artificial stress [Pa], symmetric.
template <int Dim, class P = DoublePairs>
struct alignas(32) ArtificialRecord {
  static constexpr int kSize = Dim == 3 ? 8 : 4;
  typename P::Number data[kSize] = {};
};

/// Four rows of four numbers: out[c] holds component c of the rows at a, b, c and d.
BRUNT_INLINE void load_transposed(const Real* a, const Real* b, const Real* c, const Real* d,
                                  Pack* out) {
  transpose(load(a), load(b), load(c), load(d), out);
}

/// Eight rows of four numbers. Two rows are loaded into one register, such that what is interleaved
/// comes out in their order.
BRUNT_INLINE void load_transposed(const Real* const (&row)[2 * kLanes], Wide* out) {
  Wide two[4];  // rows 0 and 2, 1 and 3, 4 and 6, 5 and 7
  for (int k = 0; k < kLanes; ++k) {
    const int first = k < 2 ? k : k + 2;
    two[k] = joined_wide(load(row[first]), load(row[first + 2]));
  }
  const Wide low_even = __builtin_shufflevector(two[0], two[1], 0, 8, 2, 10, 4, 12, 6, 14);
  const Wide low_odd = __builtin_shufflevector(two[0], two[1], 1, 9, 3, 11, 5, 13, 7, 15);
  const Wide high_even = __builtin_shufflevector(two[2], two[3], 0, 8, 2, 10, 4, 12, 6, 14);
  const Wide high_odd = __builtin_shufflevector(two[2], two[3], 1, 9, 3, 11, 5, 13, 7, 15);
  out[0] = __builtin_shufflevector(low_even, high_even, 0, 1, 4, 5, 8, 9, 12, 13);
  out[1] = __builtin_shufflevector(low_odd, high_odd, 0, 1, 4, 5, 8, 9, 12, 13);
  out[2] = __builtin_shufflevector(low_even, high_even, 2, 3, 6, 7, 10, 11, 14, 15);
  out[3] = __builtin_shufflevector(low_odd, high_odd, 2, 3, 6, 7, 10, 11, 14, 15);
}

/// Four numbers of the records of a pack of particles, from number g on.
template <class P, class Record>
BRUNT_INLINE void load_four(const Record* records, const LocalIndex* j, int g,
                            typename P::Pack* out) {
  if constexpr (P::kLanes == kLanes) {
    load_transposed(records[j[0]].data + g, records[j[1]].data + g, records[j[2]].data + g,
                    records[j[3]].data + g, out);
  } else {
    load_transposed({records[j[0]].data + g, records[j[1]].data + g, records[j[2]].data + g,
                     records[j[3]].data + g, records[j[4]].data + g, records[j[5]].data + g,
                     records[j[6]].data + g, records[j[7]].data + g},
                    out);
  }
}

/// Sum of the lanes in a fixed order.
BRUNT_INLINE Real sum_lanes(Pack a) { return (a[0] + a[1]) + (a[2] + a[3]); }
BRUNT_INLINE Real sum_lanes(Wide a) { return sum_lanes(low_half(a) + high_half(a)); }
BRUNT_INLINE Real sum_lanes(SinglePack a) { return sum_lanes(low_half(a) + high_half(a)); }
/// The same of eight, side by side: sums  out.
BRUNT_INLINE void sum_lanes(const Wide (&a)[8], Real* sums) {
  Wide halves[4], quarters[2];  // of sums 0 and 2, 1 and 3, 4 and 6, 5 and 7; of the first four
  for (int k = 0; k < 4; ++k) {
    const int first = k < 2 ? k : k + 2;
    const Wide low = a[first], high = a[first + 2];
    halves[k] = __builtin_shufflevector(low, high, 0, 1, 2, 3, 8, 9, 10, 11) +
                __builtin_shufflevector(low, high, 4, 5, 6, 7, 12, 13, 14, 15);
  }
  for (int k = 0; k < 2; ++k) {
    const Wide low = halves[2 * k], high = halves[2 * k + 1];
    quarters[k] = __builtin_shufflevector(low, high, 0, 8, 2, 10, 4, 12, 6, 14) +
                  __builtin_shufflevector(low, high, 1, 9, 3, 11, 5, 13, 7, 15);
  }
  store(sums, __builtin_shufflevector(quarters[0], quarters[1], 0, 1, 4, 5, 8, 9, 12, 13) +
                  __builtin_shufflevector(quarters[0], quarters[1], 2, 3, 6, 7, 10, 11, 14, 15));
}
BRUNT_INLINE Real max_lanes(Pack a) { return vmax(vmax(a[0], a[1]), vmax(a[2], a[3])); }
BRUNT_INLINE Real max_lanes(Wide a) { return max_lanes(vmax(low_half(a), high_half(a))); }
BRUNT_INLINE Real max_lanes(SinglePack a) { return max_lanes(vmax(low_half(a), high_half(a))); }

/// x_j - x_i of a pack of neighbours along an axis.
BRUNT_INLINE Pack difference(Pack others, Real own) { return others - own; }
BRUNT_INLINE Wide difference(Wide others, Real own) { return others - own; }
/// The same of one neighbour and a pack of particles.
BRUNT_INLINE Pack difference(Real other, Pack own) { return other - own; }
BRUNT_INLINE Wide difference(Real other, Wide own) { return other - own; }
/// Of integer steps, whose difference is exact, wherever the origin is.
BRUNT_INLINE SinglePack difference(SinglePack others, float own) {
  const auto steps = reinterpret_cast<SingleBits>(others) - std::bit_cast<std::uint32_t>(own);
  return static_cast<float>(1 / SinglePairs::kSteps) *
         __builtin_convertvector(reinterpret_cast<SingleMask>(steps), SinglePack);
}

BRUNT_INLINE SinglePack difference(float other, SinglePack own) {
  const auto steps = std::bit_cast<std::uint32_t>(other) - reinterpret_cast<SingleBits>(own);
  return static_cast<float>(1 / SinglePairs::kSteps) *
         __builtin_convertvector(reinterpret_cast<SingleMask>(steps), SinglePack);
}

/// A pack of pairs (i, j) of a row, kept from one sum over the row to the next: each sum runs by
/// itself, so that its accumulators stay in registers, and roots and divisions of many pairs
/// overlap.
template <int Dim, class P = DoublePairs>
struct PairPack {
  using Pack = typename P::Pack;
  Pack arm[Dim];       ///< [m] x_j - x_i
  Pack velocity[Dim];  ///< [m/s] v_j - v_i
  Pack inverse_h;      ///< [1/m]
  Pack q2;             ///< [1] (r/h)^2
  Pack weight;         ///< [1/m^2] w in V_j grad_i W = w (x_j - x_i), w >= 0
  Pack last_stress;    ///< [Pa] T_zz of j, in space
};

/// Pairs of a stretch of a row.
template <int Dim, class P = DoublePairs>
struct RowStretch {
  static constexpr std::size_t kLength = 128;
  PairPack<Dim, P> pairs[kLength / P::kLanes];
};

/// Arms and ratios of a pack of pairs (i, j).
/// own  record of i;  j  as many places as there are lanes
template <int Dim, class P>
BRUNT_INLINE void set_arms(const MotionRecord<Dim, typename P::Stored>* records,
                           const typename P::Number* own, const LocalIndex* j,
                           PairPack<Dim, P>& pairs) {
  using Record = MotionRecord<Dim, typename P::Stored>;
  using Pack = typename P::Pack;
  Pack part[4];
  load_four<P>(records, j, 0, part);
  Pack arm[Dim];
  for (int d = 0; d < Dim; ++d) pairs.arm[d] = arm[d] = difference(part[d], own[d]);
  Pack r2 = arm[0] * arm[0];
  for (int d = 1; d < Dim; ++d) r2 = vfma(arm[d], arm[d], r2);
  const auto half = number_of<Pack>(0.5);
  pairs.inverse_h = vfma(part[Record::kInverse], broadcast<Pack>(half),
                         broadcast<Pack>(half * own[Record::kInverse]));
  pairs.q2 = r2 * (pairs.inverse_h * pairs.inverse_h);
}

/// Relative velocities of a pack of pairs (i, j); returns the volumes of j [m^Dim].
template <int Dim, class P>
BRUNT_INLINE typename P::Pack set_velocities(const MotionRecord<Dim, typename P::Stored>* records,
                                             const typename P::Number* own, const LocalIndex* j,
                                             PairPack<Dim, P>& pairs) {
  using Record = MotionRecord<Dim, typename P::Stored>;
  typename P::Pack part[4];
  load_four<P>(records, j, 4, part);
  for (int d = 0; d < Dim; ++d) pairs.velocity[d] = part[d] - own[Record::kVelocity + d];
  return part[Record::kVolume - 4];
}

/// w of a pack of pairs (i, j) without V_j [1/m^(Dim+2)].
template <int Dim, class Kernel, class P>
BRUNT_INLINE typename P::Pack kernel_weight(const PairPack<Dim, P>& pairs) {
  using Pack = typename P::Pack;
  const Pack q = vsqrt(pairs.q2);
  Pack inverse_q = {};
  if constexpr (Kernel::kDivides) {
    // beside the root and not after it; below the smallest ratio the force goes to zero
    const Pack least = broadcast<Pack>(kSmallestRatio * kSmallestRatio);
    inverse_q = q * (1.0 / (Kernel::kDividesAtRest ? vmax(pairs.q2, least) : pairs.q2));
  }
  Pack scale = pairs.inverse_h * pairs.inverse_h;
  scale = scale * scale;
  if constexpr (Dim == 3) scale = scale * pairs.inverse_h;
  return (number_of<Pack>(-Kernel::template kAlpha<Dim>) * scale) *
         Kernel::slope_over_q(q, inverse_q);
}

}  // namespace brunt
// Tested by tests/unit/sph/particles_lists_test.cpp.
