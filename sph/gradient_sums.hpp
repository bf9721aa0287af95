#pragma once
/// The first pass over the true neighbours of a particle: gradients.
#include "sph/pair_sums.hpp"

namespace brunt {

/// Moment matrix K_i = sum V_j (x_j - x_i) (x) grad_i W and rate sum V_j (v_j - v_i) (x) grad_i W.
template <int Dim>
struct GradientSums {
  Real moment[kSymmetric<Dim>];  ///< [1]
  Real rate[Dim * Dim];          ///< [1/s] by rows; times B_i: the velocity gradient
};

/// Sum V_j (v_j - v_i) (x) grad_i W of the packs of a turn.
template <int Dim, class P>
struct RatePart {
  using Pack = typename P::Pack;
  Pack rate[Dim * Dim];

  BRUNT_INLINE RatePart() { clear(rate); }
  BRUNT_INLINE void add(const PairPack<Dim, P>& pair) {
    for (int b = 0; b < Dim; ++b) {
      const Pack gradient = pair.weight * pair.arm[b];
      for (int a = 0; a < Dim; ++a) {
        rate[Dim * a + b] = vfma(pair.velocity[a], gradient, rate[Dim * a + b]);
      }
    }
  }
};

/// Sum V_j (x_j - x_i) (x) grad_i W of the packs of a turn.
template <int Dim, class P>
struct MomentPart {
  using Pack = typename P::Pack;
  Pack moment[kSymmetric<Dim>];

  BRUNT_INLINE MomentPart() { clear(moment); }
  BRUNT_INLINE void add(const PairPack<Dim, P>& pair) {
    for (int b = 0; b < Dim; ++b) {
      const Pack gradient = pair.weight * pair.arm[b];
      for (int a = 0; a <= b; ++a) {
        Pack& sum = moment[symmetric_place<Dim>(a, b)];
        sum = vfma(pair.arm[a], gradient, sum);
      }
    }
  }
};

/// Keeps the weights of a pack of pairs [1/m^2].
BRUNT_INLINE void keep_weights(Pack weight, Real, Real* out) { store(out, weight); }
BRUNT_INLINE void keep_weights(Wide weight, Real, Real* out) { store(out, weight); }
/// unit  [1/m^2] of the weights
BRUNT_INLINE void keep_weights(SinglePack weight, Real unit, Real* out) {
  store(out, unit * low_half(weight));
  store(out + kLanes, unit * high_half(weight));
}

template <int Dim, class P>
struct GradientParts {
  InTurns<P, RatePart<Dim, P>> rate;
  InTurns<P, MomentPart<Dim, P>> moment;
};

/// The sums of a row, all of a pack one after the other.
/// weights  [1/m^2] out; or null
template <int Dim, class Kernel, class P>
BRUNT_INLINE GradientParts<Dim, P> sums_at_once(const MotionRecord<Dim>* motion, LocalIndex i,
                                                std::span<const LocalIndex> row, Real* weights) {
  const MotionRecord<Dim> own = motion[i];  // which no weight that is written can be
  RatePart<Dim, P> rate;
  MomentPart<Dim, P> moment;
  for (std::size_t k = 0; k < row.size(); k += P::kLanes) {
    PairPack<Dim, P> pair;
    set_arms(motion, own.data, row.data() + k, pair);
    pair.weight = kernel_weight<Dim, Kernel>(pair);
    pair.weight = set_velocities(motion, own.data, row.data() + k, pair) * pair.weight;
    rate.add(pair);
    moment.add(pair);
    if (weights != nullptr) keep_weights(pair.weight, 1, weights + k);
  }
  return {{{rate}}, {{moment}}};
}

/// Adds a stretch of a row, one sum after the other.
/// unit  [1/m^2] of weights
template <int Dim, class Kernel, class P>
BRUNT_INLINE void add_stretch(const MotionRecord<Dim, typename P::Stored>* motion, LocalIndex i,
                              const LocalIndex* j, std::size_t n, Real unit, Real* weights,
                              PairPack<Dim, P>* pairs, GradientParts<Dim, P>& parts) {
  const auto* own = motion[i].data;
  const std::size_t packs = n / P::kLanes;
  for (std::size_t p = 0; p < packs; ++p) {
    set_arms(motion, own, j + p * P::kLanes, pairs[p]);
    pairs[p].weight = kernel_weight<Dim, Kernel>(pairs[p]);
  }
  for (std::size_t turn = 0; turn < P::kTurns; ++turn) {
    RatePart<Dim, P> rate = parts.rate.part[turn];
    for (std::size_t p = turn; p < packs; p += P::kTurns) {
      pairs[p].weight = set_velocities(motion, own, j + p * P::kLanes, pairs[p]) * pairs[p].weight;
      rate.add(pairs[p]);
    }
    parts.rate.part[turn] = rate;
    MomentPart<Dim, P> moment = parts.moment.part[turn];
    for (std::size_t p = turn; p < packs; p += P::kTurns) {
      if (weights != nullptr) keep_weights(pairs[p].weight, unit, weights + p * P::kLanes);
      moment.add(pairs[p]);
    }
    parts.moment.part[turn] = moment;
  }
}

/// The sums of a row, a stretch at a time.
template <int Dim, class Kernel, class P>
BRUNT_INLINE GradientParts<Dim, P> sums_by_stretches(
    const MotionRecord<Dim, typename P::Stored>* motion, LocalIndex i,
    std::span<const LocalIndex> row, Real unit, Real* weights) {
  constexpr std::size_t length = RowStretch<Dim, P>::kLength;
  GradientParts<Dim, P> parts;
  RowStretch<Dim, P> stretch;
  for (std::size_t first = 0; first < row.size(); first += length) {
    const std::size_t n = std::min(length, row.size() - first);
    add_stretch<Dim, Kernel>(motion, i, row.data() + first, n, unit,
                             weights == nullptr ? nullptr : weights + first, stretch.pairs, parts);
  }
  return parts;
}

/// What is left in lanes, summed.
template <int Dim, class P>
BRUNT_INLINE GradientSums<Dim> lanes_summed(const GradientParts<Dim, P>& parts,
                                            Real inverse_length) {
  constexpr int n = kSymmetric<Dim>;
  Real all[n + Dim * Dim];
  const auto of = [&]<int k>(int turn, At<k>) {
    if constexpr (k < n) {
      return parts.moment.part[turn].moment[k];
    } else {
      return parts.rate.part[turn].rate[k - n];
    }
  };
  totals<n + Dim * Dim, P>(of, all);
  GradientSums<Dim> sums;
  for (int k = 0; k < n; ++k) sums.moment[k] = all[k];
  for (int k = 0; k < Dim * Dim; ++k) sums.rate[k] = in_metres<P>(inverse_length, all[n + k]);
  return sums;
}

/// The first pass over the row of a particle.
/// inverse_length  [1/m] of the unit of length; 1 in double precision
/// weights  [1/m^2] V_j grad_i W = weight (x_j - x_i) of each pair of the row, out; or null
template <int Dim, class Kernel, class P>
BRUNT_INLINE GradientSums<Dim> sum_gradients(const MotionRecord<Dim, typename P::Stored>* motion,
                                             LocalIndex i, std::span<const LocalIndex> row,
                                             Real inverse_length, Real* weights) {
  if constexpr (kSumsAtOnce<P>) {
    return lanes_summed<Dim, P>(sums_at_once<Dim, Kernel, P>(motion, i, row, weights), 1);
  } else {
    const Real unit = inverse_length * inverse_length;
    return lanes_summed<Dim, P>(sums_by_stretches<Dim, Kernel, P>(motion, i, row, unit, weights),
                                inverse_length);
  }
}

}  // namespace brunt
// Tested by tests/unit/sph/particles_test.cpp.
