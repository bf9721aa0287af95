#pragma once
/// The tensile part of a symmetric tensor: its positive principal values with their directions.
#include "core/simd.hpp"

namespace brunt {

/// One Jacobi rotation that makes a[p][q] zero; directions are the columns of `direction`.
/// Golub & Van Loan, Matrix Computations, 8.5.2. The identity where a[p][q] is zero already.
template <int Dim, class V>
BRUNT_INLINE void rotate_to_diagonal(V (&a)[Dim][Dim], V (&direction)[Dim][Dim], int p, int q) {
  const V zero = broadcast<V>(0.0);
  const V difference = a[q][q] - a[p][p], twice = 2.0 * a[p][q];
  const V root = vsqrt(difference * difference + twice * twice);
  const V signed_twice = select(difference < 0.0, -twice, twice);
  const V sum = vabs(difference) + root;
  const V tangent = select(zero < sum, signed_twice / select(zero < sum, sum, zero + 1.0), zero);
  const V cosine = 1.0 / vsqrt(1.0 + tangent * tangent), sine = tangent * cosine;
  const V change = tangent * a[p][q];
  a[p][p] = a[p][p] - change;
  a[q][q] = a[q][q] + change;
  a[p][q] = a[q][p] = zero;
  for (int k = 0; k < Dim; ++k) {
    if (k != p && k != q) {
      const V kp = a[k][p], kq = a[k][q];
      a[k][p] = a[p][k] = cosine * kp - sine * kq;
      a[k][q] = a[q][k] = sine * kp + cosine * kq;
    }
    const V dp = direction[k][p], dq = direction[k][q];
    direction[k][p] = cosine * dp - sine * dq;
    direction[k][q] = sine * dp + cosine * dq;
  }
}

/// True where the tensor is negative definite, by Sylvester's criterion: no principal tension.
template <int Dim, class V>
BRUNT_INLINE auto negative_definite(const V (&a)[Dim][Dim]) {
  const V minor = a[0][0] * a[1][1] - a[0][1] * a[0][1];
  auto yes = (a[0][0] < 0.0) & (0.0 < minor);
  if constexpr (Dim == 3) {
    const V determinant = a[0][0] * (a[1][1] * a[2][2] - a[1][2] * a[1][2]) -
                          a[0][1] * (a[0][1] * a[2][2] - a[1][2] * a[0][2]) +
                          a[0][2] * (a[0][1] * a[1][2] - a[1][1] * a[0][2]);
    yes = yes & (determinant < 0.0);
  }
  return yes;
}

/// positive <- sum over k of max(lambda_k, 0) n_k (x) n_k; exactly 0 where there is no tension.
/// Sweeps are a fixed number (cyclic Jacobi converges as the square; 3 x 3 is diagonal to round-off
/// after four), so that a lane's bits do not depend on its neighbours.
/// docs/theory/sph.md (S18).
/// tensor  [Pa], both halves;  positive  [Pa], written
template <int Dim, class V>
BRUNT_INLINE void principal_tension(const V (&tensor)[Dim][Dim], V (&positive)[Dim][Dim]) {
  const auto tension = !negative_definite<Dim>(tensor);
  V a[Dim][Dim], direction[Dim][Dim];
  for (int i = 0; i < Dim; ++i) {
    for (int j = 0; j < Dim; ++j) {
      a[i][j] = tensor[i][j];
      direction[i][j] = broadcast<V>(i == j ? 1.0 : 0.0);
      positive[i][j] = broadcast<V>(0.0);
    }
  }
  if (!any(tension)) return;
  constexpr int sweeps = Dim == 3 ? 4 : 1;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    rotate_to_diagonal<Dim>(a, direction, 0, 1);
    if constexpr (Dim == 3) {
      rotate_to_diagonal<Dim>(a, direction, 1, 2);
      rotate_to_diagonal<Dim>(a, direction, 0, 2);
    }
  }
  for (int k = 0; k < Dim; ++k) {
    const V value = select(tension, vmax(a[k][k], broadcast<V>(0.0)), broadcast<V>(0.0));
    for (int i = 0; i < Dim; ++i) {
      for (int j = 0; j < Dim; ++j) {
        positive[i][j] = positive[i][j] + value * direction[i][k] * direction[j][k];
      }
    }
  }
}

}  // namespace brunt
