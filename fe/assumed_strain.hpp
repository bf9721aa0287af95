#pragma once
/// Hourglass control by the strains of bending that hourglass modes stand for.
#include "core/simd.hpp"
#include "core/types.hpp"
#include "fe/shape.hpp"

namespace brunt {

/// What resists the strains of bending and twist: elastic constants, per volume.
struct BendingModuli {
  Real uniaxial = 0;  ///< [Pa] E; quadrilaterals: E/(1 - nu^2)
  Real plate = 0;     ///< [Pa] E/(1 - nu^2)
  Real nu = 0;        ///< [1]
  Real shear = 0;     ///< [Pa] G
};

/// The energy of assumed-strain hourglass control and its derivatives, of V elements at once.
///
/// The hourglass part of the positions in an element is sum_a h_a phi_a(xi), phi the modes after
/// the linear ones, and l_i = |l_i| t_i the linear modes, half an edge each, of length L_i at time
/// 0. Fibres along l_i are stretched by beta = h_a.t_i/L_i times what is left of phi_a without
/// xi_i. Assumed are these strains and the twist of layers alone, each layer in plane stress: no
/// shear that bending would cause in parallelepipeds, and no change of volume, so that nothing
/// locks. Belytschko & Bindeman 1991, 1993 (ASQBI), here as a potential of the positions: all
/// forces and moments balance, and turning changes nothing. Lengths of time 0 keep elements that
/// are squeezed flat as stiff against hourglasses as they were.
///   2D: U = V/6 E' (beta_1^2 + beta_2^2)
///   3D: U = V/6 sum over layers [E/(1 - nu^2) (b_i^2 + b_j^2 + 2 nu b_i b_j) + G t^2]
///           + V/18 E sum_i beta_i(xi eta zeta)^2
/// Layer k bends by b_i = h(xi_k xi_i).t_i/L_i and b_j, and twists by
/// t = h(xi_k xi_j).t_i/L_j + h(xi_k xi_i).t_j/L_i.
template <int Dim, class V>
struct AssumedStrainEnergy {
  static constexpr int kHourglass = Shape<Dim>::kHourglass;
  V energy;                         ///< [J]
  V by_hourglass[kHourglass][Dim];  ///< [N] dU/dh
  V by_linear[Dim][Dim];            ///< [N] dU/dl

  /// h  hourglass modes, l  linear modes of the positions [m]
  /// inverse  1/L_i [1/m], volume [m^3]: at time 0
  BRUNT_INLINE AssumedStrainEnergy(const V (&h)[kHourglass][Dim], const V (&l)[Dim][Dim],
                                   const V (&inverse)[Dim], const BendingModuli& moduli, V volume);

 private:
  /// p = h_a . t_i, 1/L_i, and the derivative of U by p.
  struct Products {
    V p[kHourglass][Dim], inverse[Dim];
    V by_p[kHourglass][Dim];

    BRUNT_INLINE V stretch(int a, int i) const { return p[a][i] * inverse[i]; }
    BRUNT_INLINE void pull(int a, int i, V by_stretch) { by_p[a][i] += by_stretch * inverse[i]; }
  };
  BRUNT_INLINE void add_bending(Products& p, const BendingModuli& moduli, V volume);
};

template <int Dim, class V>
BRUNT_INLINE void AssumedStrainEnergy<Dim, V>::add_bending(Products& p, const BendingModuli& moduli,
                                                           V volume) {
  if constexpr (Dim == 2) {
    const V k = (moduli.plate / 3) * volume;
    for (int i = 0; i < 2; ++i) {
      const V bend = p.stretch(0, i);
      energy += 0.5 * k * bend * bend;
      p.pull(0, i, k * bend);
    }
  } else {
    const V plate = (moduli.plate / 3) * volume, twisted = (moduli.shear / 3) * volume;
    for (int layer = 0; layer < 3; ++layer) {
      // Mode xi_layer xi_i is number j, and the other way round (see Shape<3>).
      const int i = (layer + 1) % 3, j = (layer + 2) % 3;
      const V b_i = p.stretch(j, i), b_j = p.stretch(i, j);
      const V m_i = plate * (b_i + moduli.nu * b_j), m_j = plate * (b_j + moduli.nu * b_i);
      energy += 0.5 * (m_i * b_i + m_j * b_j);
      p.pull(j, i, m_i);
      p.pull(i, j, m_j);

      const V twist = p.p[i][i] * p.inverse[j] + p.p[j][j] * p.inverse[i];
      const V moment = twisted * twist;
      energy += 0.5 * moment * twist;
      p.by_p[i][i] += moment * p.inverse[j];
      p.by_p[j][j] += moment * p.inverse[i];
    }
    const V k = (moduli.uniaxial / 9) * volume;
    for (int i = 0; i < 3; ++i) {
      const V bend = p.stretch(3, i);
      energy += 0.5 * k * bend * bend;
      p.pull(3, i, k * bend);
    }
  }
}

template <int Dim, class V>
BRUNT_INLINE AssumedStrainEnergy<Dim, V>::AssumedStrainEnergy(const V (&h)[kHourglass][Dim],
                                                              const V (&l)[Dim][Dim],
                                                              const V (&inverse)[Dim],
                                                              const BendingModuli& moduli, V volume)
    : energy(0.0 * volume) {
  const V none = energy;
  V along[Dim][Dim], shorter[Dim];  // t, 1/|l|
  Products p;
  for (int i = 0; i < Dim; ++i) {
    V square = l[i][0] * l[i][0];
    for (int c = 1; c < Dim; ++c) square += l[i][c] * l[i][c];
    shorter[i] = 1.0 / vsqrt(square);
    p.inverse[i] = inverse[i];
    for (int c = 0; c < Dim; ++c) along[i][c] = shorter[i] * l[i][c];
    for (int a = 0; a < kHourglass; ++a) {
      p.by_p[a][i] = none;
      p.p[a][i] = h[a][0] * along[i][0];
      for (int c = 1; c < Dim; ++c) p.p[a][i] += h[a][c] * along[i][c];
    }
  }
  add_bending(p, moduli, volume);
  for (int i = 0; i < Dim; ++i) {
    V pulled = none;  // along t: what turns l alone moves p
    for (int a = 0; a < kHourglass; ++a) pulled += p.by_p[a][i] * p.p[a][i];
    for (int c = 0; c < Dim; ++c) {
      V sum = none;
      for (int a = 0; a < kHourglass; ++a) sum += p.by_p[a][i] * h[a][c];
      by_linear[i][c] = shorter[i] * (sum - pulled * along[i][c]);
    }
  }
  for (int a = 0; a < kHourglass; ++a) {
    for (int c = 0; c < Dim; ++c) {
      by_hourglass[a][c] = none;
      for (int i = 0; i < Dim; ++i) by_hourglass[a][c] += p.by_p[a][i] * along[i][c];
    }
  }
}

}  // namespace brunt
