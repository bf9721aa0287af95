#pragma once
/// Shock equation of state of Mie and Grueneisen about the principal Hugoniot.
/// Form of p and tension as in LS-DYNA's Gruneisen equation with a = 0; Marsh, LASL Shock Hugoniot
/// Data, 1980, for U_s = c0 + s u_p.
#include "core/materials/material.hpp"
#include "core/schema.hpp"
#include "core/simd.hpp"

namespace brunt {

/// The deck's `eos: {mie-gruneisen: {...}}`: about the Hugoniot of U_s = c0 + s u_p.
struct MieGruneisen {
  static constexpr const char* deck_name = "mie-gruneisen";
  static constexpr const char* deck_help = "shock equation of state about U_s = c0 + s u_p";
  Real c0 = 0;      ///< [m/s] bulk sound speed at the reference state
  Real s = 0;       ///< [1] slope of shock over particle speed
  Real gamma0 = 0;  ///< [1] Grueneisen's gamma; gamma rho is constant
};
inline void describe(Schema& schema, MieGruneisen& eos) {
  schema.real({"c0", "bulk sound speed at the reference state", Need::required}, eos.c0,
              {"m/s", positive(), between(100, 2e4)});
  schema.real({"s", "slope of shock speed over particle speed", Need::required}, eos.s,
              {"1", at_least(0), between(0.5, 3)});
  schema.real({"gamma0", "Grueneisen's gamma at the reference density", Need::required}, eos.gamma0,
              {"1", at_least(0), between(0, 4)});
}

/// Pressure that does not depend on energy, and its slope in compression.
template <class V>
struct ColdPressure {
  V pressure;  ///< [Pa]
  V slope;     ///< [Pa] -dp/d(V/V0) at constant energy
};

/// p = p_cold(V/V0) + gamma0 E, E the internal energy per reference volume. With eta = 1 - V/V0:
///   compression  p_cold = p_H (1 - gamma0 eta / 2), p_H = rho0 c0^2 eta / (1 - s eta)^2
///   tension      p_cold = rho0 c0^2 (V0/V - 1)
/// s eta is held below 0.95 (where p_H is 400 / s times rho0 c0^2): denser is no denser.
/// Energy dE = -p d(V/V0) + work is taken at the mean of old and new p, which is linear in E.
class MieGruneisenEquation final : public EquationOfState {
 public:
  /// density  rho0 [kg/m^3]
  MieGruneisenEquation(const MieGruneisen& law, Real density);
  void update(MaterialTile& tile, const Real* deviatoric_work) const override;
  bool needs_energy() const override { return true; }
  Real bulk_modulus() const override { return bulk_; }
  Real densest_ratio() const override { return densest_ratio_; }
  /// gamma0 (eta_new - eta_old), eta held as in p_cold, and at the cut-off where V/V0 has reached
  /// what p = -cutoff has at this energy.
  void isentropic_heating(const MaterialTile& tile, Real cutoff, Real* logarithm) const override;
  void held_ratio(Real tension, const Real* ratio, const Real* energy, int count,
                  Real* held) const override;

  /// Pressure at V/V0 and E = 0.
  template <class V>
  BRUNT_INLINE ColdPressure<V> cold_pressure(V ratio) const {
    const V held = vmax(ratio, broadcast<V>(densest_ratio_));
    const V eta = 1.0 - held;
    const V inverse = 1.0 / (1.0 - law_.s * eta);
    const V square = bulk_ * (inverse * inverse);
    const V hugoniot = square * eta;
    const V hugoniot_slope = square * ((1.0 + law_.s * eta) * inverse);
    const V share = 1.0 - (0.5 * law_.gamma0) * eta;
    const V slope = hugoniot_slope * share - (0.5 * law_.gamma0) * hugoniot;
    const V density = 1.0 / held;
    const auto compressed = held < 1.0;
    return {select(compressed, hugoniot * share, bulk_ * (density - 1.0)),
            select(compressed, slope, bulk_ * (density * density))};
  }

 private:
  MieGruneisen law_;
  Real bulk_;           // [Pa] rho0 c0^2
  Real densest_ratio_;  // V/V0
};

}  // namespace brunt
// Tested by tests/unit/core/eos_test.cpp.
