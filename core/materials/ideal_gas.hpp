#pragma once
/// The ideal gas of constant specific heats (Clapeyron 1834), calorically perfect.
#include "core/materials/printed_eos.hpp"
#include "core/schema.hpp"

namespace brunt {

/// The deck's `eos: {ideal-gas: {...}}`.
struct IdealGas : PrintedEos {
  static constexpr const char* deck_name = "ideal-gas";
  static constexpr const char* deck_help = "p = (gamma - 1) rho e; starts at a pressure";
  static constexpr bool kFluid = true;
  Real gamma = 1.4;   ///< [1] ratio of specific heats
  Real pressure = 0;  ///< [Pa] absolute, at the reference density

  /// p = (gamma - 1) rho/rho0 E.
  template <class N>
  BRUNT_INLINE N formula(const EosState<N>& at) const {
    return (gamma - 1) * (at.relative_density * at.energy);
  }
  Real initial_energy() const { return pressure / (gamma - 1); }
};

inline void describe(Schema& s, IdealGas& gas) {
  s.real({"gamma", "ratio of specific heats: 1.4 of air, 5/3 of noble gases"}, gas.gamma,
         {"1", {1, kInfinity, true, false}, between(1.01, 3)});
  s.real({"pressure", "absolute pressure at the density given", Need::required}, gas.pressure,
         {"Pa", positive(), between(1, 1e11)});
}

}  // namespace brunt
