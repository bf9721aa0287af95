#pragma once
/// Strength of metals at high rates and pressures.
/// Steinberg, D.J., Cochran, S.G. & Guinan, M.W., A constitutive model for metals applicable at
/// high-strain rate, J. Appl. Phys. 51, 1980, eqs. 2 and 3.
#include <optional>

#include "core/materials/printed_law.hpp"
#include "core/schema.hpp"

namespace brunt {

/// The deck's `strength: {steinberg-guinan: {...}}`.
struct SteinbergGuinan : PrintedPressureLaw<SteinbergGuinan> {
  static constexpr const char* deck_name = "steinberg-guinan";
  static constexpr const char* deck_help =
      "metals above 1e5/s: flow stress Y0 (1 + beta (eps_p + eps_i))^n, at most Y_max, times 1 + A "
      "p eta^(-1/3) - B (T - 300 K), eta = rho/rho0; the shear modulus stays that of `elastic`";
  Real Y0 = 0;                         ///< [Pa]
  Real beta = 0;                       ///< [1]
  Real n = 1;                          ///< [1]
  Real eps_i = 0;                      ///< [1]
  std::optional<Real> Y_max;           ///< [Pa]; none: no bound
  Real A = 0;                          ///< [1/Pa] Y'_P/Y0
  Real B = 0;                          ///< [1/K] -G'_T/G0
  static constexpr Real kT_ref = 300;  ///< [K]

  /// sigma_y = Y0 (1 + beta (eps_p + eps_i))^n [1 + A p/eta^(1/3) - B (T - 300)], its first factor
  /// at most Y_max and its second at least 0; docs/theory/materials.md (M19).
  template <class N>
  BRUNT_INLINE N formula(const PressureState<N>& at) const {
    const N hardened = Y0 * vpow(1.0 + beta * (at.eps_p + eps_i), n);
    const N factor = 1.0 + A * (at.pressure * vpow(at.relative_density, -1.0 / 3)) -
                     B * (at.temperature - kT_ref);
    return held_below(hardened, Y_max.value_or(kInfinity)) * held_above(factor, 0);
  }
  bool needs_temperature() const { return B > 0; }
};

inline void describe(Schema& s, SteinbergGuinan& law) {
  s.real({"Y0", "flow stress at no plastic strain, no pressure and 300 K", Need::required}, law.Y0,
         {"Pa", at_least(0), between(1e6, 1e10)});
  s.real({"beta", "hardening with plastic strain"}, law.beta, {"1", at_least(0), between(0, 1e5)});
  s.real({"n", "exponent of hardening"}, law.n, {"1", {0, 10, true, false}, between(0.01, 2)});
  s.real({"eps_i", "plastic strain before time 0"}, law.eps_i, {"1", at_least(0), between(0, 10)});
  s.real({"Y_max", "what hardening reaches at most"}, law.Y_max,
         {"Pa", positive(), between(1e6, 1e11)});
  s.real({"A", "part of the strength gained per pressure, Y'_P/Y0; as that of the shear modulus"},
         law.A, {"1/Pa", at_least(0), between(1e-13, 1e-9)});
  s.real({"B", "part of the strength lost per kelvin above 300 K, -G'_T/G0"}, law.B,
         {"1/K", at_least(0), between(1e-5, 1e-2)});
  s.require(!law.Y_max || *law.Y_max >= law.Y0, "Y_max", "Y_max must not be below Y0");
}

}  // namespace brunt
