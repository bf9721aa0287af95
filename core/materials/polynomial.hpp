#pragma once
/// A polynomial of the compression, linear in the energy, as LS-DYNA's *EOS_LINEAR_POLYNOMIAL
/// (LS-DYNA keyword user's manual, vol. II, *EOS_001).
#include "core/materials/printed_eos.hpp"
#include "core/schema.hpp"

namespace brunt {

/// The deck's `eos: {polynomial: {...}}`.
struct Polynomial : PrintedEos {
  static constexpr const char* deck_name = "polynomial";
  static constexpr const char* deck_help =
      "p = C0 + C1 mu + C2 mu^2 + C3 mu^3 + (C4 + C5 mu + C6 mu^2) E, mu = rho/rho0 - 1; in "
      "expansion without C2 and C6";
  Real C0 = 0, C1 = 0, C2 = 0, C3 = 0;  ///< [Pa]
  Real C4 = 0, C5 = 0, C6 = 0;          ///< [1]
  Real E0 = 0;                          ///< [J/m^3] energy at the reference state

  template <class N>
  BRUNT_INLINE N formula(const EosState<N>& at) const {
    const N mu = at.relative_density - 1.0;
    const N pressed = held_above(mu, 0);  // its square vanishes in expansion, with its slope
    return (C0 + C1 * mu) + C2 * (pressed * pressed) + C3 * (mu * (mu * mu)) +
           ((C4 + C5 * mu) + C6 * (pressed * pressed)) * at.energy;
  }
  bool needs_energy() const { return C4 != 0 || C5 != 0 || C6 != 0; }
  Real initial_energy() const { return E0; }
};

inline void describe(Schema& s, Polynomial& law) {
  const Quantity pressure{"Pa", {}, between(-1e13, 1e13)}, number{"1", {}, between(-100, 100)};
  s.real({"C0", "pressure at the density given"}, law.C0, pressure);
  s.real({"C1", "bulk modulus there"}, law.C1, pressure);
  s.real({"C2", "of the square of the compression"}, law.C2, pressure);
  s.real({"C3", "of its cube"}, law.C3, pressure);
  s.real({"C4", "of the energy per reference volume: gamma - 1 of a gas"}, law.C4, number);
  s.real({"C5", "of compression times energy"}, law.C5, number);
  s.real({"C6", "of the square of the compression times energy"}, law.C6, number);
  s.real({"E0", "energy per reference volume at the start"}, law.E0,
         {"J/m^3", at_least(0), between(0, 1e12)});
  s.require(law.C1 + (law.C5 + law.C4 * law.C4) * law.E0 + law.C4 * law.C0 > 0, "",
            "has no stiffness at the start: C1 + C4 (C0 + C4 E0) + C5 E0 must be above 0");
}

}  // namespace brunt
