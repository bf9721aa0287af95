#pragma once
/// Heat between particles of one body, in pairs.
#include <Eigen/Core>
#include <algorithm>

#include "sph/pair_sums.hpp"

namespace brunt {

/// What a particle shows of its heat: temperature [K], conductivity [W/m/K], 1/sqrt(lambda) [1].
struct alignas(32) HeatRecord {
  static constexpr int kTemperature = 0, kConductivity = 1, kSupplement = 2, kCount = 3;
  Real data[4] = {};
};

/// Sums of a particle, to be multiplied by its volume.
struct PairHeat {
  Real rate = 0;         ///< [W/m^3]
  Real conductance = 0;  ///< [W/K/m^3]
};

/// [1] Completeness of a particle with hardly a neighbour: without it, whatever comes into reach
/// would conduct at once.
inline constexpr Real kLeastCompleteness = 0.02;

/// [1] tr K^17/tr K^16 of a moment K: its largest eigenvalue where the others are less than 0.8 of
/// it, their mean where all are nearly the same, as in a disturbed lattice. 1 inside a lattice
/// whose sums are exact, 0.16 in a row of particles. docs/theory/heat.md (H8).
template <int Dim>
Real completeness(const Real (&moment)[kSymmetric<Dim>]) {
  using Matrix = Eigen::Matrix<Real, Dim, Dim>;
  Matrix K;
  for (int a = 0; a < Dim; ++a) {
    for (int b = 0; b < Dim; ++b) K(a, b) = moment[symmetric_place<Dim>(a, b)];
  }
  Matrix power = K;
  for (int doubled = 0; doubled < 4; ++doubled) power = (power * power).eval();
  const Real trace = power.trace();
  if (!(trace > 0)) return kLeastCompleteness;
  return std::max(power.cwiseProduct(K).sum() / trace, kLeastCompleteness);
}

/// q_i/V_i = sum_j 4 k_i k_j/(k_i + k_j) w_ij g_ij (T_j - T_i), V_j grad_i W = w_ij (x_j - x_i)
///   Cleary & Monaghan 1999; Jubelgas, Springel & Dolag 2004, eq. 13; docs/theory/heat.md (H7)
/// g_ij = 1/sqrt(lambda_i lambda_j) of the completeness of both: 1 inside a lattice. At free
/// surfaces, where neighbours are missing, it restores what flows along them. All factors are
/// symmetric, so that heat flows are opposite.
/// weights  [1/m^2] w_ij, as sum_gradients leaves them
BRUNT_INLINE PairHeat sum_heat(const HeatRecord* heat, LocalIndex i,
                               std::span<const LocalIndex> row, const Real* weights) {
  using Record = HeatRecord;
  const Real* own = heat[i].data;
  const Real T = own[Record::kTemperature], k = own[Record::kConductivity];
  const Real supplement = 4.0 * (k * own[Record::kSupplement]);
  Pack rate = broadcast<Pack>(0.0), conductance = rate;
  for (std::size_t n = 0; n < row.size(); n += kLanes) {
    const LocalIndex* j = row.data() + n;
    Pack other[4];
    load_transposed(heat[j[0]].data, heat[j[1]].data, heat[j[2]].data, heat[j[3]].data, other);
    const Pack both = other[Record::kConductivity] + k;
    const auto any_conducts = 0.0 < both;
    const Pack mean = supplement * (other[Record::kConductivity] * other[Record::kSupplement]) /
                      select(any_conducts, both, broadcast<Pack>(1.0));
    Pack weight = load(weights + n);
    if (n + kLanes >= row.size()) {  // the particle itself fills the row up
      Real kept[kLanes];
      for (int lane = 0; lane < kLanes; ++lane) kept[lane] = j[lane] == i ? 0.0 : weights[n + lane];
      weight = load(kept);
    }
    const Pack coupling = mean * weight;
    rate = rate + coupling * (other[Record::kTemperature] - T);
    conductance = conductance + coupling;
  }
  return {sum_lanes(rate), sum_lanes(conductance)};
}

}  // namespace brunt
