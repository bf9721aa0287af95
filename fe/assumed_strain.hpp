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
/// the linear ones, and l_i the linear modes, half an edge each. Fibres along l_i are stretched by
/// beta = h_a.l_i/|l_i|^2 times what is left of phi_a without xi_i. Assumed are these strains and
/// the twist of layers alone, each layer in plane stress: no shear that bending would cause in
/// parallelepipeds, and no change of volume, so that nothing locks. Belytschko & Bindeman 1991,
/// 1993 (ASQBI), here as a potential of the positions: all forces and moments balance, turning
/// changes nothing, and the energy given is the energy stored.
///   2D: U = V/6 E' (beta_1^2 + beta_2^2)
///   3D: U = V/6 sum over layers [E/(1 - nu^2) (b_i^2 + b_j^2 + 2 nu b_i b_j) + G t^2]
///           + V/18 E sum_i beta_i(xi eta zeta)^2
/// Layer k bends by b_i = h(xi_k xi_i).l_i/|l_i|^2 and b_j, and twists by
/// t = (h(xi_k xi_j).l_i + h(xi_k xi_i).l_j)/(|l_i| |l_j|).
template <int Dim, class V>
struct AssumedStrainEnergy {
  static constexpr int kHourglass = Shape<Dim>::kHourglass;
  V energy;                         ///< [J]
  V by_hourglass[kHourglass][Dim];  ///< [N] dU/dh
  V by_linear[Dim][Dim];            ///< [N] dU/dl

  /// h  hourglass modes, l  linear modes of the positions [m], volume  at time 0 [m^3]
  BRUNT_INLINE AssumedStrainEnergy(const V (&h)[kHourglass][Dim], const V (&l)[Dim][Dim],
                                   const BendingModuli& moduli, V volume);

 private:
  /// s = h_a . l_i and 1/|l_i|, and the derivatives of U by s and |l_i|^2.
  struct Products {
    V s[kHourglass][Dim], inverse[Dim];
    V by_s[kHourglass][Dim], by_square[Dim];

    BRUNT_INLINE V stretch(int a, int i) const { return s[a][i] * (inverse[i] * inverse[i]); }
    /// Adds what a stretch of derivative dU/d(stretch) does.
    BRUNT_INLINE void pull(int a, int i, V by_stretch) {
      const V pull = by_stretch * (inverse[i] * inverse[i]);
      by_s[a][i] += pull;
      by_square[i] -= pull * stretch(a, i);
    }
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

      const V inverse = p.inverse[i] * p.inverse[j];
      const V twist = (p.s[i][i] + p.s[j][j]) * inverse;
      const V moment = twisted * twist;
      energy += 0.5 * moment * twist;
      p.by_s[i][i] += moment * inverse;
      p.by_s[j][j] += moment * inverse;
      p.by_square[i] -= 0.5 * moment * twist * (p.inverse[i] * p.inverse[i]);
      p.by_square[j] -= 0.5 * moment * twist * (p.inverse[j] * p.inverse[j]);
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
                                                              const BendingModuli& moduli, V volume)
    : energy(0.0 * volume) {
  const V none = energy;
  Products p;
  for (int i = 0; i < Dim; ++i) {
    p.by_square[i] = none;
    V square = l[i][0] * l[i][0];
    for (int c = 1; c < Dim; ++c) square += l[i][c] * l[i][c];
    p.inverse[i] = 1.0 / vsqrt(square);
    for (int a = 0; a < kHourglass; ++a) {
      p.by_s[a][i] = none;
      p.s[a][i] = h[a][0] * l[i][0];
      for (int c = 1; c < Dim; ++c) p.s[a][i] += h[a][c] * l[i][c];
    }
  }
  add_bending(p, moduli, volume);
  for (int c = 0; c < Dim; ++c) {
    for (int a = 0; a < kHourglass; ++a) {
      by_hourglass[a][c] = none;
      for (int i = 0; i < Dim; ++i) by_hourglass[a][c] += p.by_s[a][i] * l[i][c];
    }
    for (int i = 0; i < Dim; ++i) {
      by_linear[i][c] = 2.0 * p.by_square[i] * l[i][c];
      for (int a = 0; a < kHourglass; ++a) by_linear[i][c] += p.by_s[a][i] * h[a][c];
    }
  }
}

}  // namespace brunt
