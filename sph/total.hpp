#pragma once
/// Total-Lagrangian particles: gradients at the places of time 0, whose neighbours stay neighbours.
/// docs/theory/sph.md, section 13.
#include <Eigen/Dense>

#include "sph/force_sums.hpp"

namespace brunt {

/// What a particle of formulation: total carries beside its ParticleState.
template <int Dim>
struct TotalState {
  using Matrix = Eigen::Matrix<Real, Dim, Dim, Eigen::RowMajor>;
  Matrix gradient = Matrix::Identity();  ///< [1] F = dx/dX
  Real volume = 0;                       ///< [m^3] at time 0; 0: formulation: updated
  Real seen = 0;                         ///< [m^3] what sums count of it: 0 once it has gone
  Real stretch = 1;                      ///< [1] least principal stretch of F
  Real stiffness_sum = 0;                ///< [Pa/m^2] sum of w_ij (c_i + c_j), for the step limit
  Real damping_sum = 0;                  ///< [Pa s/m^2] of w_ij (eta_i + eta_j)
};

/// Of the limits of a thick neighbourhood (invert_thick): one that does not change has the gradient
/// of any motion to rounding while K can be inverted, as at the tip of a wedge.
inline constexpr Real kTotalSlack = 20;

/// [1] A particle goes from all sums, and flies on as a free point, where its least stretch is
/// below the first, or where it has failed and its volume over that of time 0 is above the second.
inline constexpr Real kCrushed = 0.05, kOpen = 1.1;

/// What neighbours read: its place now, what of x_j - x_i and v_j - v_i its own gradients would
/// have, how stiffly it keeps to them, and the share of it that has not failed, which is in the
/// others.
template <int Dim>
struct alignas(64) TotalRecord {
  static constexpr int kAffine = Dim;                   ///< [Pa] c F + eta dF/dt, by rows
  static constexpr int kStiffness = Dim + Dim * Dim;    ///< [Pa] c
  static constexpr int kDamping = Dim + Dim * Dim + 1;  ///< [Pa s] eta
  static constexpr int kSound = Dim + Dim * Dim + 2;    ///< [1] 1 - D
  static constexpr int kSize = Dim == 3 ? 16 : 12;
  Real data[kSize] = {};  ///< first the position [m]
};

/// Sums over the pairs of a particle. What is artificial stress of updated ones are the forces
/// against motions that strain nothing.
template <int Dim>
struct TotalSums {
  ForceSums<Dim> forces;
  Real stiffness;  ///< [Pa/m^2] sum w_ij (c_i + c_j)
  Real damping;    ///< [Pa s/m^2] sum w_ij (eta_i + eta_j)
};

/// The sums of packs of pairs (i, j): X the arm at time 0, y that of now, v the relative velocity.
template <int Dim>
struct TotalPart {
  StressPart<Dim, DoublePairs> stress;
  Pack viscosity[Dim], hourglass[Dim];
  Pack viscosity_power = {}, hourglass_power = {}, speed2 = {}, mu = {};
  Pack stiffness = {}, damping = {};

  BRUNT_INLINE TotalPart() {
    clear(viscosity);
    clear(hourglass);
  }

  /// (S33): w [(c_i + c_j) y + (eta_i + eta_j) v - (M_i + M_j) X], M = c F + eta dF/dt, each times
  /// what of the other has not failed.
  BRUNT_INLINE void add_hourglass(const PairPack<Dim>& pair, const Pack (&y)[Dim], const Real* own,
                                  const Pack* other) {
    using Record = TotalRecord<Dim>;
    const Pack sound = other[Record::kSound];
    const Real own_sound = own[Record::kSound];
    const auto both = [&](int k) { return own_sound * other[k] + sound * own[k]; };
    const Pack c = both(Record::kStiffness), eta = both(Record::kDamping);
    for (int a = 0; a < Dim; ++a) {
      Pack push = vfma(c, y[a], eta * pair.velocity[a]);
      for (int b = 0; b < Dim; ++b) {
        push = push - both(Record::kAffine + Dim * a + b) * pair.arm[b];
      }
      push = pair.weight * push;
      hourglass[a] = hourglass[a] + push;
      hourglass_power = vfma(push, pair.velocity[a], hourglass_power);
    }
    // what fills the row up is i itself
    const Pack weight = select(0.0 < pair.q2, pair.weight, broadcast<Pack>(0.0));
    stiffness = vfma(weight, c, stiffness);
    damping = vfma(weight, eta, damping);
  }

  /// Monaghan's, as in (S15), (S16), along y: w (X^2/(y^2 + 0.01 h^2)) y stands for the gradient at
  /// the present places. Across a crack it fades: what has failed and is stretched brakes nothing.
  /// sound  [1] of both
  BRUNT_INLINE void add_viscosity(const PairPack<Dim>& pair, const Pack (&y)[Dim], Pack sound,
                                  const Real* own_stress, Pack sound_speed, Pack density,
                                  const SphPairOptions& options) {
    using Record = StressRecord<Dim>;
    Pack approach = pair.velocity[0] * y[0], square = y[0] * y[0];
    Pack fast = pair.velocity[0] * pair.velocity[0];
    for (int a = 1; a < Dim; ++a) {
      approach = vfma(pair.velocity[a], y[a], approach);
      square = vfma(y[a], y[a], square);
      fast = vfma(pair.velocity[a], pair.velocity[a], fast);
    }
    const Real own_density = own_stress[Record::kDensity];
    const Pack now2 = square * (pair.inverse_h * pair.inverse_h);
    const Pack ratio2 = now2 + 0.01;
    const Pack acts = select(pair.q2 < now2, sound, broadcast<Pack>(1.0));
    const Pack inverse = 1.0 / ratio2;
    const Pack least = vmin(pair.inverse_h * approach * inverse, broadcast<Pack>(0.0));
    const Pack mean_density = (2 * own_density) * density / (density + own_density);
    const Pack c = 0.5 * (sound_speed + own_stress[Record::kSoundSpeed]);
    const Pack push = (mean_density * pair.weight) * (acts * pair.q2 * inverse) *
                      (least * (options.alpha * c - options.beta * least));
    for (int a = 0; a < Dim; ++a) viscosity[a] = vfma(push, y[a], viscosity[a]);
    viscosity_power = vfma(push, approach, viscosity_power);
    mu = vmin(mu, least);
    speed2 = vmax(speed2, fast);
  }
};

/// Forces of a particle. Packs are of four on any processor.
/// docs/theory/sph.md (S32) to (S34).
/// weights  [1/m^2] that the first pass gave to the row, in the plane
template <int Dim, class Kernel>
TotalSums<Dim> sum_total(const ForceRecords<Dim>& records, const TotalRecord<Dim>* total,
                         LocalIndex i, std::span<const LocalIndex> row, const Real* weights,
                         const SphPairOptions& options) {
  using Record = StressRecord<Dim>;
  constexpr int g = Record::kScalars;
  const Real *own = total[i].data, *own_stress = records.stress[i].data;
  TotalPart<Dim> part;
  for (std::size_t k = 0; k < row.size(); k += kLanes) {
    const LocalIndex* j = row.data() + k;
    PairPack<Dim> pair;
    set_pair<Dim, Kernel>(records, i, j, Dim == 2 ? weights + k : nullptr, pair);
    Pack other[TotalRecord<Dim>::kSize], stress[4], y[Dim];
    for (int n = 0; n < TotalRecord<Dim>::kSize; n += 4) {
      load_four<DoublePairs>(total, j, n, other + n);
    }
    load_four<DoublePairs>(records.stress, j, g, stress);
    for (int a = 0; a < Dim; ++a) y[a] = other[a] - own[a];
    if constexpr (Dim == 3) pair.last_stress = stress[0];
    part.stress.add(records.stress, j, pair);
    part.add_hourglass(pair, y, own, other);
    const Pack sound = own[TotalRecord<Dim>::kSound] * other[TotalRecord<Dim>::kSound];
    part.add_viscosity(pair, y, sound, own_stress, stress[Record::kSoundSpeed - g],
                       stress[Record::kDensity - g], options);
  }
  TotalSums<Dim> sums;
  Real arm[Dim];
  for (int a = 0; a < Dim; ++a) arm[a] = sum_lanes(part.stress.arm[a]);
  for (int a = 0; a < Dim; ++a) {
    sums.forces.stress[a] = sum_lanes(part.stress.force[a]);
    for (int b = 0; b < Dim; ++b) sums.forces.stress[a] += own_stress[Dim * a + b] * arm[b];
    sums.forces.viscosity[a] = sum_lanes(part.viscosity[a]);
    sums.forces.artificial[a] = sum_lanes(part.hourglass[a]);
  }
  sums.forces.viscosity_power = 0.5 * sum_lanes(part.viscosity_power);
  sums.forces.artificial_power = 0.5 * sum_lanes(part.hourglass_power);
  sums.forces.speed = std::sqrt(max_lanes(part.speed2));
  sums.forces.mu = max_lanes(-part.mu);
  sums.stiffness = sum_lanes(part.stiffness);
  sums.damping = sum_lanes(part.damping);
  return sums;
}

}  // namespace brunt
// Tested by tests/unit/sph/total_test.cpp.
