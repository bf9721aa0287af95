#pragma once
/// Heat between particles of one body, in pairs.
#include <algorithm>

#include "sph/pair_sums.hpp"

namespace brunt {

/// What a particle shows of its heat: temperature [K], conductivity [W/m/K], 1/sqrt(lambda) [1];
/// and its volume [m^Dim], which the record of its motion has too, on a line that is not read here.
struct alignas(32) HeatRecord {
  static constexpr int kTemperature = 0, kConductivity = 1, kSupplement = 2;
  static constexpr int kCount = 3;  ///< that copies on other ranks are sent
  static constexpr int kVolume = 3;
  Real data[4] = {};
};

/// Records of all particles that the sums read.
template <int Dim>
struct HeatRecords {
  const HeatRecord* heat;
  const MotionRecord<Dim>* motion;
};

/// Sums of a particle, to be multiplied by its volume.
struct PairHeat {
  Real rate = 0;         ///< [W/m^3]
  Real conductance = 0;  ///< [W/K/m^3]
};

/// [1] Completeness of a particle with hardly a neighbour: without it, whatever comes into reach
/// would conduct at once.
inline constexpr Real kLeastCompleteness = 0.02;

/// m <- m m, which is symmetric as m is.
template <int Dim>
BRUNT_INLINE void square_symmetric(Real (&m)[kSymmetric<Dim>]) {
  if constexpr (Dim == 3) {
    const Real a = m[xx], b = m[yy], c = m[zz], p = m[xy], q = m[yz], r = m[zx];
    const Real pp = p * p, qq = q * q, rr = r * r;
    m[xx] = (a * a + pp) + rr, m[yy] = (b * b + pp) + qq, m[zz] = (c * c + qq) + rr;
    m[xy] = p * (a + b) + r * q, m[yz] = q * (b + c) + p * r, m[zx] = r * (a + c) + p * q;
  } else {
    const Real a = m[0], b = m[1], p = m[2];
    m[0] = a * a + p * p, m[1] = b * b + p * p, m[2] = p * (a + b);
  }
}

/// [1] tr K^17/tr K^16 of a moment K: its largest eigenvalue where the others are less than 0.8 of
/// it, their mean where all are nearly the same, as in a disturbed lattice. 1 inside a lattice
/// whose sums are exact, 0.16 in a row of particles. docs/theory/heat.md (H8).
template <int Dim>
Real completeness(const Real (&moment)[kSymmetric<Dim>]) {
  Real power[kSymmetric<Dim>], trace = 0, next = 0;
  std::copy_n(moment, kSymmetric<Dim>, power);
  for (int doubled = 0; doubled < 4; ++doubled) square_symmetric<Dim>(power);
  for (int k = 0; k < kSymmetric<Dim>; ++k) {
    next += (k < Dim ? 1.0 : 2.0) * (power[k] * moment[k]);  // tr K^17
    if (k < Dim) trace += power[k];
  }
  if (!(trace > 0)) return kLeastCompleteness;
  return std::max(next / trace, kLeastCompleteness);
}

/// q_i/V_i = sum_j 4 k_i k_j/(k_i + k_j) w_ij g_ij (T_j - T_i), V_j grad_i W = w_ij (x_j - x_i)
///   Cleary & Monaghan 1999; Jubelgas, Springel & Dolag 2004, eq. 13; docs/theory/heat.md (H7)
/// g_ij = 1/sqrt(lambda_i lambda_j) of the completeness of both: 1 inside a lattice. At free
/// surfaces, where neighbours are missing, it restores what flows along them. All factors are
/// symmetric, so that heat flows are opposite.
/// weights  [1/m^2] w_ij, as sum_gradients leaves them in the plane; in space they are formed
/// again, to the same bits: it takes less time than to write and read them
/// P  DoublePairs or WidePairs
template <int Dim, class Kernel, class P>
BRUNT_INLINE PairHeat sum_heat(const HeatRecords<Dim>& records, LocalIndex i,
                               std::span<const LocalIndex> row, const Real* weights) {
  using Record = HeatRecord;
  using Pack = typename P::Pack;
  const HeatRecord* heat = records.heat;
  const Real* own = heat[i].data;
  const Real T = own[Record::kTemperature], k = own[Record::kConductivity];
  const Real supplement = 4.0 * (k * own[Record::kSupplement]);
  struct HeatPart {
    Pack rate, conductance;
  };
  InTurns<P, HeatPart> sums;
  for (std::size_t turn = 0; turn < P::kTurns; ++turn) {
    auto rate = broadcast<Pack>(0.0), conductance = rate;
    for (std::size_t n = turn * P::kLanes; n < row.size(); n += P::kTurns * P::kLanes) {
      const LocalIndex* j = row.data() + n;
      Pack other[4];
      load_four<P>(heat, j, 0, other);
      const Pack both = other[Record::kConductivity] + k;
      const auto any_conducts = 0.0 < both;
      const Pack mean = supplement * (other[Record::kConductivity] * other[Record::kSupplement]) /
                        select(any_conducts, both, broadcast<Pack>(1.0));
      Pack weight;
      if constexpr (Dim == 2) {
        weight = load_as<Pack>(weights + n);
      } else {
        PairPack<Dim, P> pairs;
        set_arms(records.motion, records.motion[i].data, j, pairs);
        weight = other[Record::kVolume] * kernel_weight<Dim, Kernel>(pairs);
      }
      if (n + P::kLanes >= row.size()) {  // the particle itself fills the row up
        for (int lane = 0; lane < P::kLanes; ++lane) {
          if (j[lane] == i) weight[lane] = 0;
        }
      }
      const Pack coupling = mean * weight;
      rate = vfma(coupling, other[Record::kTemperature] - T, rate);
      conductance = conductance + coupling;
    }
    sums.part[turn] = {rate, conductance};
  }
  return {total(sums, [](const auto& part) { return part.rate; }),
          total(sums, [](const auto& part) { return part.conductance; })};
}

}  // namespace brunt
