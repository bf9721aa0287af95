#pragma once
#include <cmath>
#include <optional>

#include "core/schema.hpp"

namespace brunt {

/// The exponential closure of Malama & Kulatilake 2003: u = V (1 - exp(-sigma/(k V))), half of it
/// at a pressure of k V ln 2. It stiffens later than the hyperbola (docs/theory/contact.md, section
/// 9).
///   sigma = -k V ln(1 - u/V),  u the closure since time 0
struct ExponentialClosure {
  std::optional<Real> largest;  ///< [m] V

  bool acts() const { return largest.has_value(); }
  Real most() const { return *largest; }
  Real pressure(Real k, Real u) const { return -k * most() * std::log1p(-u / most()); }
  Real slope(Real k, Real u) const { return k / (1 - u / most()); }
  Real closure_at(Real k, Real slope) const { return most() * (1 - k / slope); }
  Real work(Real k, Real u) const {
    const Real x = u / most();
    return k * most() * most() * ((1 - x) * std::log1p(-x) + x);
  }
  Real lost(Real k, Real u) const {
    const Real x = u / most(), log = std::log1p(-x);
    return k * most() * most() * ((1 - x) * log + x - 0.5 * (1 - x) * log * log);
  }
};

inline void describe(Schema& s, ExponentialClosure& law) {
  s.real({"exponential_closure",
          "closure at which it would be rigid: sigma = -normal V ln(1 - u/V), V this closure; "
          "it opens along its tangent; default: a linear joint"},
         law.largest, {"m", positive(), between(1e-6, 0.1)});
}

}  // namespace brunt
