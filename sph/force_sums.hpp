#pragma once
/// The second pass over the true neighbours of a particle: forces.
#include "sph/pair_sums.hpp"

namespace brunt {

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
  Pack force[Dim], arm[Dim];

  BRUNT_INLINE StressPart() {
    clear(force);
    clear(arm);
  }
  BRUNT_INLINE void add(const StressRecord<Dim, typename P::Stored>* records, const LocalIndex* j,
                        const PairPack<Dim, P>& pair) {
    using Record = StressRecord<Dim, typename P::Stored>;
    Pack gradient[Dim];
    for (int a = 0; a < Dim; ++a) {
      gradient[a] = pair.weight * pair.arm[a];
      arm[a] = arm[a] + gradient[a];
    }
    for (int g = 0; g < Record::kScalars; g += 4) {
      Pack stress[4];
      load_four<P>(records, j, g, stress);
      for (int k = 0; k < 4; ++k) {
        const int a = (g + k) / Dim, b = (g + k) % Dim;
        force[a] = vfma(stress[k], gradient[b], force[a]);
      }
      if constexpr (kSumsAtOnce<P>) keep_order(force);
    }
    if constexpr (Dim == 3) force[2] = vfma(pair.last_stress, gradient[2], force[2]);
  }
};

/// Monaghan 1992: Pi = (-alpha c mu + beta mu^2)/rho where pairs approach,
/// mu = h v_ij.x_ij/(r^2 + 0.01 h^2), c, rho and h means of the pair (h: harmonic).
/// docs/theory/sph.md (S15), (S16).
template <int Dim, class P>
struct ViscousPart {
  using Pack = typename P::Pack;
  using Number = typename P::Number;
  Pack force[Dim];
  Pack power = {}, largest_mu = {}, largest_speed2 = {};

  BRUNT_INLINE ViscousPart() { clear(force); }
  BRUNT_INLINE void add(const PairPack<Dim, P>& pair, Number own_sound_speed, Number own_density,
                        Pack sound_speed, Pack density, const SphPairOptions& options) {
    const auto alpha = static_cast<Number>(options.alpha), beta = static_cast<Number>(options.beta);
    const auto half = number_of<Pack>(0.5);
    Pack approach = pair.velocity[0] * pair.arm[0], speed2 = pair.velocity[0] * pair.velocity[0];
    for (int a = 1; a < Dim; ++a) {
      approach = vfma(pair.velocity[a], pair.arm[a], approach);
      speed2 = vfma(pair.velocity[a], pair.velocity[a], speed2);
    }
    // one division gives mu = approach/h / (q^2 + 0.01) and 2 rho_i rho_j/(rho_i + rho_j)
    const Pack distance2 = pair.q2 + number_of<Pack>(0.01), densities = density + own_density;
    const Pack inverse = 1.0 / (distance2 * densities);
    const Pack mu = vmin(pair.inverse_h * approach * (densities * inverse), broadcast<Pack>(0.0));
    const Pack both = (2 * own_density) * density * (distance2 * inverse);
    const Pack c =
        vfma(sound_speed, broadcast<Pack>(half), broadcast<Pack>(half * own_sound_speed));
    const Pack push = (both * pair.weight) * (mu * (alpha * c - beta * mu));
    for (int a = 0; a < Dim; ++a) force[a] = vfma(push, pair.arm[a], force[a]);
    power = vfma(push, approach, power);
    largest_mu = vmin(largest_mu, mu);
    largest_speed2 = vmax(largest_speed2, speed2);
  }
};

/// Gray, Monaghan & Swift 2001: the artificial stresses S_i + S_j, times (W(r)/W(dp))^4.
/// docs/theory/sph.md (S19).
template <int Dim, class P>
struct ArtificialPart {
  using Pack = typename P::Pack;
  Pack force[Dim];
  Pack power = {};

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
    for (int a = 0; a < Dim; ++a) {
      Pack row = {};
      for (int b = 0; b < Dim; ++b) {
        const int place = symmetric_place<Dim>(a, b);
        row = vfma(stress[place] + own[place], pair.arm[b], row);
      }
      row = factor * row;
      force[a] = force[a] + row;
      power = vfma(row, pair.velocity[a], power);
    }
  }
};

template <int Dim, class P>
struct ForceParts {
  InTurns<P, StressPart<Dim, P>> stress;
  InTurns<P, ViscousPart<Dim, P>> viscous;
  InTurns<P, ArtificialPart<Dim, P>> artificial;

  /// Numbers of a turn: force and arm of the stress, forces of viscosity and artificial stress,
  /// then the powers of both.
  template <int k>
  BRUNT_INLINE typename P::Pack number(int turn) const {
    constexpr int of = k / Dim, a = k % Dim;
    if constexpr (of == 0) {
      return stress.part[turn].force[a];
    } else if constexpr (of == 1) {
      return stress.part[turn].arm[a];
    } else if constexpr (of == 2) {
      return viscous.part[turn].force[a];
    } else if constexpr (of == 3) {
      return artificial.part[turn].force[a];
    } else {
      return a == 0 ? viscous.part[turn].power : artificial.part[turn].power;
    }
  }
};

/// Packs of a stretch, of one turn, in which the artificial stress acts.
struct TensePacks {
  std::uint32_t pack[RowStretch<3>::kLength / kLanes];
  std::size_t n = 0;
};

/// True where the artificial stress of any of a pack is not zero: 1 is noted then, else 0.
template <class V>
BRUNT_INLINE bool any_tension(V noted) {
  if constexpr (std::is_same_v<V, Wide>) {
    return any_bit(noted);
  } else {
    return any(noted != 0.0);
  }
}

/// The weights of a pack [1/m^2] as the first pass left them.
BRUNT_INLINE void take_weights(const Real* kept, Real, Pack& weight) { weight = load(kept); }
BRUNT_INLINE void take_weights(const Real* kept, Real, Wide& weight) {
  weight = load_as<Wide>(kept);
}
BRUNT_INLINE void take_weights(const Real* kept, Real inverse_unit, SinglePack& weight) {
  weight = joined(inverse_unit * load(kept), inverse_unit * load(kept + kLanes));
}

/// What pairs of i are, beside what they need of its record.
/// weights  [1/m^2] of the first pass; in space they are formed again, to the same bits in double
template <int Dim, class Kernel, class P>
BRUNT_INLINE void set_pair(const ForceRecords<Dim, P>& records, LocalIndex i, const LocalIndex* j,
                           const Real* weights, PairPack<Dim, P>& pair) {
  set_arms(records.motion, records.motion[i].data, j, pair);
  const auto volume = set_velocities(records.motion, records.motion[i].data, j, pair);
  if constexpr (Dim == 2) {
    take_weights(weights, 1 / (records.inverse_length * records.inverse_length), pair.weight);
  } else {
    pair.weight = volume * kernel_weight<Dim, Kernel>(pair);
  }
}

/// Viscosity of a stretch, packs of one turn, and beside it what the other sums need: its pairs and
/// which of them are in tension; where all sums are formed at once, the stress too, and of its
/// pairs those in tension alone.
template <int Dim, class Kernel, class P>
BRUNT_INLINE void add_viscosity(const ForceRecords<Dim, P>& records, LocalIndex i,
                                const LocalIndex* j, const Real* weights, std::size_t turn,
                                std::size_t packs, const SphPairOptions& options,
                                PairPack<Dim, P>* pairs, TensePacks& tense,
                                ForceParts<Dim, P>& parts) {
  using Record = StressRecord<Dim, typename P::Stored>;
  constexpr int g = Record::kScalars;
  const auto* own = records.stress[i].data;
  const auto own_sound_speed = own[Record::kSoundSpeed], own_density = own[Record::kDensity];
  const bool own_tension = own[Record::kTension] != 0;
  ViscousPart<Dim, P> viscous = parts.viscous.part[turn];
  StressPart<Dim, P> stress = parts.stress.part[turn];
  std::size_t found = 0;
  for (std::size_t p = turn; p < packs; p += P::kTurns) {
    const LocalIndex* of_pack = j + p * P::kLanes;
    typename P::Pack part[4];
    PairPack<Dim, P> pair;
    set_pair<Dim, Kernel>(records, i, of_pack, weights + (Dim == 2 ? p * P::kLanes : 0), pair);
    if constexpr (kSumsAtOnce<P>) keep_order(pair.weight);
    load_four<P>(records.stress, of_pack, g, part);
    if constexpr (Dim == 3) pair.last_stress = part[0];
    if constexpr (kSumsAtOnce<P>) stress.add(records.stress, of_pack, pair);
    viscous.add(pair, own_sound_speed, own_density, part[Record::kSoundSpeed - g],
                part[Record::kDensity - g], options);
    const bool in_tension = own_tension | any_tension(part[Record::kTension - g]);
    if (!kSumsAtOnce<P> || in_tension) pairs[p] = pair;
    tense.pack[found] = static_cast<std::uint32_t>(p);
    found += slot_of(int{in_tension});
  }
  tense.n = found;
  parts.viscous.part[turn] = viscous;
  parts.stress.part[turn] = stress;
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

/// Adds the packs of one turn of a stretch of a row.
template <int Dim, class Kernel, class P>
BRUNT_INLINE void add_turn(const ForceRecords<Dim, P>& records, LocalIndex i, const LocalIndex* j,
                           const Real* weights, std::size_t turn, std::size_t packs,
                           const SphPairOptions& options, PairPack<Dim, P>* pairs,
                           ForceParts<Dim, P>& parts) {
  TensePacks tense;
  add_viscosity<Dim, Kernel>(records, i, j, weights, turn, packs, options, pairs, tense, parts);
  if constexpr (!kSumsAtOnce<P>) {
    StressPart<Dim, P> sums = parts.stress.part[turn];
    for (std::size_t p = turn; p < packs; p += P::kTurns) {
      sums.add(records.stress, j + p * P::kLanes, pairs[p]);
    }
    parts.stress.part[turn] = sums;
  }
  if (tense.n == 0) return;
  add_artificial<Dim, Kernel>(records.artificial, i, j, tense, options.inverse_spacing_value, pairs,
                              parts.artificial.part[turn]);
}

/// The largest of a number of each turn; of(part) has it in its lanes.
template <class P, class Part, class Of>
BRUNT_INLINE Real largest(const InTurns<P, Part>& sums, const Of& of) {
  Real most = max_lanes(of(sums.part[0]));
  if constexpr (P::kTurns == 2) most = vmax(most, static_cast<Real>(max_lanes(of(sums.part[1]))));
  return most;
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
  ForceParts<Dim, P> parts;
  RowStretch<Dim, P> stretch;
  for (std::size_t first = 0; first < row.size(); first += length) {
    const std::size_t packs = std::min(length, row.size() - first) / P::kLanes;
    for (std::size_t turn = 0; turn < P::kTurns; ++turn) {
      add_turn<Dim, Kernel>(records, i, row.data() + first, Dim == 2 ? weights + first : nullptr,
                            turn, packs, options, stretch.pairs, parts);
    }
  }
  constexpr int n = 4 * Dim + 2;
  Real all[n];
  totals<n, P>([&]<int k>(int turn, At<k>) { return parts.template number<k>(turn); }, all);
  for (Real& sum : all) sum = in_metres<P>(records.inverse_length, sum);
  ForceSums<Dim> sums;
  for (int a = 0; a < Dim; ++a) {
    sums.stress[a] = all[a];
    for (int b = 0; b < Dim; ++b) sums.stress[a] += own[Dim * a + b] * all[Dim + b];
    sums.viscosity[a] = all[2 * Dim + a];
    sums.artificial[a] = all[3 * Dim + a];
  }
  sums.viscosity_power = 0.5 * all[4 * Dim];
  sums.artificial_power = 0.5 * all[4 * Dim + 1];
  sums.speed = std::sqrt(largest(parts.viscous, [](const auto& p) { return p.largest_speed2; }));
  sums.mu = largest(parts.viscous, [](const auto& part) { return -part.largest_mu; });
  return sums;
}

}  // namespace brunt
// Tested by tests/unit/sph/particles_test.cpp.
