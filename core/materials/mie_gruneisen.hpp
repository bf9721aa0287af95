#pragma once
#include "core/schema.hpp"

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

}  // namespace brunt
