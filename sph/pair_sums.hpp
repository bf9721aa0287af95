#pragma once
/// What the passes over the true neighbours of a particle share. All pair terms are symmetric under
/// the exchange of i and j up to the factor V_i, so that forces are opposite.
#include <algorithm>
#include <span>
#include <utility>

#include "sph/kernels.hpp"
#include "sph/records.hpp"

namespace brunt {

/// Sums of a pass that take turns at packs of pairs: the first at each kTurns-th pack from the
/// first on.
template <class P, class Part>
struct InTurns {
  Part part[P::kTurns];
};

/// A sum over all lanes of all turns; sum_of(part) is that of one.
template <class P, class Part, class SumOf>
BRUNT_INLINE Real total(const InTurns<P, Part>& sums, const SumOf& sum_of) {
  if constexpr (P::kTurns == 1) {
    return sum_lanes(sum_of(sums.part[0]));
  } else {
    return sum_lanes(sum_of(sums.part[0]) + sum_of(sums.part[1]));
  }
}

/// A place that the compiler knows.
template <int k>
using At = std::integral_constant<int, k>;

/// Sums over all lanes of all turns of n numbers, with the bits of total(); of(turn, At<k>) is
/// number k. Written out, so that nothing keeps the sums out of registers before.
template <int n, class P, class Of>
BRUNT_INLINE void totals(const Of& of, Real* sums) {
  if constexpr (std::is_same_v<P, WidePairs>) {
    constexpr int kEight = 2 * kLanes;
    alignas(64) Real all[(n + kEight - 1) / kEight * kEight];
    const auto add_eight = [&]<int... k>(auto first, std::integer_sequence<int, k...>) {
      sum_lanes({of(0, At<std::min(first + k, n - 1)>{})...}, all + first);
    };
    const auto add_all = [&]<int... eight>(std::integer_sequence<int, eight...>) {
      (add_eight(At<kEight * eight>{}, std::make_integer_sequence<int, kEight>{}), ...);
    };
    add_all(std::make_integer_sequence<int, (n + kEight - 1) / kEight>{});
    std::copy_n(all, n, sums);
  } else {
    const auto add_all = [&]<int... k>(std::integer_sequence<int, k...>) {
      ((sums[k] =
            [&] {
              if constexpr (P::kTurns == 1)
                return sum_lanes(of(0, At<k>{}));
              else
                return sum_lanes(of(0, At<k>{}) + of(1, At<k>{}));
            }()),
       ...);
    };
    add_all(std::make_integer_sequence<int, n>{});
  }
}

/// A sum over pairs that has one length below the line, in SI units.
template <class P>
BRUNT_INLINE Real in_metres(Real inverse_length, Real sum) {
  return kIsSingle<P> ? inverse_length * sum : sum;
}

/// One by one, written out: a whole array at once, or a loop over it, becomes a call or a slow
/// instruction that costs more than the sums of a neighbour.
template <class Pack, std::size_t n>
BRUNT_INLINE void clear(Pack (&sums)[n]) {
  [&]<std::size_t... k>(std::index_sequence<k...>) { ((sums[k] = broadcast<Pack>(0.0)), ...); }
  (std::make_index_sequence<n>{});
}

/// sum m_j/rho_ij (v_j - v_i) W, rho_ij the mean density: the XSPH velocity [m/s] of i.
template <int Dim, class Kernel>
BRUNT_INLINE Vec<Dim> mean_velocity(const MotionRecord<Dim>* motion,
                                    const StressRecord<Dim>* stress, LocalIndex i,
                                    std::span<const LocalIndex> row) {
  Pack sum[Dim];
  clear(sum);
  const Real own = stress[i].data[StressRecord<Dim>::kDensity];
  for (std::size_t k = 0; k < row.size(); k += kLanes) {
    const LocalIndex* j = row.data() + k;
    PairPack<Dim> pair;
    set_arms(motion, motion[i].data, j, pair);
    const Pack volume = set_velocities(motion, motion[i].data, j, pair);
    Pack density;
    for (int lane = 0; lane < kLanes; ++lane) {
      density[lane] = stress[j[lane]].data[StressRecord<Dim>::kDensity];
    }
    Pack value = Kernel::template kAlpha<Dim> * Kernel::value(vsqrt(pair.q2));
    for (int d = 0; d < Dim; ++d) value = value * pair.inverse_h;
    const Pack weight = volume * density * value / (0.5 * (density + own));
    for (int d = 0; d < Dim; ++d) sum[d] = sum[d] + weight * pair.velocity[d];
  }
  Vec<Dim> mean;
  for (int d = 0; d < Dim; ++d) mean[d] = sum_lanes(sum[d]);
  return mean;
}

}  // namespace brunt
// Tested by tests/unit/sph/particles_test.cpp.
