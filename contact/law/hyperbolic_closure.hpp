#pragma once
#include <cmath>
#include <optional>

#include "core/schema.hpp"

namespace brunt {

/// The hyperbola of Bandis, Lumsden & Barton 1983 (docs/theory/contact.md (C51), (C52)).
///   sigma = k u / (1 - u/V),  u the closure since time 0
struct HyperbolicClosure {
  std::optional<Real> max_closure;  ///< [m] V

  bool acts() const { return max_closure.has_value(); }
  Real most() const { return *max_closure; }
  Real pressure(Real k, Real u) const { return k * u / (1 - u / most()); }
  Real slope(Real k, Real u) const {
    const Real open = 1 - u / most();
    return k / (open * open);
  }
  Real closure_at(Real k, Real slope) const { return most() * (1 - std::sqrt(k / slope)); }
  Real work(Real k, Real u) const {
    const Real x = u / most();
    return k * most() * most() * (-std::log1p(-x) - x);
  }
  Real lost(Real k, Real u) const {
    const Real x = u / most();
    return k * most() * most() * (-std::log1p(-x) - x - 0.5 * x * x);
  }
};

inline void describe(Schema& s, HyperbolicClosure& law) {
  s.real({"max_closure",
          "closure at which it would be rigid: sigma = normal u / (1 - u/max_closure); "
          "it opens along its tangent; default: a linear joint"},
         law.max_closure, {"m", positive(), between(1e-6, 0.1)});
}

}  // namespace brunt
// Tested by tests/unit/contact/joint_test.cpp.
