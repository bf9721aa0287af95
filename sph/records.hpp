#pragma once
/// What a particle shows to its neighbours, one record a pass: read four at a time and transposed,
/// so that lane k holds neighbour k. Volumes are areal in 2D (volume over depth), as kernels are.
#include <algorithm>
#include <span>

#include "core/simd.hpp"
#include "sph/kernels.hpp"

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
/// pair is the harmonic mean of both: its inverse needs no division.
template <int Dim>
struct alignas(64) MotionRecord {
  static constexpr int kInverse = Dim;     ///< [1/m] 1/h, after the position
  static constexpr int kVelocity = 4;      ///< [m/s]
  static constexpr int kVolume = 4 + Dim;  ///< [m^Dim]
  Real data[8] = {};
};

/// Stress times gradient correction, row by row; then sound speed, density, and 1 in tension.
template <int Dim>
struct alignas(32) StressRecord {
  static constexpr int kSoundSpeed = Dim * Dim;   ///< [m/s]
  static constexpr int kDensity = Dim * Dim + 1;  ///< [kg/m^3]
  static constexpr int kTension = Dim * Dim + 2;  ///< 1: the artificial stress is not zero
  static constexpr int kSize = Dim == 3 ? 12 : 8;
  Real data[kSize] = {};
};

/// Artificial stress [Pa], symmetric.
template <int Dim>
struct alignas(32) ArtificialRecord {
  Real data[Dim == 3 ? 8 : 4] = {};
};

/// Four rows of four numbers: out[c] holds component c of the rows at a, b, c and d.
BRUNT_INLINE void load_transposed(const Real* a, const Real* b, const Real* c, const Real* d,
                                  Pack* out) {
  const Pack ra = load(a), rb = load(b), rc = load(c), rd = load(d);
  const Pack ab_even = __builtin_shufflevector(ra, rb, 0, 4, 2, 6);
  const Pack ab_odd = __builtin_shufflevector(ra, rb, 1, 5, 3, 7);
  const Pack cd_even = __builtin_shufflevector(rc, rd, 0, 4, 2, 6);
  const Pack cd_odd = __builtin_shufflevector(rc, rd, 1, 5, 3, 7);
  out[0] = __builtin_shufflevector(ab_even, cd_even, 0, 1, 4, 5);
  out[1] = __builtin_shufflevector(ab_odd, cd_odd, 0, 1, 4, 5);
  out[2] = __builtin_shufflevector(ab_even, cd_even, 2, 3, 6, 7);
  out[3] = __builtin_shufflevector(ab_odd, cd_odd, 2, 3, 6, 7);
}

/// Sum of the lanes in a fixed order.
BRUNT_INLINE Real sum_lanes(Pack a) { return (a[0] + a[1]) + (a[2] + a[3]); }
BRUNT_INLINE Real max_lanes(Pack a) { return vmax(vmax(a[0], a[1]), vmax(a[2], a[3])); }

/// (r/h)^2 of four pairs (i, j): they interact where it is below 4.
template <int Dim>
struct SquaredRatio {
  Pack inverse_h;  ///< [1/m]
  Pack q2;         ///< [1]

  BRUNT_INLINE SquaredRatio(const MotionRecord<Dim>* records, const Real* own,
                            const LocalIndex* j) {
    constexpr int inverse = MotionRecord<Dim>::kInverse;
    Pack part[4];
    load_transposed(records[j[0]].data, records[j[1]].data, records[j[2]].data, records[j[3]].data,
                    part);
    Pack r2 = (part[0] - own[0]) * (part[0] - own[0]);
    for (int d = 1; d < Dim; ++d) r2 = r2 + (part[d] - own[d]) * (part[d] - own[d]);
    inverse_h = 0.5 * (part[inverse] + own[inverse]);
    q2 = r2 * (inverse_h * inverse_h);
  }
};

/// Four pairs (i, j): what every pair sum starts from.
template <int Dim>
struct FourPairs {
  using Record = MotionRecord<Dim>;
  Pack arm[Dim];       ///< [m] x_j - x_i
  Pack velocity[Dim];  ///< [m/s] v_j - v_i
  Pack inverse_h;      ///< [1/m]
  Pack q2;             ///< [1] (r/h)^2
  Pack volume;         ///< [m^Dim] of j

  /// own  record of i;  j  four places
  BRUNT_INLINE FourPairs(const Record* records, const Real* own, const LocalIndex* j) {
    const Real *a = records[j[0]].data, *b = records[j[1]].data, *c = records[j[2]].data,
               *d = records[j[3]].data;
    Pack first[4], second[4];
    load_transposed(a, b, c, d, first);
    load_transposed(a + 4, b + 4, c + 4, d + 4, second);
    for (int k = 0; k < Dim; ++k) {
      arm[k] = first[k] - own[k];
      velocity[k] = second[k] - own[Record::kVelocity + k];
    }
    Pack r2 = arm[0] * arm[0];
    for (int k = 1; k < Dim; ++k) r2 = r2 + arm[k] * arm[k];
    inverse_h = 0.5 * (first[Record::kInverse] + own[Record::kInverse]);
    q2 = r2 * (inverse_h * inverse_h);
    volume = second[Record::kVolume - 4];
  }
};

/// Kernel factors of a stretch of a row, ahead of its sums: roots and divisions of many pairs run
/// side by side instead of each holding up the sums of its own pair.
struct RowFactors {
  static constexpr std::size_t kLength = 64;
  alignas(32) Real weight[kLength];  ///< [1/m^(Dim+2)] w in grad_i W = w (x_j - x_i), w >= 0
  alignas(32) Real value[kLength];   ///< [1] f(q), where asked for
};

/// Fills the factors of n pairs (i, j), n a multiple of kLanes up to RowFactors::kLength.
template <int Dim, class Kernel, bool with_value>
BRUNT_INLINE void weigh(const MotionRecord<Dim>* records, const Real* own, const LocalIndex* j,
                        std::size_t n, RowFactors& factors) {
  for (std::size_t k = 0; k < n; k += kLanes) {
    const SquaredRatio<Dim> four(records, own, j + k);
    const Pack q = vsqrt(four.q2), inverse_h = four.inverse_h;
    Pack inverse_q = {};
    if constexpr (Kernel::kDivides) {
      // beside the root and not after it; below the smallest ratio the force goes to zero
      inverse_q = q * (1.0 / vmax(four.q2, broadcast<Pack>(kSmallestRatio * kSmallestRatio)));
    }
    Pack scale = inverse_h * inverse_h;
    scale = scale * scale;
    if constexpr (Dim == 3) scale = scale * inverse_h;
    const Pack slope = Kernel::slope_over_q(q, inverse_q);
    store(factors.weight + k, (-Kernel::template kAlpha<Dim> * scale) * slope);
    if constexpr (with_value) store(factors.value + k, Kernel::value(q));
  }
}

/// Calls add(pair, w, f, j) for each four pairs of a row: V_j grad_i W = w (x_j - x_i), f(q),
/// places.
template <int Dim, class Kernel, bool with_value, class Add>
BRUNT_INLINE void for_each_four(const MotionRecord<Dim>* records, LocalIndex i,
                                std::span<const LocalIndex> row, Add add) {
  const Real* own = records[i].data;
  RowFactors factors;
  for (std::size_t first = 0; first < row.size(); first += RowFactors::kLength) {
    const std::size_t n = std::min(RowFactors::kLength, row.size() - first);
    const LocalIndex* j = row.data() + first;
    weigh<Dim, Kernel, with_value>(records, own, j, n, factors);
    for (std::size_t k = 0; k < n; k += kLanes) {
      const FourPairs<Dim> pair(records, own, j + k);
      add(pair, pair.volume * load(factors.weight + k), factors.value + k, j + k);
    }
  }
}

}  // namespace brunt
