#pragma once
/// What kernels of conduction share, whatever the element: N corners, four elements at a time.
#include "fe/conduction.hpp"

namespace brunt {

/// int grad N_I . grad N_J dV of four elements [m]; read for I < J.
template <int N>
using GradientProducts = Pack[N][N];

template <int N>
BRUNT_INLINE void gather_temperature(const LocalIndex* corner, const Real* temperature,
                                     Pack (&T)[N]) {
  for (int I = 0; I < N; ++I) {
    T[I] = Pack{temperature[corner[I]], temperature[corner[N + I]], temperature[corner[2 * N + I]],
                temperature[corner[3 * N + I]]};
  }
}

/// Conductivity [W/m/K] at the mean temperature of the corners.
template <int N>
BRUNT_INLINE Pack conductivity(const Varying& k, const Pack (&T)[N]) {
  if (k.is_constant()) return broadcast<Pack>(k.constant);
  Pack mean = T[0];
  for (int I = 1; I < N; ++I) mean += T[I];
  mean = (1.0 / N) * mean;
  return Pack{k.at(mean[0]), k.at(mean[1]), k.at(mean[2]), k.at(mean[3])};
}

/// Writes heat rates and conductances of the corners of four elements from e on, and adds the
/// mechanical heat of the step.
template <int N, int Dim>
BRUNT_INLINE void exchange_heat(ElementBlock<Dim>& block, std::size_t e,
                                const GradientProducts<N>& K, const ConductionStep<Dim>& step) {
  Pack T[N], heat[N], sum[N], all[N];
  gather_temperature(block.corner.data() + e * N, step.temperature, T);
  const Pack k = conductivity(block.material->conductivity, T);
  for (int I = 0; I < N; ++I) heat[I] = sum[I] = all[I] = broadcast<Pack>(0);
  for (int I = 0; I < N; ++I) {
    for (int J = I + 1; J < N; ++J) {
      const Pack coupling = k * K[I][J];
      const Pack flow = coupling * (T[I] - T[J]);  // from J to I where K_IJ < 0
      heat[I] += flow, heat[J] -= flow;
      sum[I] += coupling, sum[J] += coupling;
      all[I] += vabs(coupling), all[J] += vabs(coupling);
    }
  }
  for (int I = 0; I < N; ++I) {
    const Pack conductance = 0.5 * (all[I] + vabs(sum[I]));  // K_II = - sum of the others
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      Real* out = step.corner_heat + 2 * ((e + lane) * N + slot_of(I));
      out[0] = heat[I][lane], out[1] = conductance[lane];
    }
  }
  if (step.inverse_dt > 0 && !block.heat_given.empty()) add_mechanical_heat(block, e, step);
}

/// What elements of one material point see: the mean of their corners, by their shares.
template <int N, int Dim>
BRUNT_INLINE void mean_temperature(ElementBlock<Dim>& block, std::size_t e,
                                   const Real* temperature) {
  Pack T[N], sum = broadcast<Pack>(0);
  gather_temperature(block.corner.data() + e * N, temperature, T);
  for (int I = 0; I < N; ++I) {
    const Real* share = block.heat_share.data() + e * N + I;
    sum += Pack{share[0], share[N], share[2 * N], share[3 * N]} * T[I];
  }
  store(block.state.temperature.data() + e, sum);
}

}  // namespace brunt
// Tested by tests/unit/fe/conduction_test.cpp.
