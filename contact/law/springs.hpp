#pragma once
/// The springs and dampers of contact, and the steps that they allow (docs/theory/contact.md (C9),
/// (C16), (C39)).
#include <algorithm>
#include <cmath>

#include "core/simd.hpp"

namespace brunt {

/// Two springs one behind the other, or the reduced mass of two; a side of 0 is rigid.
inline Real in_series(Real a, Real b) {
  if (a == 0) return b;
  if (b == 0) return a;
  return a * b / (a + b);
}

/// Spring between two sides: a rigid one, held or free, has none of its own and takes the other's.
/// Two free rigid bodies have both of theirs, since something must give.
inline Real contact_spring(Real a, bool a_deforms, Real b, bool b_deforms) {
  if (a_deforms != b_deforms) return a_deforms ? a : b;
  return in_series(a, b);
}

/// Factor on the springs of what deforms beside a free rigid body that recoils: on k (u - J w)^2
/// with w = -(l M - sum J^T k J)^-1 sum J^T k u of a mode of frequency^2 l nothing gives more than
/// k u^2 / (1 - r) where the rigid body's own frequency^2, its neighbours held, is at most r l.
inline constexpr Real kMostRecoil = 0.25;  ///< r that its own bound of the step leaves
template <class V>
BRUNT_INLINE V recoil_factor(V recoil) {
  return 1.0 / (1.0 - vmin(broadcast<V>(kMostRecoil), recoil));
}
/// The same factor on the damping ratio: the damper feels (u - J w)^2, 1/(1 - r)^2 of u^2, where
/// sqrt(k) has grown by 1/sqrt(1 - r).
template <class V>
BRUNT_INLINE V recoil_damping(V zeta, V recoil) {
  const V factor = recoil_factor(recoil);
  return select(recoil > 0.0, zeta * factor * vsqrt(factor), zeta);
}

/// Coefficient of a damper that is zeta of critical: 2 zeta sqrt(k m).
inline Real damping_coefficient(Real zeta, Real stiffness, Real mass) {
  return 2 * zeta * std::sqrt(stiffness * mass);
}

/// Factor on a stable step 2/omega where damping is evaluated half a step late.
template <class V>
BRUNT_INLINE V lag_factor(V zeta) {
  return vsqrt(1.0 + zeta * zeta) - zeta;
}

/// Stable step over that of the elements behind, h/c, for a surface on a spring of phi M/h: the
/// mode u_j = (-q)^j of a chain whose end carries half a mass and the spring has 1/q - q = 2 phi,
/// so omega^2 = 2 (1 + sqrt(1 + phi^2)) c^2/h^2. Its damping ratio is at most zeta sqrt(phi /
/// (1 + sqrt(1 + phi^2))): all of the mode's mass at the end, where the damper is.
template <class V>
BRUNT_INLINE V surface_step_ratio(V phi, V zeta) {
  const V root = 1.0 + vsqrt(1.0 + phi * phi);
  return vsqrt(2.0 / root) * lag_factor(zeta * vsqrt(phi / root));
}
inline Real surface_step_ratio(Real phi, Real zeta) { return surface_step_ratio<Real>(phi, zeta); }

}  // namespace brunt
