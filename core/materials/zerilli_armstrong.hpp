#pragma once
/// Strength of metals by the motion of dislocations over obstacles.
/// Zerilli, F.J. & Armstrong, R.W., Dislocation-mechanics-based constitutive relations for material
/// dynamics calculations, J. Appl. Phys. 61, 1987, eqs. 16 (fcc) and 19 (bcc), in one.
#include <cmath>

#include "core/materials/printed_law.hpp"
#include "core/schema.hpp"

namespace brunt {

/// The deck's `strength: {zerilli-armstrong: {...}}`.
struct ZerilliArmstrong : PrintedLaw<ZerilliArmstrong> {
  static constexpr const char* deck_name = "zerilli-armstrong";
  static constexpr const char* deck_help =
      "flow stress C0 + (C1 + C2 sqrt(eps_p)) exp((C4 ln rate - C3) T) + C5 eps_p^n; fcc metals "
      "have C2, bcc metals C1 and C5";
  Real C0 = 0;           ///< [Pa]
  Real C1 = 0;           ///< [Pa]
  Real C2 = 0;           ///< [Pa]
  Real C3 = 0;           ///< [1/K]
  Real C4 = 0;           ///< [1/K]
  Real C5 = 0;           ///< [Pa]
  Real n = 1;            ///< [1]
  Real rate_min = 1e-3;  ///< [1/s]
  Real corner_rate() const { return C4 != 0 ? rate_min : 0.0; }

  /// sigma_y = C0 + (C1 + C2 sqrt(eps_p)) exp((C4 ln rate - C3) T) + C5 eps_p^n, the rate in 1/s
  /// and at least rate_min, or there would be no static strength.
  template <class N>
  BRUNT_INLINE N formula(const FlowState<N>& at) const {
    const N activation = (C4 * vlog(held_above(at.rate, rate_min)) - C3) * at.temperature;
    const N thermal = (C1 + C2 * vsqrt(at.eps_p)) * vexp(activation);
    const N athermal = C0 + C5 * vpow(at.eps_p, n);
    return athermal + thermal;
  }
  bool needs_temperature() const { return C1 > 0 || C2 > 0; }
  /// The rate counts in 1/s: at s times the rate C3 takes C4 ln s more.
  void speed_up(Real s) { C3 += C4 * std::log(s); }
};

inline void describe(Schema& s, ZerilliArmstrong& law) {
  s.real({"C0", "stress that neither heat nor rate changes, at no plastic strain", Need::required},
         law.C0, {"Pa", at_least(0), between(1e5, 1e10)});
  s.real({"C1", "thermally activated stress (bcc)"}, law.C1,
         {"Pa", at_least(0), between(1e6, 1e10)});
  s.real({"C2", "thermally activated stress times sqrt(eps_p) (fcc)"}, law.C2,
         {"Pa", at_least(0), between(1e6, 1e10)});
  s.real({"C3", "softening with temperature"}, law.C3, {"1/K", at_least(0), between(1e-4, 0.1)});
  s.real({"C4", "rate sensitivity: softening that an e-fold of the rate takes back"}, law.C4,
         {"1/K", at_least(0), between(1e-6, 1e-2)});
  s.real({"C5", "factor of hardening C5 eps_p^n (bcc)"}, law.C5,
         {"Pa", at_least(0), between(1e6, 1e10)});
  s.real({"n", "exponent of that hardening"}, law.n, {"1", {0, 10, true, false}, between(0.01, 2)});
  s.real({"rate_min", "rate below which the law is static"}, law.rate_min,
         {"1/s", positive(), between(1e-9, 10)});
}

}  // namespace brunt
