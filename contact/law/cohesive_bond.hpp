#pragma once
#include <algorithm>

#include "contact/law/contact_state.hpp"
#include "core/schema.hpp"

namespace brunt {

/// A bond of cohesion and tension between faces that touch at time 0 (docs/theory/contact.md
/// (C37)).
struct CohesiveBond {
  Real cohesion = 0;  ///< [Pa] shear strength without pressure
  Real tension = 0;   ///< [Pa] tensile strength

  bool acts() const { return cohesion > 0 || tension > 0; }
  bool begins(Real gap, Real rounding) const { return gap <= rounding; }
  bool tears(Real pull) const { return pull > tension; }
  bool breaks_by_slip() const { return cohesion > 0; }
  Real slip_limit(const ContactState& at, Real coefficient) const {
    return std::max(coefficient * at.push + cohesion * at.area, 0.0);
  }
};

inline void describe(Schema& s, CohesiveBond& law) {
  s.real({"cohesion",
          "shear strength without pressure of faces that touch at time 0, until they slip or open"},
         law.cohesion, {"Pa", at_least(0), between(0, 1e9)});
  s.real({"tension", "tensile strength of faces that touch at time 0, until they open"},
         law.tension, {"Pa", at_least(0), between(0, 1e9)});
}

}  // namespace brunt
