#pragma once
#include "core/types.hpp"

namespace brunt {

/// What the laws of a contact see of it at the end of a step. The first four stand in the order of
/// the names of expressions in decks: T, yield, p, v.
struct ContactState {
  Real temperature = 0;          ///< [K] mean of the surfaces of both sides
  Real flow_stress = kInfinity;  ///< [Pa] of the softer side; infinite where neither yields
  Real pressure = 0;             ///< [Pa]
  Real speed = 0;                ///< [m/s] of slip
  Real push = 0;                 ///< [N] along the normal; below 0 where a bond pulls
  Real area = 0;                 ///< [m^2] that is pressed, or held
  Real penetration = 0;          ///< [m]
  Real closing = 0;              ///< [m/s] along the normal
  bool bonded = false;           ///< its bond holds
};

}  // namespace brunt
