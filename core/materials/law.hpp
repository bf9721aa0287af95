#pragma once
#include "core/types.hpp"

namespace brunt {

/// Flow stress with its slopes, of one point (Real) or four (Pack).
template <class V>
struct FlowStress {
  V value;          ///< [Pa]
  V d_eps_p;        ///< [Pa]
  V d_rate;         ///< [Pa s]
  V d_temperature;  ///< [Pa/K]
};

}  // namespace brunt
