#pragma once
/// Strength of soil, sand and rock, which grows with the pressure.
/// Drucker, D.C. & Prager, W., Soil mechanics and plastic analysis or limit design, Quart. Appl.
/// Math. 10, 1952; the cones about Mohr and Coulomb's pyramid as in Chen, W.F. & Mizuno, E.,
/// Nonlinear analysis in soil mechanics, 1990.
#include <cmath>

#include "core/materials/printed_law.hpp"
#include "core/schema.hpp"

namespace brunt {

/// The deck's `strength: {drucker-prager: {...}}`.
struct DruckerPrager : PrintedPressureLaw<DruckerPrager> {
  static constexpr const char* deck_name = "drucker-prager";
  static constexpr const char* deck_help =
      "soil, sand, rock: flow stress A + B p of Mohr and Coulomb's cohesion and friction angle; "
      "it dilates by the dilation angle, and opens in tension beyond A/B";
  static constexpr bool kChangesVolume = true;
  /// Where the cone touches Mohr and Coulomb's pyramid.
  enum class Fit { compression, extension, plane_strain };
  Real cohesion = 0;        ///< [Pa]
  Real friction_angle = 0;  ///< [rad]
  Real dilation_angle = 0;  ///< [rad]
  Fit fit = Fit::compression;

  /// sigma_y = A + B p, and nothing beyond the apex; docs/theory/materials.md (M20).
  template <class N>
  BRUNT_INLINE N formula(const PressureState<N>& at) const {
    return held_above(intercept_ + slope_ * at.pressure, 0);
  }
  Real dilation() const { return friction(dilation_angle); }
  Real tension_limit() const { return slope_ > 0 ? intercept_ / slope_ : kInfinity; }
  bool needs_temperature() const { return false; }

  /// dq/dp [1] of the cone for an angle: compression, extension 6 sin/(3 -+ sin), plane strain
  /// 3 sqrt(3) tan/sqrt(9 + 12 tan^2).
  Real friction(Real angle) const {
    const Real s = std::sin(angle), t = std::tan(angle);
    if (fit == Fit::plane_strain) return std::sqrt(27.0) * t / std::sqrt(9 + 12 * t * t);
    return 6 * s / (fit == Fit::compression ? 3 - s : 3 + s);
  }
  /// A of the cone at c = 1 and B meet at the apex: A = c cot(phi) B, which is finite at phi = 0.
  void prepare() {
    const Real s = std::sin(friction_angle), c = std::cos(friction_angle);
    const Real t = std::tan(friction_angle);
    slope_ = friction(friction_angle);
    intercept_ = fit == Fit::plane_strain ? std::sqrt(27.0) / std::sqrt(9 + 12 * t * t)
                                          : 6 * c / (fit == Fit::compression ? 3 - s : 3 + s);
    intercept_ *= cohesion;
  }

 private:
  Real intercept_ = 0;  // [Pa] A
  Real slope_ = 0;      // [1] B
};

inline void describe(Schema& s, DruckerPrager& law) {
  static constexpr const char* kFits[] = {"compression", "extension", "plane-strain"};
  s.real(
      {"cohesion", "shear strength of a plane without pressure on it; 0: dry sand", Need::required},
      law.cohesion, {"Pa", at_least(0), between(0, 1e9)});
  s.real({"friction_angle", "angle of internal friction", Need::required}, law.friction_angle,
         {"rad", {0, 0.5 * kPi, false, true}, between(0, 1.2)});
  s.real(
      {"dilation_angle",
       "angle by which shear loosens it; as large as friction_angle: associated flow; 0: plastic "
       "flow keeps the volume"},
      law.dilation_angle, {"rad", {0, 0.5 * kPi, false, true}, between(0, 1.2)});
  s.choice({"fit",
            "where the cone touches Mohr and Coulomb's pyramid: in triaxial compression, in "
            "triaxial extension, or, with associated flow, in plane strain"},
           law.fit, kFits);
  s.require(law.dilation_angle <= law.friction_angle, "dilation_angle",
            "dilation_angle must not be above friction_angle: plastic flow would make energy");
}

}  // namespace brunt
