#pragma once
/// Heat between particles of one body, in pairs.
#include "sph/pair_sums.hpp"

namespace brunt {

/// What a particle shows of its heat: temperature [K], conductivity [W/m/K], gradient correction B.
template <int Dim>
struct alignas(64) HeatRecord {
  static constexpr int kTemperature = 0, kConductivity = 1, kCorrection = 2;
  Real data[8] = {};
};

/// Sums of a particle, to be multiplied by its volume.
struct PairHeat {
  Real rate = 0;         ///< [W/m^3]
  Real conductance = 0;  ///< [W/K/m^3]
};

/// r.B r of four pairs [m^2], B one for each lane.
template <int Dim>
BRUNT_INLINE Pack quadratic_form(const Pack (&arm)[Dim], const Pack* B) {
  Pack sum = broadcast<Pack>(0.0);
  for (int a = 0; a < Dim; ++a) {
    sum = sum + B[a] * (arm[a] * arm[a]);
    for (int b = a + 1; b < Dim; ++b) {
      sum = sum + 2.0 * (B[symmetric_place<Dim>(a, b)] * (arm[a] * arm[b]));
    }
  }
  return sum;
}

/// q_i/V_i = sum_j 4 k_i k_j/(k_i + k_j) w_ij g_ij (T_j - T_i), V_j grad_i W = w_ij (x_j - x_i)
///   Cleary & Monaghan 1999; Jubelgas, Springel & Dolag 2004, eq. 13; docs/theory/heat.md (H7)
/// g_ij = min(e.B_i e, e.B_j e), e along the pair: 1 inside a lattice whose sums are exact. At free
/// surfaces, where neighbours are missing, it restores what flows along them. The smaller one is
/// taken because the larger one counts what is missing behind a surface, and where nothing flows
/// it would draw too much. All factors are symmetric, so that heat flows are opposite.
/// weights  [1/m^2] w_ij, as sum_gradients leaves them
template <int Dim>
BRUNT_INLINE PairHeat sum_heat(const MotionRecord<Dim>* motion, const HeatRecord<Dim>* heat,
                               LocalIndex i, std::span<const LocalIndex> row, const Real* weights) {
  using Record = HeatRecord<Dim>;
  const Real* own = heat[i].data;
  const Real T = own[Record::kTemperature], k = own[Record::kConductivity];
  Pack correction[kSymmetric<Dim>];
  for (int c = 0; c < kSymmetric<Dim>; ++c) {
    correction[c] = broadcast<Pack>(own[Record::kCorrection + c]);
  }
  Pack rate = broadcast<Pack>(0.0), conductance = rate;
  for (std::size_t n = 0; n < row.size(); n += kLanes) {
    const LocalIndex* j = row.data() + n;
    PairPack<Dim> pairs;
    set_arms(motion, motion[i].data, j, pairs);
    Pack other[8];
    for (int half = 0; half < 8; half += 4) {
      load_transposed(heat[j[0]].data + half, heat[j[1]].data + half, heat[j[2]].data + half,
                      heat[j[3]].data + half, other + half);
    }
    Pack r2 = pairs.arm[0] * pairs.arm[0];
    for (int d = 1; d < Dim; ++d) r2 = r2 + pairs.arm[d] * pairs.arm[d];
    const Pack form = vmin(quadratic_form<Dim>(pairs.arm, correction),
                           quadratic_form<Dim>(pairs.arm, other + Record::kCorrection));
    const Pack both = other[Record::kConductivity] + k;
    const auto any_conducts = 0.0 < both;
    const Pack mean =
        4.0 * k * other[Record::kConductivity] / select(any_conducts, both, broadcast<Pack>(1.0));
    // the particle itself fills the row up: its arm is 0, and so is what it gives
    const Pack scale = form / vmax(r2, broadcast<Pack>(1e-300));
    const Pack coupling = mean * scale * load(weights + n);
    rate = rate + coupling * (other[Record::kTemperature] - T);
    conductance = conductance + coupling;
  }
  return {sum_lanes(rate), sum_lanes(conductance)};
}

}  // namespace brunt
