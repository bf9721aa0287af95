#pragma once
/// What a deck says of faces and particles that hold together or close on each other as a joint
/// does, and the spring that it makes of them (docs/theory/contact.md, section 9).
#include <algorithm>
#include <cmath>
#include <optional>

#include "contact/law/catalog.hpp"
#include "core/schema.hpp"

namespace brunt {

/// The deck's `joint`: springs by area, along the normal by a law of closure, across linear.
struct JointSpring {
  Real normal = 0;            ///< [Pa/m] at no closure
  std::optional<Real> shear;  ///< [Pa/m]; none: as the normal one
  Closures closures{};        ///< of which one may act; none: a linear joint

  Real across() const { return shear.value_or(normal); }
  ClosureLaw closure() const { return ClosureLaw(closures); }
};

inline void describe(Schema& s, JointSpring& joint) {
  constexpr Quantity kStiffness{"Pa/m", positive(), between(1e6, 1e14)};
  s.real({"normal", "stiffness of a square metre at no closure", Need::required}, joint.normal,
         kStiffness);
  s.real({"shear", "the same against shear; default: as normal"}, joint.shear, kStiffness);
  std::apply([&](auto&... law) { (describe(s, law), ...); }, joint.closures);
  s.require(count_acting(joint.closures) <= 1, "",
            "has more than one law of closure: keep one of them");
}

/// Springs of what is tied are as stiff as this part of both sides in series: a plane wave of 20
/// elements a length passes with 0.997 of its amplitude (C50), and the step is 0.625 of the
/// elements' own. No joint is made stiffer either.
inline constexpr Real kTiedStiffness = 4;

/// The spring of a joint, or of what is tied, by area.
struct HoldingSpring {
  Real normal = 0;            ///< [Pa/m] k
  Real shear = 0;             ///< [Pa/m]
  ClosureLaw closure{};       ///< by which it closes
  Real stiffest = kInfinity;  ///< [Pa/m] slope beyond which it goes on along a line
  Real tension = kInfinity;   ///< [Pa] at which it breaks
  Real cohesion = kInfinity;  ///< [Pa] the same of shear, without pressure

  /// True where it opens by another way than it closed, and loses energy.
  bool remembers() const { return closure.any(); }
  /// [m] closure from which its slope is the stiffest.
  Real capped_from() const {
    if (!(stiffest < kInfinity)) return kInfinity;
    return std::max(closure.closure_at(normal, stiffest), 0.0);
  }
  /// [Pa] where it has never been so closed; pull below 0.
  Real first_loading(Real u) const {
    if (u <= 0) return normal * u;
    const Real c = capped_from();
    if (u <= c) return closure.pressure(normal, u);
    return closure.pressure(normal, c) + stiffest * (u - c);
  }
  /// [Pa/m] slope of the same.
  Real slope(Real u) const {
    if (u <= 0) return normal;
    return std::min(closure.slope(normal, std::min(u, capped_from())), stiffest);
  }
  /// [Pa] at a closure u, where it has been closed by `most` [m]: along the tangent there.
  Real pressure(Real u, Real most) const {
    if (u >= most || !remembers()) return first_loading(u);
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
    if (!(most > 0) || !remembers()) return 0;
    const Real c = std::min(most, capped_from());
    if (most <= c) return closure.lost(normal, c);
    // Beyond, along the line, what is stored is p^2/2k of it.
    const Real from = first_loading(c), at = first_loading(most);
    return closure.work(normal, c) + 0.5 * (from + at) * (most - c) - 0.5 * at * at / stiffest;
  }
};

}  // namespace brunt
// Tested by tests/unit/contact/joint_test.cpp.
