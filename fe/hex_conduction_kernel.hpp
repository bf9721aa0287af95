#pragma once
/// Conduction in hexahedra with eight Gauss points, in modal coordinates
/// (docs/decisions/229-conduction-in-modes.md).
///
/// int grad N_I . grad N_J dV = 1/64 sum_ab h_aI h_bJ S_ab, with h the signs of the modes at the
/// corners (fe/shape.hpp) and S_ab = int grad phi_a . grad phi_b dV over modes. At a Gauss point,
/// (e1, e2, e3)/sqrt(3) with e = +-1, grad phi_a . grad phi_b dV = p_a . M p_b, with p_a the slopes
/// of mode a and M = cof^T cof/det J. Slopes of modes are products of e, so S is made of sums of M
/// over the Gauss points with the signs of a product of e: of Hadamard's transform of M.
#include "fe/conduction_kernel.hpp"
#include "fe/corner_values.hpp"
#include "fe/shape.hpp"

namespace brunt {

namespace hex_conduction {

/// Bits of a Gauss point (e = 1), and of a product of e: e1 e3 is kE1 + kE3.
inline constexpr int kE1 = 1, kE2 = 2, kE3 = 4;
inline constexpr Real kAbscissa = gauss_place<3>(6)[0];  // 1/sqrt(3), of (1, 1, 1)
inline constexpr int kPoints = 8, kModes = 7, kCorners = 8;
/// Entries of a symmetric matrix.
enum Entry : std::uint8_t { m00, m11, m22, m01, m12, m02, kEntries };

/// Slopes of positions along one local coordinate at the four places of the two others.
template <class V>
using FourSlopes = V[4][3];

/// first, second  modes that grow along the coordinate of bit 0, of bit 1; both: along both
template <class V>
BRUNT_INLINE void four_slopes(const V (&linear)[3], const V (&first)[3], const V (&second)[3],
                              const V (&both)[3], FourSlopes<V>& J) {
  constexpr Real s = kAbscissa;
  for (int i = 0; i < 3; ++i) {
    const V a = s * first[i], b = s * second[i], c = (s * s) * both[i];
    const V less = linear[i] - a, more = linear[i] + a;
    J[0][i] = less - (b - c), J[1][i] = more - (b + c);
    J[2][i] = less + (b - c), J[3][i] = more + (b + c);
  }
}

template <class V>
BRUNT_INLINE V product(const V (&a)[3], const V (&b)[3]) {
  return vfma(a[2], b[2], vfma(a[1], b[1], a[0] * b[0]));
}

/// M/64 at all Gauss points [m].
template <class V>
BRUNT_INLINE void metrics(const Modal<3, V>& c, V (&M)[kEntries][kPoints]) {
  FourSlopes<V> along_1, along_2, along_3;
  four_slopes(c.m[0], c.m[5], c.m[4], c.m[6], along_1);
  four_slopes(c.m[1], c.m[5], c.m[3], c.m[6], along_2);
  four_slopes(c.m[2], c.m[4], c.m[3], c.m[6], along_3);
  for (int g = 0; g < kPoints; ++g) {
    const int e1 = g & 1, e2 = (g >> 1) & 1, e3 = g >> 2;
    const auto& a = along_1[e2 + 2 * e3];
    const auto& b = along_2[e1 + 2 * e3];
    const auto& d = along_3[e1 + 2 * e2];
    V of_1[3], of_2[3], of_3[3];  // rows of the cofactors
    set_cross(b, d, of_1), set_cross(d, a, of_2), set_cross(a, b, of_3);
    const V weight = (1.0 / 64) / product(a, of_1);
    M[m00][g] = weight * product(of_1, of_1);
    M[m11][g] = weight * product(of_2, of_2);
    M[m22][g] = weight * product(of_3, of_3);
    M[m01][g] = weight * product(of_1, of_2);
    M[m12][g] = weight * product(of_2, of_3);
    M[m02][g] = weight * product(of_1, of_3);
  }
}

/// Sums over the Gauss points with the signs of each product of e, in the places of its bits.
template <class V>
BRUNT_INLINE void transform(V (&M)[kPoints]) {
  for (int bit = 1; bit < kPoints; bit *= 2) {
    for (int g = 0; g < kPoints; ++g) {
      if ((g & bit) != 0) continue;
      const V less = M[g], more = M[g | bit];
      M[g] = less + more, M[g | bit] = more - less;
    }
  }
}

/// S/64 [m] of all modes but the constant one, from the transforms W of M/64.
template <class V>
BRUNT_INLINE void mode_products(const V (&W)[kEntries][kPoints], V (&S)[kModes][kModes]) {
  constexpr Real s = kAbscissa, s2 = 1.0 / 3, s3 = s / 3, s4 = 1.0 / 9;
  constexpr int e12 = kE1 + kE2, e23 = kE2 + kE3, e13 = kE1 + kE3, e123 = kE1 + kE2 + kE3;
  const auto &a = W[m00], &b = W[m11], &c = W[m22], &d = W[m01], &f = W[m12], &h = W[m02];
  S[0][0] = a[0], S[1][1] = b[0], S[2][2] = c[0], S[0][1] = d[0], S[1][2] = f[0], S[0][2] = h[0];
  S[0][3] = s * (d[kE3] + h[kE2]);
  S[0][4] = s * (a[kE3] + h[kE1]);
  S[0][5] = s * (a[kE2] + d[kE1]);
  S[1][3] = s * (b[kE3] + f[kE2]);
  S[1][4] = s * (d[kE3] + f[kE1]);
  S[1][5] = s * (d[kE2] + b[kE1]);
  S[2][3] = s * (f[kE3] + c[kE2]);
  S[2][4] = s * (h[kE3] + c[kE1]);
  S[2][5] = s * (h[kE2] + f[kE1]);
  S[0][6] = s2 * ((a[e23] + d[e13]) + h[e12]);
  S[1][6] = s2 * ((d[e23] + b[e13]) + f[e12]);
  S[2][6] = s2 * ((h[e23] + f[e13]) + c[e12]);
  S[3][3] = s2 * ((b[0] + c[0]) + 2.0 * f[e23]);
  S[4][4] = s2 * ((a[0] + c[0]) + 2.0 * h[e13]);
  S[5][5] = s2 * ((a[0] + b[0]) + 2.0 * d[e12]);
  S[3][4] = s2 * ((d[0] + f[e13]) + (h[e23] + c[e12]));
  S[3][5] = s2 * ((h[0] + d[e23]) + (b[e13] + f[e12]));
  S[4][5] = s2 * ((f[0] + a[e23]) + (d[e13] + h[e12]));
  S[3][6] = s3 * (((d[kE2] + h[kE3]) + (b[kE1] + c[kE1])) + 2.0 * f[e123]);
  S[4][6] = s3 * (((d[kE1] + f[kE3]) + (a[kE2] + c[kE2])) + 2.0 * h[e123]);
  S[5][6] = s3 * (((h[kE1] + f[kE2]) + (a[kE3] + b[kE3])) + 2.0 * d[e123]);
  S[6][6] = s4 * (((a[0] + b[0]) + c[0]) + 2.0 * ((d[e12] + h[e13]) + f[e23]));
  for (int m = 1; m < kModes; ++m) {
    for (int n = 0; n < m; ++n) S[m][n] = S[n][m];
  }
}

/// sum_m h_mI value(m) at all corners.
template <class V, class Value>
BRUNT_INLINE void corner_values(const Value& value, V (&at)[kCorners][3]) {
  Modal<3, V> c;
  for (int m = 0; m < kModes; ++m) c.m[m][0] = value(m);
  c.m[kModes][0] = broadcast<V>(0);
  to_corners(c, 0, at);
}

/// int grad N_I . grad N_J dV [m] of hexes with modes c; written for I < J.
template <class V>
BRUNT_INLINE void gradient_products(const Modal<3, V>& c, V (&K)[kCorners][kCorners]) {
  V M[kEntries][kPoints], S[kModes][kModes], half[kModes][kCorners][3];
  metrics(c, M);
  for (auto& entry : M) transform(entry);
  mode_products(M, S);
  for (int m = 0; m < kModes; ++m) {
    corner_values<V>([&](int n) { return S[m][n]; }, half[m]);
  }
  for (int J = 1; J < kCorners; ++J) {
    V at[kCorners][3];
    corner_values<V>([&](int m) { return half[m][J][0]; }, at);
    for (int I = 0; I < J; ++I) K[I][J] = at[I][0];
  }
}

}  // namespace hex_conduction

template <class V>
void conduct_hexes(const LocalIndex* corner, const Real* conductivity,
                   const ConductionStep<3>& step, Real* corner_heat) {
  constexpr int N = hex_conduction::kCorners;
  V node[N][3], K[N][N], T[N];
  gather<3>(corner, step.x, node);
  hex_conduction::gradient_products(modes_of<3>(node), K);
  gather_temperature(corner, step.temperature, T);
  exchange_heat(K, load_as<V>(conductivity), T, corner_heat);
}

}  // namespace brunt
// Tested by tests/unit/fe/conduction_test.cpp.
