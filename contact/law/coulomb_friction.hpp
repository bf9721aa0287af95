#pragma once
#include <algorithm>
#include <cmath>
#include <optional>

#include "contact/law/decaying_friction.hpp"

namespace brunt {

/// The tangential law: contact slips at mu times its push, and where the deck asks for it at no
/// more than the shear strength of the softer side (docs/theory/contact.md (C29)).
struct CoulombFriction {
  std::optional<Varying> friction{};           ///< coefficient [1]; none: 0
  std::optional<DecayingFriction> decaying{};  ///< instead of `friction`
  bool shear_limit = false;  ///< friction is never above flow stress / sqrt(3) of the softer side

  bool acts() const {
    if (decaying) return decaying->acts();
    return friction && !(friction->is_constant() && friction->constant == 0);
  }
  /// True where its coefficient depends on the temperature or the flow stress of what slides.
  bool depends_on_material() const {
    if (!friction || decaying) return false;
    if (friction->over == Varying::Over::sliding)
      return friction->depends[0] || friction->depends[1];
    return friction->over == Varying::Over::temperature;
  }
  /// The same of the force at which contact slips.
  bool needs_material() const { return shear_limit || depends_on_material(); }

  /// Coefficient of friction [1]. That of an expression may be anything: the caller looks at it.
  Real coefficient(const ContactState& at) const {
    if (decaying) return decaying->coefficient(at);
    if (!friction) return 0;
    switch (friction->over) {
      case Varying::Over::nothing:
        return friction->constant;
      case Varying::Over::sliding:
        return friction->evaluate({at.temperature, at.flow_stress, at.pressure, at.speed});
      case Varying::Over::temperature:
        return friction->at(at.temperature);
      case Varying::Over::pressure:
        return friction->at(at.pressure);
      default:
        return friction->at(at.speed);
    }
  }
  /// A force [N] at which contact slips, by all else, with the shear strength.
  Real limited(const ContactState& at, Real force) const {
    return shear_limit ? std::min(force, at.flow_stress / std::sqrt(3.0) * at.area) : force;
  }
};

inline void describe(Schema& s, CoulombFriction& law) {
  static constexpr Varying::Over kFrictionOver[] = {
      Varying::Over::temperature, Varying::Over::slip_speed, Varying::Over::pressure,
      Varying::Over::sliding};
  s.varying_or_law({"friction",
                    "coefficient of Coulomb friction; or a table; or an expression of T [K], mean "
                    "of both surfaces, yield [Pa], flow stress of the softer one, p [Pa] and v "
                    "[m/s], pressure and slip speed; or static, kinetic and decay"},
                   law.friction, law.decaying, {"1", at_least(0), between(0, 2)}, kFrictionOver);
  s.flag({"shear_limit", "friction is never above flow stress / sqrt(3) of the softer side"},
         law.shear_limit);
}

}  // namespace brunt
