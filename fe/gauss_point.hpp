#pragma once
/// Geometry and displacement gradient at the Gauss points of four elements.
#include "fe/element_block.hpp"
#include "fe/gradient.hpp"

namespace brunt {

template <int Dim>
inline constexpr int kGauss = Shape<Dim>::kGauss;

/// Slopes [g][mode][j] and values [g][mode] of the modes at the Gauss points.
template <int Dim>
struct GaussTable {
  std::array<std::array<Real, Dim>, Shape<Dim>::kModes - 1> slope[kGauss<Dim>];
  std::array<Real, Shape<Dim>::kModes> value[kGauss<Dim>];
};
template <int Dim>
constexpr GaussTable<Dim> make_table() {
  GaussTable<Dim> table{};
  for (int g = 0; g < kGauss<Dim>; ++g) {
    table.slope[g] = Shape<Dim>::mode_slopes(gauss_place<Dim>(g));
    table.value[g] = Shape<Dim>::mode_values(gauss_place<Dim>(g));
  }
  return table;
}
template <int Dim>
inline constexpr GaussTable<Dim> kGaussTable = make_table<Dim>();

/// True where mode m does not depend on xi_j: the modes eta zeta, zeta xi and xi eta of a
/// hexahedron.
template <int Dim>
constexpr bool is_flat(int m, int j) {
  return Dim == 3 && m == Dim + j;
}

template <class V>
BRUNT_INLINE void cofactors(const V (&J)[3][3], V (&cof)[3][3]) {
  for (int i = 0; i < 3; ++i) {
    const int a = (i + 1) % 3, b = (i + 2) % 3;
    set_cross(J[a], J[b], cof[i]);
  }
}
template <class V>
BRUNT_INLINE void cofactors(const V (&J)[2][2], V (&cof)[2][2]) {
  cof[0][0] = J[1][1], cof[1][1] = J[0][0];
  cof[0][1] = -J[1][0], cof[1][0] = -J[0][1];
}

/// sum_m c_m (x) d phi_m/d xi at Gauss point g. The mode without xi_j has no slope along it.
template <int Dim, class V>
BRUNT_INLINE void slopes(const Modal<Dim, V>& c, int g, V (&J)[Dim][Dim]) {
  const auto& slope = kGaussTable<Dim>.slope[g];
  for (int i = 0; i < Dim; ++i) {
    for (int j = 0; j < Dim; ++j) {
      J[i][j] = c.m[j][i];
      for (int m = Dim; m < Shape<Dim>::kModes - 1; ++m) {
        if (!is_flat<Dim>(m, j)) J[i][j] += slope[m][j] * c.m[m][i];
      }
    }
  }
}

template <int Dim, class V>
BRUNT_INLINE V determinant_of(const V (&J)[Dim][Dim], const V (&cof)[Dim][Dim]) {
  V determinant = J[0][0] * cof[0][0];
  for (int j = 1; j < Dim; ++j) determinant += J[0][j] * cof[0][j];
  return determinant;
}

/// First coordinate at Gauss point g [m].
template <class V>
BRUNT_INLINE V radius_at(const Modal<2, V>& c, int g) {
  V r = c.m[3][0];
  for (int m = 0; m < 3; ++m) r += kGaussTable<2>.value[g][m] * c.m[m][0];
  return r;
}

/// dx/dxi at n+1 and what the step added to it, at one Gauss point. Both are linear in the modes,
/// so that other configurations of the step follow from them.
template <int Dim, class V>
struct GaussSlopes {
  V J[Dim][Dim], A[Dim][Dim];
  V r, u_r;  ///< [m] first coordinate at n+1 and its increment, in 2D

  BRUNT_INLINE GaussSlopes(const Modal<Dim, V>& c, const Modal<Dim, V>& u, int g) {
    slopes(c, g, J);
    slopes(u, g, A);
    if constexpr (Dim == 2) r = radius_at(c, g), u_r = radius_at(u, g);
  }
};

/// One Gauss point at one configuration; volumes are those of its share of the element.
template <int Dim, class V>
struct GaussPoint {
  V cof[Dim][Dim];  ///< determinant times inverse transpose of dx/dxi
  V determinant;
  V thickness;    ///< [m] depth or 2 pi r; 1 in 3D
  V G[Dim][Dim];  ///< [m^Dim] determinant times gradient of the displacement of the step
  V hoop;         ///< [m] thickness times hoop strain

  V volume() const { return Dim == 3 ? determinant : determinant * thickness; }
  V dilatation() const {
    if constexpr (Dim == 3) return trace(G);
    return thickness * trace(G) + determinant * hoop;
  }
  /// Work of the stress s on the displacement of the step [J].
  V work(const V (&s)[6]) const {
    if constexpr (Dim == 3) return double_dot(s, G);
    return thickness * double_dot(s, G) + determinant * s[zz] * hoop;
  }
};

/// back: part of the step by which the configuration is before n+1.
template <int Dim, class V>
BRUNT_INLINE void evaluate(const GaussSlopes<Dim, V>& now, Real back, const Thickness& option,
                           GaussPoint<Dim, V>& at) {
  V J[Dim][Dim];
  for (int i = 0; i < Dim; ++i) {
    for (int j = 0; j < Dim; ++j)
      J[i][j] = back == 0 ? now.J[i][j] : now.J[i][j] - back * now.A[i][j];
  }
  cofactors(J, at.cof);
  at.determinant = determinant_of<Dim>(J, at.cof);
  for (int i = 0; i < Dim; ++i) {
    for (int j = 0; j < Dim; ++j) {
      at.G[i][j] = now.A[i][0] * at.cof[j][0];
      for (int k = 1; k < Dim; ++k) at.G[i][j] += now.A[i][k] * at.cof[j][k];
    }
  }
  if constexpr (Dim == 2) {
    const V r = back == 0 ? now.r : now.r - back * now.u_r;
    at.thickness = option.constant + option.radial * r;
    at.hoop = option.radial * now.u_r;
  }
}

}  // namespace brunt
// Tested by tests/unit/fe/kinematics_test.cpp.
