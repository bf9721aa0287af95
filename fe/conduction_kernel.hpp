#pragma once
/// What kernels of conduction share, whatever the element: N corners, four elements at a time.
#include "fe/conduction.hpp"

namespace brunt {

/// A nodal field at the corners of lanes_of<V> elements.
template <class V, int N>
BRUNT_INLINE void gather_temperature(const LocalIndex* corner, const Real* temperature, V (&T)[N]) {
  for (int I = 0; I < N; ++I) {
    V value{};
    for (int lane = 0; lane < lanes_of<V>; ++lane) {
      value[lane] = temperature[corner[lane * N + I]];
    }
    T[I] = value;
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

/// Writes heat rates and conductances of the corners of lanes_of<V> elements.
/// K     int grad N_I . grad N_J dV [m]; read for I < J
/// k, T  conductivity [W/m/K] of each, and temperatures [K] of the corners
/// to    [element][corner][2]
template <class V, int N>
BRUNT_INLINE void exchange_heat(const V (&K)[N][N], V k, const V (&T)[N], Real* to) {
  V heat[N], sum[N], all[N];
  for (int I = 0; I < N; ++I) heat[I] = sum[I] = all[I] = broadcast<V>(0);
  for (int I = 0; I < N; ++I) {
    for (int J = I + 1; J < N; ++J) {
      const V coupling = k * K[I][J];
      const V flow = coupling * (T[I] - T[J]);  // from J to I where K_IJ < 0
      heat[I] += flow, heat[J] -= flow;
      sum[I] += coupling, sum[J] += coupling;
      all[I] += vabs(coupling), all[J] += vabs(coupling);
    }
  }
  for (int I = 0; I < N; ++I) {
    const V conductance = 0.5 * (all[I] + vabs(sum[I]));  // K_II = - sum of the others
    for (int lane = 0; lane < lanes_of<V>; ++lane) {
      Real* const out = to + 2 * (lane * N + I);
      out[0] = heat[I][lane], out[1] = conductance[lane];
    }
  }
}

/// What elements of one material point see: the mean of their corners, by their shares.
template <int N, int Dim>
BRUNT_INLINE void mean_temperature(ElementBlock<Dim>& block, std::size_t e,
                                   const Real* temperature) {
  const Real* const share = block.heat_share.data() + block.heat_share_at(e, 0);
  Pack T[N];
  gather_temperature(block.corner.data() + e * N, temperature, T);
  Pack mean = load(share) * T[0];
  for (int I = 1; I < N; ++I) mean = vfma(load(share + I * kGroup), T[I], mean);
  store(block.state.temperature.data() + e, mean);
}

}  // namespace brunt
// Tested by tests/unit/fe/conduction_test.cpp.
