#pragma once
/// Strength of metals under large strains, high rates and heat.
/// Johnson, G.R. & Cook, W.H., A constitutive model and data for metals subjected to large strains,
/// high strain rates and high temperatures, Proc. 7th Int. Symp. on Ballistics, 1983, eq. 1.
#include <optional>

#include "core/materials/law.hpp"
#include "core/schema.hpp"

namespace brunt {

/// The deck's `strength: {johnson-cook: {...}}`.
struct JohnsonCook {
  static constexpr const char* deck_name = "johnson-cook";
  static constexpr const char* deck_help =
      "flow stress (A + B eps_p^n) (1 + C ln(rate/rate_ref)) (1 - T*^m)";
  Real A = 0;                  ///< [Pa]
  Real B = 0;                  ///< [Pa]
  Real n = 1;                  ///< [1]
  Real C = 0;                  ///< [1]
  Real rate_ref = 1;           ///< [1/s]
  Real m = 1;                  ///< [1]
  std::optional<Real> T_melt;  ///< [K]; none: heat does not soften
  Real T_ref = 298;            ///< [K]
};
inline void describe(Schema& s, JohnsonCook& law) {
  s.real({"A", "static flow stress at no plastic strain and T_ref", Need::required}, law.A,
         {"Pa", at_least(0), between(1e5, 1e10)});
  s.real({"B", "factor of hardening B eps_p^n", Need::required}, law.B,
         {"Pa", at_least(0), between(0, 1e10)});
  s.real({"n", "exponent of hardening", Need::required}, law.n,
         {"1", {0, 10, true, false}, between(0.01, 2)});
  s.real({"C", "flow stress gained per e-fold of the rate above rate_ref"}, law.C,
         {"1", at_least(0), between(0, 0.2)});
  s.real({"rate_ref", "plastic strain rate below which the law is static"}, law.rate_ref,
         {"1/s", positive(), between(1e-6, 1e3)});
  s.real({"m", "exponent of thermal softening"}, law.m,
         {"1", {0, 10, true, false}, between(0.3, 3)});
  s.real(
      {"T_melt", "temperature of melting: no strength from there; without it heat does not soften"},
      law.T_melt, {"K", positive(), between(200, 5000)});
  s.real({"T_ref", "temperature up to which heat does not soften"}, law.T_ref,
         {"K", at_least(0), between(50, 1000)});
  s.require(!law.T_melt || *law.T_melt > law.T_ref, "T_melt", "T_melt must be above T_ref");
}

}  // namespace brunt
