#pragma once
/// Gradient correction of a particle and the small tensors of its motion.
#include "core/simd.hpp"
#include "sph/records.hpp"

namespace brunt {

/// Scalar product in a fixed order.
template <int Dim>
BRUNT_INLINE Real dot(const Vec<Dim>& a, const Vec<Dim>& b) {
  Real sum = a[0] * b[0];
  for (int d = 1; d < Dim; ++d) sum += a[d] * b[d];
  return sum;
}

/// Frobenius norms below which all eigenvalues of a moment K are over 0.15 of the largest, and over
/// 0.02, so that B is its inverse (thin_moment.hpp): |K| |K^-1|, and |K^-1|. Corners of cubes, and
/// rods and sheets two particles thick, have 5.5 and 23 at most with all kernels.
inline constexpr Real kThickCondition = 6.6, kThickInverse = 50;

/// |cofactors|/|K|^2 of a thick neighbourhood is 0.08 at the least: the largest eigenvalue is over
/// |K|/sqrt(3), the next over |K|/6.6. Of a straight row, or of a pair, they are what rounding
/// leaves of nothing, 1e-16, and so is the determinant: their quotient says no more.
inline constexpr Real kRowCofactors = 1e-3;

template <int Dim>
BRUNT_INLINE Real frobenius_square(const Real (&m)[kSymmetric<Dim>]) {
  Real sum = 0;
  for (int k = 0; k < kSymmetric<Dim>; ++k) sum += (k < Dim ? 1.0 : 2.0) * (m[k] * m[k]);
  return sum;
}

/// inverse <- moment^-1, and true, where the neighbourhood is thick: not an isolated particle, a
/// straight row or, in space, a flat sheet.
/// docs/theory/sph.md (S7), (S9).
/// moment, inverse  [1] symmetric
/// slack  [1] how much worse than those limits is thick
template <int Dim>
BRUNT_INLINE bool invert_thick(const Real (&moment)[kSymmetric<Dim>],
                               Real (&inverse)[kSymmetric<Dim>], Real slack = 1) {
  const Real* m = moment;
  Real cofactor[kSymmetric<Dim>], determinant;
  if constexpr (Dim == 3) {
    cofactor[xx] = m[yy] * m[zz] - m[yz] * m[yz];
    cofactor[yy] = m[xx] * m[zz] - m[zx] * m[zx];
    cofactor[zz] = m[xx] * m[yy] - m[xy] * m[xy];
    cofactor[xy] = m[yz] * m[zx] - m[xy] * m[zz];
    cofactor[yz] = m[xy] * m[zx] - m[yz] * m[xx];
    cofactor[zx] = m[xy] * m[yz] - m[zx] * m[yy];
    determinant = m[xx] * cofactor[xx] + m[xy] * cofactor[xy] + m[zx] * cofactor[zx];
  } else {
    cofactor[0] = m[1], cofactor[1] = m[0], cofactor[2] = -m[2];
    determinant = m[0] * m[1] - m[2] * m[2];
  }
  // |K^-1| = |cofactors|/det
  const Real cofactors = frobenius_square<Dim>(cofactor);
  const Real least = slack * kThickInverse * determinant;
  const Real condition = slack * kThickCondition * determinant;
  const Real square = frobenius_square<Dim>(moment), row = kRowCofactors / slack * square;
  if (!(determinant > 0 && cofactors > row * row && cofactors <= least * least &&
        square * cofactors <= condition * condition)) {
    return false;
  }
  const Real reciprocal = 1.0 / determinant;
  for (int k = 0; k < kSymmetric<Dim>; ++k) inverse[k] = cofactor[k] * reciprocal;
  return true;
}

/// velocity_gradient <- rate B, by rows [1/s].
template <int Dim>
BRUNT_INLINE void correct_rate(const Real (&rate)[Dim * Dim],
                               const Real (&correction)[kSymmetric<Dim>],
                               Real (&velocity_gradient)[Dim * Dim]) {
  for (int a = 0; a < Dim; ++a) {
    for (int b = 0; b < Dim; ++b) {
      Real sum = 0;
      for (int c = 0; c < Dim; ++c) {
        sum += rate[Dim * a + c] * correction[symmetric_place<Dim>(c, b)];
      }
      velocity_gradient[Dim * a + b] = sum;
    }
  }
}

/// K and K^-1 of a particle whose gradients are not corrected, by which its turn is.
template <int Dim>
struct PlainMoment {
  Real moment[kSymmetric<Dim>] = {};   ///< [1] K
  Real inverse[kSymmetric<Dim>] = {};  ///< [1] K^-1, or B of a thin neighbourhood
};

/// velocity_gradient <- R + W - W K, W the skew part of R K^-1: a plain sum R of velocities w x r
/// is W K, not W, and would strain what only turns.
/// docs/theory/sph.md (S8a).
template <int Dim>
BRUNT_INLINE void correct_turn(const Real (&rate)[Dim * Dim], const PlainMoment<Dim>& plain,
                               Real (&velocity_gradient)[Dim * Dim]) {
  Real full[Dim * Dim], spin[Dim][Dim];
  correct_rate<Dim>(rate, plain.inverse, full);
  for (int a = 0; a < Dim; ++a) {
    for (int b = 0; b < Dim; ++b) spin[a][b] = 0.5 * (full[Dim * a + b] - full[Dim * b + a]);
  }
  for (int a = 0; a < Dim; ++a) {
    for (int b = 0; b < Dim; ++b) {
      Real sum = rate[Dim * a + b] + spin[a][b];
      for (int c = 0; c < Dim; ++c) {
        sum -= spin[a][c] * plain.moment[symmetric_place<Dim>(c, b)];
      }
      velocity_gradient[Dim * a + b] = sum;
    }
  }
}

/// Motion of a step about its middle, out of the gradient G = dx (x) grad at its end.
/// docs/theory/sph.md (S6), (S11).
template <int Dim, class V>
struct MidStep {
  V gradient[Dim][Dim];  ///< [1] L dt = G (I - G/2)^-1
  V volume_ratio;        ///< [1] V(n+1)/V(n) = 1/det(I - G), exact where the motion is affine
};

template <class V>
BRUNT_INLINE V determinant(const V (&m)[2][2]) {
  return m[0][0] * m[1][1] - m[0][1] * m[1][0];
}
template <class V>
BRUNT_INLINE V determinant(const V (&m)[3][3]) {
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
         m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

template <class V>
BRUNT_INLINE void invert(const V (&m)[2][2], V (&inverse)[2][2]) {
  const V scale = 1.0 / determinant(m);
  inverse[0][0] = scale * m[1][1], inverse[1][1] = scale * m[0][0];
  inverse[0][1] = -(scale * m[0][1]), inverse[1][0] = -(scale * m[1][0]);
}
template <class V>
BRUNT_INLINE void invert(const V (&m)[3][3], V (&inverse)[3][3]) {
  const V scale = 1.0 / determinant(m);
  for (int i = 0; i < 3; ++i) {
    const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
    for (int j = 0; j < 3; ++j) {
      const int j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      inverse[j][i] = scale * (m[i1][j1] * m[i2][j2] - m[i1][j2] * m[i2][j1]);
    }
  }
}

/// Largest strain and turn of a step, |G| by Frobenius. Where |G| < 1, det(I - G) > 0: no motion
/// turns a volume inside out. Stable steps of continua stay below a tenth.
inline constexpr Real kLargestStepGradient = 0.5;

/// What is beyond the largest gradient is scaled to it: debris that crosses a neighbour in one step
/// is not strained by a gradient of so few.
/// docs/theory/sph.md (S10).
template <int Dim, class V>
BRUNT_INLINE MidStep<Dim, V> mid_step(const V (&at_end)[Dim][Dim]) {
  V end[Dim][Dim], half[Dim][Dim], full[Dim][Dim], inverse[Dim][Dim];
  V square = broadcast<V>(0.0);
  for (int i = 0; i < Dim; ++i) {
    for (int j = 0; j < Dim; ++j) square = square + at_end[i][j] * at_end[i][j];
  }
  const V one = broadcast<V>(1.0);
  const V scale = select(square > kLargestStepGradient * kLargestStepGradient,
                         kLargestStepGradient / vsqrt(square), one);
  for (int i = 0; i < Dim; ++i) {
    for (int j = 0; j < Dim; ++j) end[i][j] = scale * at_end[i][j];
  }
  for (int i = 0; i < Dim; ++i) {
    for (int j = 0; j < Dim; ++j) {
      const Real unit = i == j ? 1.0 : 0.0;
      half[i][j] = unit - 0.5 * end[i][j];
      full[i][j] = unit - end[i][j];
    }
  }
  invert(half, inverse);
  MidStep<Dim, V> mid;
  mid.volume_ratio = 1.0 / determinant(full);
  for (int i = 0; i < Dim; ++i) {
    for (int j = 0; j < Dim; ++j) {
      V sum = end[i][0] * inverse[0][j];
      for (int k = 1; k < Dim; ++k) sum = sum + end[i][k] * inverse[k][j];
      mid.gradient[i][j] = sum;
    }
  }
  return mid;
}

}  // namespace brunt
// Tested by tests/extremes/particle_density_test.cpp.
