#pragma once
/// Hexahedra and quadrilaterals in modal coordinates. A field over an element is
/// a(xi) = sum_m a_m phi_m(xi) with the modes (products of the local coordinates) listed below;
/// nodal values are a_I = sum_m h_mI a_m with h_mI = +-1, so both ways are butterflies of
/// additions. The exact gradient of the volume is B_jI = dV/dx_jI = sum_m h_mI E_jm, E_jm =
/// dV/dc_jm / corners, with c the modal coordinates (Flanagan & Belytschko 1981, eq. 24, in other
/// variables).
#include "core/elements/box_element.hpp"
#include "core/simd.hpp"

namespace brunt {

/// Modal coordinates of a vector field.
template <int Dim, class V>
struct Modal {
  V m[Shape<Dim>::kModes][Dim];
};

/// Component i of the modes from nodal values node[I][i], times a factor.
template <class V>
BRUNT_INLINE void to_modes(const V (&node)[8][3], int i, Modal<3, V>& c, Real factor) {
  const Real w = 0.125 * factor;
  const V s0 = node[4][i] + node[0][i], s1 = node[5][i] + node[1][i];
  const V s2 = node[6][i] + node[2][i], s3 = node[7][i] + node[3][i];
  const V d0 = node[4][i] - node[0][i], d1 = node[5][i] - node[1][i];
  const V d2 = node[6][i] - node[2][i], d3 = node[7][i] - node[3][i];
  const V p = s2 - s0, q = s1 - s3, e = d2 - d0, g = d1 - d3;
  c.m[0][i] = w * (p + q);
  c.m[1][i] = w * (p - q);
  c.m[2][i] = w * ((d0 + d2) + (d1 + d3));
  c.m[3][i] = w * (e - g);
  c.m[4][i] = w * (e + g);
  c.m[5][i] = w * ((s0 + s2) - (s1 + s3));
  c.m[6][i] = w * ((d0 + d2) - (d1 + d3));
  c.m[7][i] = w * ((s0 + s2) + (s1 + s3));
}
template <class V>
BRUNT_INLINE void to_modes(const V (&node)[4][2], int i, Modal<2, V>& c, Real factor) {
  const Real w = 0.25 * factor;
  const V p = node[2][i] - node[0][i], q = node[1][i] - node[3][i];
  c.m[0][i] = w * (p + q);
  c.m[1][i] = w * (p - q);
  c.m[2][i] = w * ((node[0][i] + node[2][i]) - (node[1][i] + node[3][i]));
  c.m[3][i] = w * ((node[0][i] + node[2][i]) + (node[1][i] + node[3][i]));
}
template <int Dim, class V>
BRUNT_INLINE Modal<Dim, V> modes_of(const V (&node)[Shape<Dim>::kCorners][Dim], Real factor = 1) {
  Modal<Dim, V> c;
  for (int i = 0; i < Dim; ++i) to_modes(node, i, c, factor);
  return c;
}

/// Component i of nodal values sum_m h_mI c_m.
template <class V>
BRUNT_INLINE void to_corners(const Modal<3, V>& c, int i, V (&node)[8][3]) {
  const V xi = c.m[0][i], eta = c.m[1][i], zeta = c.m[2][i] + c.m[6][i];
  const V zeta_less = c.m[2][i] - c.m[6][i];
  const V plus = c.m[5][i] + c.m[7][i], minus = c.m[7][i] - c.m[5][i];
  const V sum = xi + eta, difference = xi - eta;
  const V s0 = plus - sum, s2 = plus + sum, s1 = minus + difference, s3 = minus - difference;
  const V twist = c.m[3][i] + c.m[4][i], skew = c.m[4][i] - c.m[3][i];
  const V d0 = zeta - twist, d2 = zeta + twist, d1 = zeta_less + skew, d3 = zeta_less - skew;
  node[0][i] = s0 - d0, node[4][i] = s0 + d0;
  node[1][i] = s1 - d1, node[5][i] = s1 + d1;
  node[2][i] = s2 - d2, node[6][i] = s2 + d2;
  node[3][i] = s3 - d3, node[7][i] = s3 + d3;
}
template <class V>
BRUNT_INLINE void to_corners(const Modal<2, V>& c, int i, V (&node)[4][2]) {
  const V sum = c.m[0][i] + c.m[1][i], difference = c.m[0][i] - c.m[1][i];
  const V plus = c.m[3][i] + c.m[2][i], minus = c.m[3][i] - c.m[2][i];
  node[0][i] = plus - sum, node[2][i] = plus + sum;
  node[1][i] = minus + difference, node[3][i] = minus - difference;
}

template <class V>
BRUNT_INLINE void set_cross(const V (&a)[3], const V (&b)[3], V (&r)[3]) {
  r[0] = difference_of_products(a[1], b[2], a[2], b[1]);
  r[1] = difference_of_products(a[2], b[0], a[0], b[2]);
  r[2] = difference_of_products(a[0], b[1], a[1], b[0]);
}
template <class V>
BRUNT_INLINE void add_cross(const V (&a)[3], const V (&b)[3], V (&r)[3]) {
  r[0] = vfma(a[1], b[2], vfnma(a[2], b[1], r[0]));
  r[1] = vfma(a[2], b[0], vfnma(a[0], b[2], r[1]));
  r[2] = vfma(a[0], b[1], vfnma(a[1], b[0], r[2]));
}
template <class V>
BRUNT_INLINE void add_cross(const V (&a)[3], const V (&b)[3], Real factor, V (&r)[3]) {
  V product[3];
  set_cross(a, b, product);
  for (int i = 0; i < 3; ++i) r[i] = vfma(broadcast<V>(factor), product[i], r[i]);
}

/// E of a hexahedron [m^2]. V/8 = [L1 L2 L3] + ([L1 H3 H2] + [H3 L2 H1] + [H2 H1 L3])/3 with L the
/// linear modes and H1, H2, H3 the modes eta zeta, zeta xi, xi eta.
template <class V>
BRUNT_INLINE void volume_gradient(const Modal<3, V>& c, V (&E)[6][3]) {
  constexpr Real third = 1.0 / 3;
  const auto& L1 = c.m[0];
  const auto& L2 = c.m[1];
  const auto& L3 = c.m[2];
  const auto& H1 = c.m[3];
  const auto& H2 = c.m[4];
  const auto& H3 = c.m[5];
  set_cross(L2, L3, E[0]), add_cross(H3, H2, third, E[0]);
  set_cross(L3, L1, E[1]), add_cross(H1, H3, third, E[1]);
  set_cross(L1, L2, E[2]), add_cross(H2, H1, third, E[2]);
  set_cross(H3, L2, E[3]), add_cross(L3, H2, E[3]);
  set_cross(L1, H3, E[4]), add_cross(H1, L3, E[4]);
  set_cross(H2, L1, E[5]), add_cross(L2, H1, E[5]);
  for (int m = 3; m < 6; ++m) {
    for (int j = 0; j < 3; ++j) E[m][j] = third * E[m][j];
  }
}
/// E of a quadrilateral [m], area/4 = L1 x L2.
template <class V>
BRUNT_INLINE void volume_gradient(const Modal<2, V>& c, V (&E)[2][2]) {
  E[0][0] = c.m[1][1], E[0][1] = -c.m[1][0];
  E[1][0] = -c.m[0][1], E[1][1] = c.m[0][0];
}
/// Volume [m^3], or area [m^2] in 2D, from E of the same configuration.
template <int Dim, class V>
BRUNT_INLINE V measure(const Modal<Dim, V>& c, const V (&E)[Shape<Dim>::kActive][Dim]) {
  V sum = c.m[0][0] * E[0][0];
  for (int m = 1; m < Shape<Dim>::kActive; ++m) sum = vfma(c.m[m][0], E[m][0], sum);
  return static_cast<Real>(Shape<Dim>::kCorners) * sum;
}
/// Volume [m^3] of the positions with modes c: eight times the sum over m of c_xm E_xm.
template <class V>
BRUNT_INLINE V volume_of(const Modal<3, V>& c) {
  const auto minor = [&](int a, int b) {
    return difference_of_products(c.m[a][1], c.m[b][2], c.m[a][2], c.m[b][1]);
  };
  V linear = c.m[0][0] * minor(1, 2);
  linear = vfma(c.m[1][0], minor(2, 0), vfma(c.m[2][0], minor(0, 1), linear));
  V others = c.m[0][0] * minor(5, 4);
  others = vfma(c.m[1][0], minor(3, 5), others);
  others = vfma(c.m[2][0], minor(4, 3), others);
  others = vfma(c.m[3][0], minor(5, 1) + minor(2, 4), others);
  others = vfma(c.m[4][0], minor(0, 5) + minor(3, 2), others);
  others = vfma(c.m[5][0], minor(4, 0) + minor(1, 3), others);
  return 8.0 * (linear + (1.0 / 3) * others);
}
/// G_ij = sum_I u_iI B_jI of a field with modes u.
template <int Dim, class V>
BRUNT_INLINE void volume_times_gradient(const Modal<Dim, V>& u,
                                        const V (&E)[Shape<Dim>::kActive][Dim], V (&G)[Dim][Dim]) {
  constexpr Real corners = Shape<Dim>::kCorners;
  for (int i = 0; i < Dim; ++i) {
    for (int j = 0; j < Dim; ++j) {
      V sum = u.m[0][i] * E[0][j];
      for (int m = 1; m < Shape<Dim>::kActive; ++m) sum = vfma(u.m[m][i], E[m][j], sum);
      G[i][j] = corners * sum;
    }
  }
}

}  // namespace brunt
// Tested by tests/unit/fe/kinematics_test.cpp.
