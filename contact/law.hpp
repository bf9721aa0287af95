#pragma once
/// The springs and dampers of contact, and the steps that they allow (contact.md 2.5, 2.8).
#include <cmath>

#include "core/types.hpp"

namespace brunt {

/// Two springs one behind the other, or the reduced mass of two; a side of 0 is rigid.
inline Real in_series(Real a, Real b) {
  if (a == 0) return b;
  if (b == 0) return a;
  return a * b / (a + b);
}

/// Coefficient of a damper that is zeta of critical: 2 zeta sqrt(k m).
inline Real damping_coefficient(Real zeta, Real stiffness, Real mass) {
  return 2 * zeta * std::sqrt(stiffness * mass);
}

/// Factor on a stable step 2/omega where damping is evaluated half a step late.
inline Real lag_factor(Real zeta) { return std::sqrt(1 + zeta * zeta) - zeta; }

/// Stable step over that of the elements behind, h/c, for a surface on a spring of phi M/h: the
/// mode u_j = (-q)^j of a chain whose end carries half a mass and the spring has 1/q - q = 2 phi,
/// so omega^2 = 2 (1 + sqrt(1 + phi^2)) c^2/h^2. Its damping ratio is at most zeta sqrt(phi /
/// (1 + sqrt(1 + phi^2))): all of the mode's mass at the end, where the damper is.
inline Real surface_step_ratio(Real phi, Real zeta) {
  const Real root = 1 + std::sqrt(1 + phi * phi);
  return std::sqrt(2 / root) * lag_factor(zeta * std::sqrt(phi / root));
}

}  // namespace brunt
