#pragma once
/// Algebra of displacement gradients G [i][j] with symmetric tensors (SymmetricIndex).
#include "core/geometry/rotation.hpp"
#include "core/simd.hpp"
#include "core/types.hpp"

namespace brunt {

/// Rotation of a step from the gradient of displacement L [1] at mid-step.
template <class V>
BRUNT_INLINE Rotation<V> step_rotation(const V (&L)[3][3]) {
  return hughes_winget<V>(0.5 * (L[2][1] - L[1][2]), 0.5 * (L[0][2] - L[2][0]),
                          0.5 * (L[1][0] - L[0][1]));
}
template <class V>
BRUNT_INLINE PlaneRotation<V> step_rotation(const V (&L)[2][2]) {
  return hughes_winget<V>(0.5 * (L[1][0] - L[0][1]));
}

/// s : G; in 2D without the zz component.
template <class V>
BRUNT_INLINE V double_dot(const V (&s)[6], const V (&G)[3][3]) {
  const V normal = vfma(s[zz], G[2][2], vfma(s[yy], G[1][1], s[xx] * G[0][0]));
  const V shear =
      vfma(s[zx], G[2][0] + G[0][2], vfma(s[yz], G[1][2] + G[2][1], s[xy] * (G[0][1] + G[1][0])));
  return normal + shear;
}
template <class V>
BRUNT_INLINE V double_dot(const V (&s)[6], const V (&G)[2][2]) {
  return s[xx] * G[0][0] + s[yy] * G[1][1] + s[xy] * (G[0][1] + G[1][0]);
}
template <class V>
BRUNT_INLINE V trace(const V (&G)[3][3]) {
  return G[0][0] + G[1][1] + G[2][2];
}
template <class V>
BRUNT_INLINE V trace(const V (&G)[2][2]) {
  return G[0][0] + G[1][1];
}

/// s - p as a full matrix; in 2D without the zz component.
template <class V>
BRUNT_INLINE void stress_matrix(const V (&s)[6], V p, V (&m)[3][3]) {
  m[0][0] = s[xx] - p, m[1][1] = s[yy] - p, m[2][2] = s[zz] - p;
  m[0][1] = m[1][0] = s[xy], m[1][2] = m[2][1] = s[yz], m[0][2] = m[2][0] = s[zx];
}
template <class V>
BRUNT_INLINE void stress_matrix(const V (&s)[6], V p, V (&m)[2][2]) {
  m[0][0] = s[xx] - p, m[1][1] = s[yy] - p, m[0][1] = m[1][0] = s[xy];
}

}  // namespace brunt
// Tested by tests/unit/fe/kinematics_test.cpp.
