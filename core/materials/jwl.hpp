#pragma once
/// Detonation products: Lee, E.L., Hornig, H.C. & Kury, J.W., Adiabatic expansion of high explosive
/// detonation products, UCRL-50422, 1968 (Jones, Wilkins and Lee).
#include "core/materials/printed_eos.hpp"
#include "core/schema.hpp"

namespace brunt {

/// The deck's `eos: {jwl: {...}}`: an explosive that has burnt where it lay, at its own density.
struct Jwl : PrintedEos {
  static constexpr const char* deck_name = "jwl";
  static constexpr const char* deck_help =
      "products of an explosive, burnt at the start: p = A (1 - omega/(R1 V)) exp(-R1 V) + B (1 - "
      "omega/(R2 V)) exp(-R2 V) + omega E/V";
  static constexpr bool kFluid = true;
  Real A = 0, B = 0;    ///< [Pa]
  Real R1 = 1, R2 = 1;  ///< [1]
  Real omega = 0.3;     ///< [1]
  Real E0 = 0;          ///< [J/m^3] energy of the explosive

  template <class N>
  BRUNT_INLINE N formula(const EosState<N>& at) const {
    const N first = (1.0 - (omega / R1) * at.relative_density) * vexp(-R1 * at.ratio);
    const N second = (1.0 - (omega / R2) * at.relative_density) * vexp(-R2 * at.ratio);
    return A * first + B * second + omega * (at.relative_density * at.energy);
  }
  Real initial_energy() const { return E0; }
};

inline void describe(Schema& s, Jwl& products) {
  const Quantity pressure{"Pa", at_least(0), between(1e7, 1e13)};
  const Quantity number{"1", positive(), between(0.1, 20)};
  s.real({"A", "of the steep exponential", Need::required}, products.A, pressure);
  s.real({"B", "of the flat exponential", Need::required}, products.B, pressure);
  s.real({"R1", "slope of the steep exponential", Need::required}, products.R1, number);
  s.real({"R2", "slope of the flat exponential", Need::required}, products.R2, number);
  s.real({"omega", "Grueneisen's gamma far expanded", Need::required}, products.omega,
         {"1", positive(), between(0.1, 1)});
  s.real({"E0", "energy of the explosive per volume of it", Need::required}, products.E0,
         {"J/m^3", positive(), between(1e8, 1e11)});
}

}  // namespace brunt
