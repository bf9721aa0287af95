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

/// One by one: a whole array at once becomes a call that costs more than the sums of a neighbour.
template <std::size_t n>
BRUNT_INLINE void clear(Pack (&sums)[n]) {
  for (std::size_t k = 0; k < n; ++k) sums[k] = broadcast<Pack>(0.0);
}

template <int Dim, class Kernel>
BRUNT_INLINE GradientSums<Dim> sum_gradients(const MotionRecord<Dim>* motion, LocalIndex i,
                                             std::span<const LocalIndex> row) {
  Pack moment[kSymmetric<Dim>], rate[Dim * Dim];
  clear(moment);
  clear(rate);
  const auto add = [&](const FourPairs<Dim>& pair, Pack weight, const Real*, const LocalIndex*)
      __attribute__((always_inline)) {
    for (int b = 0; b < Dim; ++b) {
      const Pack gradient = weight * pair.arm[b];
      for (int a = 0; a <= b; ++a) {
        Pack& m = moment[symmetric_place<Dim>(a, b)];
        m = m + pair.arm[a] * gradient;
      }
      for (int a = 0; a < Dim; ++a) {
        rate[Dim * a + b] = rate[Dim * a + b] + pair.velocity[a] * gradient;
      }
    }
  };
  for_each_four<Dim, Kernel, false>(motion, i, row, add);
  GradientSums<Dim> sums;
  for (int k = 0; k < kSymmetric<Dim>; ++k) sums.moment[k] = sum_lanes(moment[k]);
  for (int k = 0; k < Dim * Dim; ++k) sums.rate[k] = sum_lanes(rate[k]);
  return sums;
}

/// sum m_j/rho_ij (v_j - v_i) W, rho_ij the mean density: the XSPH velocity [m/s] of i.
template <int Dim, class Kernel>
BRUNT_INLINE Vec<Dim> mean_velocity(const MotionRecord<Dim>* motion,
                                    const StressRecord<Dim>* stress, LocalIndex i,
                                    std::span<const LocalIndex> row) {
  Pack sum[Dim] = {};
  const Real own = stress[i].data[StressRecord<Dim>::kDensity];
  for (std::size_t k = 0; k < row.size(); k += kLanes) {
    const LocalIndex* j = row.data() + k;
    const FourPairs<Dim> pair(motion, motion[i].data, j);
    Pack density;
    for (int lane = 0; lane < kLanes; ++lane) {
      density[lane] = stress[j[lane]].data[StressRecord<Dim>::kDensity];
    }
    Pack value = Kernel::template kAlpha<Dim> * Kernel::value(vsqrt(pair.q2));
    for (int d = 0; d < Dim; ++d) value = value * pair.inverse_h;
    const Pack weight = pair.volume * density * value / (0.5 * (density + own));
    for (int d = 0; d < Dim; ++d) sum[d] = sum[d] + weight * pair.velocity[d];
  }
  Vec<Dim> mean;
  for (int d = 0; d < Dim; ++d) mean[d] = sum_lanes(sum[d]);
  return mean;
}

/// Records of all particles, for the second pass.
template <int Dim>
struct ForceRecords {
  const MotionRecord<Dim>* motion;
  const StressRecord<Dim>* stress;
  const ArtificialRecord<Dim>* artificial;
};

/// Stress divergence of four pairs: the part of i is the sum of w (x_j - x_i), applied at the end.
template <int Dim>
struct StressPart {
  Pack force[Dim];  // sum w T_j (x_j - x_i)
  Pack arm[Dim];    // sum w (x_j - x_i)

  BRUNT_INLINE StressPart() {
    clear(force);
    clear(arm);
  }
  BRUNT_INLINE void add(const FourPairs<Dim>& pair, Pack weight, const Pack* stress) {
    Pack gradient[Dim];
    for (int a = 0; a < Dim; ++a) {
      gradient[a] = weight * pair.arm[a];
      arm[a] = arm[a] + gradient[a];
    }
    for (int a = 0; a < Dim; ++a) {
      Pack row = stress[Dim * a] * gradient[0];
      for (int b = 1; b < Dim; ++b) row = row + stress[Dim * a + b] * gradient[b];
      force[a] = force[a] + row;
    }
  }
};

/// Monaghan 1992: Pi = (-alpha c mu + beta mu^2)/rho where pairs approach,
/// mu = h v_ij.x_ij/(r^2 + 0.01 h^2), c, rho and h means of the pair (h: harmonic).
template <int Dim>
struct ViscousPart {
  Pack force[Dim];
  Pack power = {}, largest_mu = {}, largest_speed2 = {};

  BRUNT_INLINE ViscousPart() { clear(force); }
  BRUNT_INLINE void add(const FourPairs<Dim>& pair, Pack weight, const Real* own, Pack sound_speed,
                        Pack density, const SphPairOptions& options) {
    Pack approach = pair.velocity[0] * pair.arm[0], speed2 = pair.velocity[0] * pair.velocity[0];
    for (int a = 1; a < Dim; ++a) {
      approach = approach + pair.velocity[a] * pair.arm[a];
      speed2 = speed2 + pair.velocity[a] * pair.velocity[a];
    }
    const Real own_density = own[StressRecord<Dim>::kDensity];
    // one division gives mu = approach/h / (q^2 + 0.01) and 2 rho_i rho_j/(rho_i + rho_j)
    const Pack distance2 = pair.q2 + 0.01, densities = density + own_density;
    const Pack inverse = 1.0 / (distance2 * densities);
    const Pack mu = vmin(pair.inverse_h * approach * (densities * inverse), broadcast<Pack>(0.0));
    const Pack both = 2.0 * own_density * density * (distance2 * inverse);
    const Pack c = 0.5 * (sound_speed + own[StressRecord<Dim>::kSoundSpeed]);
    const Pack push = -(both * weight) * (mu * (options.beta * mu - options.alpha * c));
    for (int a = 0; a < Dim; ++a) force[a] = force[a] + push * pair.arm[a];
    power = power + push * approach;
    largest_mu = vmin(largest_mu, mu);
    largest_speed2 = vmax(largest_speed2, speed2);
  }
};

/// Gray, Monaghan & Swift 2001: the artificial stresses S_i + S_j, times (W(r)/W(dp))^4.
template <int Dim>
struct ArtificialPart {
  Pack force[Dim];
  Pack power = {};

  BRUNT_INLINE ArtificialPart() { clear(force); }
  BRUNT_INLINE void add(const FourPairs<Dim>& pair, Pack weight, Pack relative_value,
                        const Real* own, const ArtificialRecord<Dim>* records,
                        const LocalIndex* j) {
    constexpr int groups = Dim == 3 ? 2 : 1;
    Pack stress[4 * groups];
    for (int g = 0; g < groups; ++g) {
      load_transposed(records[j[0]].data + 4 * g, records[j[1]].data + 4 * g,
                      records[j[2]].data + 4 * g, records[j[3]].data + 4 * g, stress + 4 * g);
    }
    const Pack square = relative_value * relative_value;
    const Pack factor = weight * (square * square);
    for (int a = 0; a < Dim; ++a) {
      Pack row = {};
      for (int b = 0; b < Dim; ++b) {
        const int place = symmetric_place<Dim>(a, b);
        row = row + (stress[place] + own[place]) * pair.arm[b];
      }
      row = factor * row;
      force[a] = force[a] + row;
      power = power + row * pair.velocity[a];
    }
  }
};

/// Forces on i per volume of i: sum V_j (T_i + T_j) grad_i W and its viscous and artificial kin,
/// T = sigma B. The artificial part is skipped where it is zero for all four pairs.
template <int Dim, class Kernel>
BRUNT_INLINE ForceSums<Dim> sum_forces(const ForceRecords<Dim>& records, LocalIndex i,
                                       std::span<const LocalIndex> row,
                                       const SphPairOptions& options) {
  using Record = StressRecord<Dim>;
  const Real* own = records.stress[i].data;
  const bool own_tension = own[Record::kTension] != 0;
  StressPart<Dim> stress;
  ViscousPart<Dim> viscous;
  ArtificialPart<Dim> artificial;
  const auto add = [&](const FourPairs<Dim>& pair, Pack weight, const Real* value,
                       const LocalIndex* j) __attribute__((always_inline)) {
    Pack part[Record::kSize];
    for (int g = 0; g < Record::kSize; g += 4) {
      load_transposed(records.stress[j[0]].data + g, records.stress[j[1]].data + g,
                      records.stress[j[2]].data + g, records.stress[j[3]].data + g, part + g);
    }
    stress.add(pair, weight, part);
    viscous.add(pair, weight, own, part[Record::kSoundSpeed], part[Record::kDensity], options);
    if (own_tension || any(part[Record::kTension] != 0.0)) {
      artificial.add(pair, weight, options.inverse_spacing_value * load(value),
                     records.artificial[i].data, records.artificial, j);
    }
  };
  for_each_four<Dim, Kernel, true>(records.motion, i, row, add);
  ForceSums<Dim> sums;
  for (int a = 0; a < Dim; ++a) {
    sums.stress[a] = sum_lanes(stress.force[a]);
    for (int b = 0; b < Dim; ++b) sums.stress[a] += own[Dim * a + b] * sum_lanes(stress.arm[b]);
    sums.viscosity[a] = sum_lanes(viscous.force[a]);
    sums.artificial[a] = sum_lanes(artificial.force[a]);
  }
  sums.viscosity_power = 0.5 * sum_lanes(viscous.power);
  sums.artificial_power = 0.5 * sum_lanes(artificial.power);
  sums.speed = std::sqrt(max_lanes(viscous.largest_speed2));
  sums.mu = max_lanes(-viscous.largest_mu);
  return sums;
}

}  // namespace brunt
