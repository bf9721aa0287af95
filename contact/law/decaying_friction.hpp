#pragma once
#include <cmath>

#include "contact/law/contact_state.hpp"
#include "core/schema.hpp"

namespace brunt {

/// Friction that falls from its value at rest to that of fast sliding (docs/theory/contact.md
/// (C30)).
///   mu = kinetic + (static - kinetic) exp(-decay |v|)
struct DecayingFriction {
  Real at_rest = 0;  ///< [1] `static`
  Real kinetic = 0;  ///< [1]
  Real decay = 0;    ///< [s/m]

  Real coefficient(const ContactState& at) const {
    return kinetic + (at_rest - kinetic) * std::exp(-decay * at.speed);
  }
  bool acts() const { return at_rest > 0; }
};

inline void describe(Schema& s, DecayingFriction& law) {
  constexpr Quantity kCoefficient{"1", at_least(0), between(0, 2)};
  s.real({"static", "coefficient at rest", Need::required}, law.at_rest, kCoefficient);
  s.real({"kinetic", "coefficient of fast sliding", Need::required}, law.kinetic, kCoefficient);
  s.real({"decay", "mu = kinetic + (static - kinetic) exp(-decay |v|)", Need::required}, law.decay,
         {"s/m", at_least(0), between(1e-4, 1e4)});
  s.require(law.kinetic <= law.at_rest, "kinetic",
            "must not be above static; friction that rises with speed is a table over slip_speed");
}

}  // namespace brunt
// Tested by tests/unit/contact/coulomb_friction_test.cpp.
