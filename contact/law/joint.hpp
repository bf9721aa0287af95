#pragma once
/// What a deck says of faces and particles that hold together or close on each other as a joint
/// does, and the spring that it makes of them (docs/theory/contact.md, 8a).
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/schema.hpp"

namespace brunt {

/// The deck's `joint`: springs by area, hyperbolic along the normal (Bandis, Lumsden & Barton
/// 1983).
///   sigma = k u / (1 - u/V),  u the closure since time 0
struct JointSpring {
  Real normal = 0;                  ///< [Pa/m] k
  std::optional<Real> shear;        ///< [Pa/m]; none: as the normal one
  std::optional<Real> max_closure;  ///< [m] V; none: a linear joint

  Real across() const { return shear.value_or(normal); }
};

inline void describe(Schema& s, JointSpring& joint) {
  constexpr Quantity kStiffness{"Pa/m", positive(), between(1e6, 1e14)};
  s.real({"normal", "stiffness of a square metre at no closure", Need::required}, joint.normal,
         kStiffness);
  s.real({"shear", "the same against shear; default: as normal"}, joint.shear, kStiffness);
  s.real({"max_closure",
          "closure at which it would be rigid: sigma = normal u / (1 - u/max_closure); "
          "it opens along its tangent; default: a linear joint"},
         joint.max_closure, {"m", positive(), between(1e-6, 0.1)});
}

/// Springs of what is tied are as stiff as this part of both sides in series: a plane wave of 20
/// elements a length passes with 0.997 of its amplitude (C50), and the step is 0.625 of the
/// elements' own. No joint is made stiffer either.
inline constexpr Real kTiedStiffness = 4;

/// The spring of a joint, or of what is tied, by area.
struct HoldingSpring {
  Real normal = 0;               ///< [Pa/m] k
  Real shear = 0;                ///< [Pa/m]
  Real max_closure = kInfinity;  ///< [m] V
  Real stiffest = kInfinity;     ///< [Pa/m] slope beyond which it goes on along a line
  Real tension = kInfinity;      ///< [Pa] at which it breaks
  Real cohesion = kInfinity;     ///< [Pa] the same of shear, without pressure

  /// [m] closure from which its slope is the stiffest: k/(1 - u/V)^2 there.
  Real capped_from() const {
    if (max_closure == kInfinity || !(stiffest < kInfinity)) return kInfinity;
    return max_closure * std::max(1 - std::sqrt(normal / stiffest), 0.0);
  }
  /// [Pa] where it has never been so closed; pull below 0.
  Real first_loading(Real u) const {
    if (u <= 0 || max_closure == kInfinity) return normal * u;
    const Real c = capped_from();
    if (u <= c) return normal * u / (1 - u / max_closure);
    return normal * c / (1 - c / max_closure) + stiffest * (u - c);
  }
  /// [Pa/m] slope of the same.
  Real slope(Real u) const {
    if (u <= 0 || max_closure == kInfinity) return normal;
    const Real open = 1 - std::min(u, capped_from()) / max_closure;
    return std::min(normal / (open * open), stiffest);
  }
  /// [Pa] at a closure u, where it has been closed by `most` [m]: along the tangent there.
  Real pressure(Real u, Real most) const {
    if (u >= most || max_closure == kInfinity) return first_loading(u);
    const Real back = first_loading(most) + slope(most) * (u - most);
    return u > 0 ? std::max(back, 0.0) : normal * u;
  }
  /// [J/m^2] that it would give back, p^2/2k along the line on which it is.
  Real stored(Real u, Real most) const {
    const Real p = pressure(u, most);
    return 0.5 * p * p / (p < 0 ? normal : slope(std::max(u, most)));
  }
  /// [J/m^2] that closing by `most` [m] has used up: its work less what is stored there.
  Real lost(Real most) const {
    if (!(most > 0) || max_closure == kInfinity) return 0;
    const Real c = std::min(most, capped_from()), x = c / max_closure;
    const Real square = normal * max_closure * max_closure;
    const Real closed = square * (-std::log1p(-x) - x - 0.5 * x * x);
    if (most <= c) return closed;
    // Beyond, along the line, what is stored is p^2/2k of it.
    const Real from = first_loading(c), at = first_loading(most);
    const Real work = square * (-std::log1p(-x) - x) + 0.5 * (from + at) * (most - c);
    return work - 0.5 * at * at / stiffest;
  }
};

}  // namespace brunt
// Tested by tests/unit/contact/joint_test.cpp.
