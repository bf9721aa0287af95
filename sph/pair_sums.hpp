#pragma once
/// The two passes over the true neighbours of a particle. All pair terms are symmetric under the
/// exchange of i and j up to the factor V_i, so that forces are opposite.
#include <span>

#include "sph/kernels.hpp"
#include "sph/records.hpp"

namespace brunt {

/// Moment matrix K_i = sum V_j (x_j - x_i) (x) grad_i W and rate sum V_j (v_j - v_i) (x) grad_i W.
template <int Dim>
struct GradientSums {
  Real moment[kSymmetric<Dim>];  ///< [1]
  Real rate[Dim * Dim];          ///< [1/s] by rows; times B_i: the velocity gradient
};

/// What a pair needs to know beside its records.
struct SphPairOptions {
  Real alpha = 0, beta = 0;        ///< Monaghan viscosity
  Real inverse_spacing_value = 1;  ///< 1/f(dp/h): artificial stress grows as (W(r)/W(dp))^4
};

/// Sums of a particle's second pass, all to be multiplied by its volume [m^3].
template <int Dim>
struct ForceSums {
  Real stress[Dim];       ///< [N/m^3]
  Real viscosity[Dim];    ///< [N/m^3] by Monaghan viscosity
  Real artificial[Dim];   ///< [N/m^3] by artificial stress
  Real viscosity_power;   ///< [W/m^3] half of what the pairs dissipate
  Real artificial_power;  ///< [W/m^3] minus half the power of the pairs' artificial forces
  Real speed;             ///< [m/s] max |v_ij|
  Real mu;                ///< [m/s] max |mu_ij|
};

/// A sum over pairs that has one length below the line, in SI units.
template <class P>
BRUNT_INLINE Real in_metres(Real inverse_length, typename P::Sum sum) {
  if constexpr (kIsSingle<P>) {
    return inverse_length * sum_lanes(sum);
  } else {
    return sum_lanes(sum);
  }
}

/// One by one: a whole array at once becomes a call that costs more than the sums of a neighbour.
template <class Pack, std::size_t n>
BRUNT_INLINE void clear(Pack (&sums)[n]) {
  for (std::size_t k = 0; k < n; ++k) sums[k] = broadcast<Pack>(0.0);
}

/// Adds the rates of a stretch, and volumes to the weights of its pairs.
template <int Dim, class P>
BRUNT_INLINE void add_rates(const MotionRecord<Dim, typename P::Stored>* motion,
                            const typename P::Number* own, const LocalIndex* j, std::size_t n,
                            PairPack<Dim, P>* pairs, typename P::Sum (&rate)[Dim * Dim]) {
  using Pack = typename P::Pack;
  for (std::size_t k = 0; k < n; k += P::kLanes, ++pairs) {
    pairs->weight = set_velocities(motion, own, j + k, *pairs) * pairs->weight;
    for (int b = 0; b < Dim; ++b) {
      const Pack gradient = pairs->weight * pairs->arm[b];
      for (int a = 0; a < Dim; ++a) {
        add_to(rate[Dim * a + b], pairs->velocity[a] * gradient);
      }
    }
  }
}

/// Keeps the weights of a pack of pairs [1/m^2].
BRUNT_INLINE void keep_weights(Pack weight, Real, Real* out) { store(out, weight); }
BRUNT_INLINE void keep_weights(Wide weight, Real, Real* out) { store(out, weight); }
/// unit  [1/m^2] of the weights
BRUNT_INLINE void keep_weights(SinglePack weight, Real unit, Real* out) {
  store(out, unit * low_half(weight));
  store(out + kLanes, unit * high_half(weight));
}
BRUNT_INLINE void take_weights(const Real* kept, Real, Pack& weight) { weight = load(kept); }
BRUNT_INLINE void take_weights(const Real* kept, Real, Wide& weight) {
  weight = load_as<Wide>(kept);
}
BRUNT_INLINE void take_weights(const Real* kept, Real inverse_unit, SinglePack& weight) {
  weight = joined(inverse_unit * load(kept), inverse_unit * load(kept + kLanes));
}

/// Adds the moments of a stretch, and keeps its weights for the second pass where there is room.
template <int Dim, class P>
BRUNT_INLINE void add_moments(std::size_t n, const PairPack<Dim, P>* pairs, Real unit,
                              typename P::Sum (&moment)[kSymmetric<Dim>], Real* weights) {
  using Pack = typename P::Pack;
  for (std::size_t k = 0; k < n; k += P::kLanes, ++pairs) {
    if (weights != nullptr) keep_weights(pairs->weight, unit, weights + k);
    for (int b = 0; b < Dim; ++b) {
      const Pack gradient = pairs->weight * pairs->arm[b];
      for (int a = 0; a <= b; ++a) {
        add_to(moment[symmetric_place<Dim>(a, b)], pairs->arm[a] * gradient);
      }
    }
  }
}

/// The first pass over the row of a particle.
/// inverse_length  [1/m] of the unit of length; 1 in double precision
/// weights  [1/m^2] V_j grad_i W = weight (x_j - x_i) of each pair of the row, out; or null
template <int Dim, class Kernel, class P>
BRUNT_INLINE GradientSums<Dim> sum_gradients(const MotionRecord<Dim, typename P::Stored>* motion,
                                             LocalIndex i, std::span<const LocalIndex> row,
                                             Real inverse_length, Real* weights) {
  constexpr std::size_t length = RowStretch<Dim, P>::kLength;
  const auto* own = motion[i].data;
  const Real unit = inverse_length * inverse_length;
  RowStretch<Dim, P> stretch;
  typename P::Sum moment[kSymmetric<Dim>], rate[Dim * Dim];
  clear(moment);
  clear(rate);
  for (std::size_t first = 0; first < row.size(); first += length) {
    const std::size_t n = std::min(length, row.size() - first);
    const LocalIndex* j = row.data() + first;
    for (std::size_t k = 0; k < n; k += P::kLanes) {
      PairPack<Dim, P>& pairs = stretch.pairs[k / P::kLanes];
      set_arms(motion, own, j + k, pairs);
      pairs.weight = kernel_weight<Dim, Kernel>(pairs);
    }
    add_rates<Dim, P>(motion, own, j, n, stretch.pairs, rate);
    add_moments<Dim, P>(n, stretch.pairs, unit, moment,
                        weights == nullptr ? nullptr : weights + first);
  }
  GradientSums<Dim> sums;
  for (int k = 0; k < kSymmetric<Dim>; ++k) sums.moment[k] = sum_lanes(moment[k]);
  for (int k = 0; k < Dim * Dim; ++k) sums.rate[k] = in_metres<P>(inverse_length, rate[k]);
  return sums;
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

/// Records of all particles, for the second pass.
template <int Dim, class P = DoublePairs>
struct ForceRecords {
  const MotionRecord<Dim, typename P::Stored>* motion;
  const StressRecord<Dim, typename P::Stored>* stress;
  const ArtificialRecord<Dim, typename P::Stored>* artificial;
  Real inverse_length = 1;  ///< [1/m] of the unit of length
};

/// Stress divergence: sum w T_j (x_j - x_i), and sum w (x_j - x_i) for the part of i.
template <int Dim, class P>
struct StressPart {
  using Pack = typename P::Pack;
  typename P::Sum force[Dim];
  typename P::Sum arm[Dim];

  BRUNT_INLINE StressPart() {
    clear(force);
    clear(arm);
  }
  BRUNT_INLINE void add(const StressRecord<Dim, typename P::Stored>* records, const LocalIndex* j,
                        const PairPack<Dim, P>& pair) {
    using Record = StressRecord<Dim, typename P::Stored>;
    Pack gradient[Dim], stress[8];
    for (int a = 0; a < Dim; ++a) {
      gradient[a] = pair.weight * pair.arm[a];
      add_to(arm[a], gradient[a]);
    }
    for (int g = 0; g < Record::kScalars; g += 4) load_four<P>(records, j, g, stress + g);
    for (int a = 0; a < Dim; ++a) {
      Pack row = stress[Dim * a] * gradient[0];
      for (int b = 1; b < Dim; ++b) {
        const int place = Dim * a + b;
        row = row + (place < 8 ? stress[place] : pair.last_stress) * gradient[b];
      }
      add_to(force[a], row);
    }
  }
};

/// Monaghan 1992: Pi = (-alpha c mu + beta mu^2)/rho where pairs approach,
/// mu = h v_ij.x_ij/(r^2 + 0.01 h^2), c, rho and h means of the pair (h: harmonic).
/// docs/theory/sph.md (S15), (S16).
template <int Dim, class P>
struct ViscousPart {
  using Pack = typename P::Pack;
  using Number = typename P::Number;
  typename P::Sum force[Dim];
  typename P::Sum power = {};
  Pack largest_mu = {}, largest_speed2 = {};

  BRUNT_INLINE ViscousPart() { clear(force); }
  BRUNT_INLINE void add(const PairPack<Dim, P>& pair, Number own_sound_speed, Number own_density,
                        Pack sound_speed, Pack density, const SphPairOptions& options) {
    const auto alpha = static_cast<Number>(options.alpha), beta = static_cast<Number>(options.beta);
    Pack approach = pair.velocity[0] * pair.arm[0], speed2 = pair.velocity[0] * pair.velocity[0];
    for (int a = 1; a < Dim; ++a) {
      approach = approach + pair.velocity[a] * pair.arm[a];
      speed2 = speed2 + pair.velocity[a] * pair.velocity[a];
    }
    // one division gives mu = approach/h / (q^2 + 0.01) and 2 rho_i rho_j/(rho_i + rho_j)
    const Pack distance2 = pair.q2 + number_of<Pack>(0.01), densities = density + own_density;
    const Pack inverse = 1.0 / (distance2 * densities);
    const Pack mu = vmin(pair.inverse_h * approach * (densities * inverse), broadcast<Pack>(0.0));
    const Pack both = (2 * own_density) * density * (distance2 * inverse);
    const Pack c = 0.5 * (sound_speed + own_sound_speed);
    const Pack push = -(both * pair.weight) * (mu * (beta * mu - alpha * c));
    for (int a = 0; a < Dim; ++a) add_to(force[a], push * pair.arm[a]);
    add_to(power, push * approach);
    largest_mu = vmin(largest_mu, mu);
    largest_speed2 = vmax(largest_speed2, speed2);
  }
};

/// Gray, Monaghan & Swift 2001: the artificial stresses S_i + S_j, times (W(r)/W(dp))^4.
/// docs/theory/sph.md (S19).
template <int Dim, class P>
struct ArtificialPart {
  using Pack = typename P::Pack;
  typename P::Sum force[Dim];
  typename P::Sum power = {};

  BRUNT_INLINE ArtificialPart() { clear(force); }
  /// relative_value  W(r)/W(dp)
  BRUNT_INLINE void add(const PairPack<Dim, P>& pair, Pack relative_value,
                        const typename P::Number* own,
                        const ArtificialRecord<Dim, typename P::Stored>* records,
                        const LocalIndex* j) {
    constexpr int size = ArtificialRecord<Dim, typename P::Stored>::kSize;
    Pack stress[size];
    for (int g = 0; g < size; g += 4) load_four<P>(records, j, g, stress + g);
    const Pack square = relative_value * relative_value;
    const Pack factor = pair.weight * (square * square);
    Pack powers[Dim];
    for (int a = 0; a < Dim; ++a) {
      Pack row = {};
      for (int b = 0; b < Dim; ++b) {
        const int place = symmetric_place<Dim>(a, b);
        row = row + (stress[place] + own[place]) * pair.arm[b];
      }
      row = factor * row;
      add_to(force[a], row);
      powers[a] = row * pair.velocity[a];
    }
    add_all(power, powers);
  }
};

/// Packs of a stretch in which the artificial stress acts.
struct TensePacks {
  std::uint32_t pack[RowStretch<3>::kLength / kLanes];
  std::size_t n = 0;
};

/// Viscosity of a stretch, and beside it what the other sums need: its pairs and which of them are
/// in tension.
/// weights  [1/m^2] of the first pass; in space they are formed again, to the same bits in double
template <int Dim, class Kernel, class P>
BRUNT_INLINE void add_viscosity(const ForceRecords<Dim, P>& records, LocalIndex i,
                                const LocalIndex* j, const Real* weights, std::size_t n,
                                const SphPairOptions& options, PairPack<Dim, P>* pairs,
                                TensePacks& tense, ViscousPart<Dim, P>& viscous) {
  using Record = StressRecord<Dim, typename P::Stored>;
  using Pack = typename P::Pack;
  constexpr int g = Record::kScalars;
  const auto* own = records.stress[i].data;
  const auto own_sound_speed = own[Record::kSoundSpeed], own_density = own[Record::kDensity];
  const int own_tension = own[Record::kTension] != 0 ? 1 : 0;
  const Real inverse_unit = 1 / (records.inverse_length * records.inverse_length);
  ViscousPart<Dim, P> sums = viscous;
  std::size_t found = 0;
  for (std::size_t p = 0; p < n / P::kLanes; ++p, j += P::kLanes) {
    Pack part[4];
    set_arms(records.motion, records.motion[i].data, j, pairs[p]);
    const Pack volume = set_velocities(records.motion, records.motion[i].data, j, pairs[p]);
    if constexpr (Dim == 2) {
      take_weights(weights + P::kLanes * p, inverse_unit, pairs[p].weight);
    } else {
      pairs[p].weight = volume * kernel_weight<Dim, Kernel>(pairs[p]);
    }
    load_four<P>(records.stress, j, g, part);
    if constexpr (Dim == 3) pairs[p].last_stress = part[0];
    sums.add(pairs[p], own_sound_speed, own_density, part[Record::kSoundSpeed - g],
             part[Record::kDensity - g], options);
    tense.pack[found] = static_cast<std::uint32_t>(p);
    found += slot_of(own_tension | int{any(part[Record::kTension - g] != 0.0)});
  }
  tense.n = found;
  viscous = sums;
}

/// Artificial stress of the packs of a stretch that are in tension.
template <int Dim, class Kernel, class P>
BRUNT_INLINE void add_artificial(const ArtificialRecord<Dim, typename P::Stored>* records,
                                 LocalIndex i, const LocalIndex* j, const TensePacks& tense,
                                 Real inverse_spacing_value, const PairPack<Dim, P>* pairs,
                                 ArtificialPart<Dim, P>& artificial) {
  using Pack = typename P::Pack;
  const auto inverse_value = static_cast<typename P::Number>(inverse_spacing_value);
  ArtificialPart<Dim, P> sums = artificial;
  for (std::size_t t = 0; t < tense.n; ++t) {
    const PairPack<Dim, P>& pair = pairs[tense.pack[t]];
    const Pack value = inverse_value * Kernel::value(vsqrt(pair.q2));
    sums.add(pair, value, records[i].data, records, j + P::kLanes * tense.pack[t]);
  }
  artificial = sums;
}

/// Forces on i per volume of i: sum V_j (T_i + T_j) grad_i W and its viscous and artificial kin,
/// T = sigma B. The artificial part is skipped where it is zero for all pairs of a pack.
/// docs/theory/sph.md (S12).
/// weights  [1/m^2] that the first pass gave to the row, in the plane
template <int Dim, class Kernel, class P>
BRUNT_INLINE ForceSums<Dim> sum_forces(const ForceRecords<Dim, P>& records, LocalIndex i,
                                       std::span<const LocalIndex> row, const Real* weights,
                                       const SphPairOptions& options) {
  constexpr std::size_t length = RowStretch<Dim, P>::kLength;
  const auto* own = records.stress[i].data;
  StressPart<Dim, P> stress;
  ViscousPart<Dim, P> viscous;
  ArtificialPart<Dim, P> artificial;
  RowStretch<Dim, P> stretch;
  TensePacks tense;
  for (std::size_t first = 0; first < row.size(); first += length) {
    const std::size_t n = std::min(length, row.size() - first);
    const LocalIndex* j = row.data() + first;
    add_viscosity<Dim, Kernel>(records, i, j, Dim == 2 ? weights + first : nullptr, n, options,
                               stretch.pairs, tense, viscous);
    StressPart<Dim, P> sums = stress;
    for (std::size_t p = 0; p < n / P::kLanes; ++p) {
      sums.add(records.stress, j + p * P::kLanes, stretch.pairs[p]);
    }
    stress = sums;
    add_artificial<Dim, Kernel>(records.artificial, i, j, tense, options.inverse_spacing_value,
                                stretch.pairs, artificial);
  }
  const auto sum = [&](typename P::Sum a) { return in_metres<P>(records.inverse_length, a); };
  ForceSums<Dim> sums;
  for (int a = 0; a < Dim; ++a) {
    sums.stress[a] = sum(stress.force[a]);
    for (int b = 0; b < Dim; ++b) sums.stress[a] += own[Dim * a + b] * sum(stress.arm[b]);
    sums.viscosity[a] = sum(viscous.force[a]);
    sums.artificial[a] = sum(artificial.force[a]);
  }
  sums.viscosity_power = 0.5 * sum(viscous.power);
  sums.artificial_power = 0.5 * sum(artificial.power);
  sums.speed = std::sqrt(max_lanes(viscous.largest_speed2));
  sums.mu = max_lanes(-viscous.largest_mu);
  return sums;
}

}  // namespace brunt
// Tested by tests/unit/sph/particles_test.cpp.
