#pragma once
/// Rotation of tensors by the spin of a step.
/// Hughes, T.J.R. & Winget, J., Finite rotation effects in numerical integration of rate
/// constitutive equations, Int. J. Numer. Meth. Eng. 15, 1980, eq. 28.
#include "core/simd.hpp"

namespace brunt {

/// An orthogonal matrix by rows, of one point (Real) or four (Pack).
template <class V>
struct Rotation {
  V row[3][3];
};
/// A rotation about z.
template <class V>
struct PlaneRotation {
  V cosine, sine;
};

/// Rotation of a step, R = (I - w/2)^-1 (I + w/2), where w is the skew matrix of the spin times dt:
/// w_ij = 1/2 (dv_i/dx_j - dv_j/dx_i) dt. Orthogonal to round-off for any spin; with a = spin / 2
/// and A b = a x b it is R = I + 2/(1 + a.a) (A + A A).
/// spin  axial vector of w [rad]: (w_zy, w_xz, w_yx), half the vorticity times dt
template <class V>
BRUNT_INLINE Rotation<V> hughes_winget(V spin_x, V spin_y, V spin_z) {
  const V a = 0.5 * spin_x, b = 0.5 * spin_y, c = 0.5 * spin_z;
  const V f = 2.0 / (1.0 + a * a + b * b + c * c);
  const V fa = f * a, fb = f * b, fc = f * c;
  const V aa = fa * a, bb = fb * b, cc = fc * c, ab = fa * b, bc = fb * c, ca = fc * a;
  return {{{1.0 - (bb + cc), ab - fc, ca + fb},
           {ab + fc, 1.0 - (cc + aa), bc - fa},
           {ca - fb, bc + fa, 1.0 - (aa + bb)}}};
}

/// The same for a spin about z alone, as every motion in 2D has it.
/// spin  w_yx = 1/2 (dv_y/dx - dv_x/dy) dt [rad]
template <class V>
BRUNT_INLINE PlaneRotation<V> hughes_winget(V spin) {
  const V a = 0.5 * spin;
  const V f = 1.0 / (1.0 + a * a);
  return {(1.0 - a * a) * f, 2.0 * a * f};
}

/// s <- R s R^T of a symmetric tensor s[6], SymmetricIndex.
template <class V>
BRUNT_INLINE void rotate_symmetric(const Rotation<V>& rotation, V* s) {
  const V full[3][3] = {{s[xx], s[xy], s[zx]}, {s[xy], s[yy], s[yz]}, {s[zx], s[yz], s[zz]}};
  V half[3][3];  // R s
  for (int i = 0; i < 3; ++i) {
    const V* r = rotation.row[i];
    for (int j = 0; j < 3; ++j) {
      half[i][j] = vfma(r[2], full[2][j], vfma(r[1], full[1][j], r[0] * full[0][j]));
    }
  }
  const auto entry = [&](int i, int j) {
    const V* r = rotation.row[j];
    return vfma(half[i][2], r[2], vfma(half[i][1], r[1], half[i][0] * r[0]));
  };
  s[xx] = entry(0, 0), s[yy] = entry(1, 1), s[zz] = entry(2, 2);
  s[xy] = entry(0, 1), s[yz] = entry(1, 2), s[zx] = entry(2, 0);
}

/// s <- R s R^T about z; s_yz and s_zx turn like a vector.
template <class V>
BRUNT_INLINE void rotate_symmetric(const PlaneRotation<V>& rotation, V* s) {
  const V c = rotation.cosine, n = rotation.sine;
  const V cc = c * c, nn = n * n, cn = c * n, twice = 2.0 * cn * s[xy];
  const V s_xx = s[xx], s_yy = s[yy], s_yz = s[yz], s_zx = s[zx];
  s[xx] = cc * s_xx + nn * s_yy - twice;
  s[yy] = nn * s_xx + cc * s_yy + twice;
  s[xy] = cn * (s_xx - s_yy) + (cc - nn) * s[xy];
  s[yz] = n * s_zx + c * s_yz;
  s[zx] = c * s_zx - n * s_yz;
}

/// Strain of a step in the axes of its end, e[xx], e[yy], e[zz], e[xy], e[yz], e[zx], from the
/// gradient of displacement L = D + w at its middle: D + (w D - D w)/2. D is in the axes of the
/// middle, which half of the step's rotation takes to its end. D alone would leave an error of w D
/// in each step, of first order in dt; a strain that comes and goes under a turn that comes and
/// goes would then not come back to nothing.
template <class V>
BRUNT_INLINE void step_strain(const V (&L)[3][3], V* e) {
  const V d_xy = 0.5 * (L[0][1] + L[1][0]), d_yz = 0.5 * (L[1][2] + L[2][1]);
  const V d_zx = 0.5 * (L[2][0] + L[0][2]);
  // Halves of w_xy, w_yz, w_zx.
  const V a = 0.25 * (L[0][1] - L[1][0]), b = 0.25 * (L[1][2] - L[2][1]);
  const V c = 0.25 * (L[2][0] - L[0][2]);
  const V turned_xy = 2.0 * (a * d_xy), turned_yz = 2.0 * (b * d_yz), turned_zx = 2.0 * (c * d_zx);
  e[xx] = L[0][0] + (turned_xy - turned_zx);
  e[yy] = L[1][1] + (turned_yz - turned_xy);
  e[zz] = L[2][2] + (turned_zx - turned_yz);
  e[xy] = d_xy + (a * (L[1][1] - L[0][0]) + (b * d_zx - c * d_yz));
  e[yz] = d_yz + (b * (L[2][2] - L[1][1]) + (c * d_xy - a * d_zx));
  e[zx] = d_zx + (c * (L[0][0] - L[2][2]) + (a * d_yz - b * d_xy));
}

/// The same in the plane, without e[zz]; e[yz] and e[zx] are none.
template <class V>
BRUNT_INLINE void step_strain(const V (&L)[2][2], V* e) {
  const V shear = 0.5 * (L[0][1] + L[1][0]), a = 0.25 * (L[0][1] - L[1][0]);
  const V turned = 2.0 * (a * shear);
  e[xx] = L[0][0] + turned;
  e[yy] = L[1][1] - turned;
  e[xy] = shear + a * (L[1][1] - L[0][0]);
}

}  // namespace brunt
