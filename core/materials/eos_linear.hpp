#pragma once
#include "core/schema.hpp"

namespace brunt {

/// The deck's `eos: linear`; also what a material without the key has.
struct LinearEos {
  static constexpr const char* deck_name = "linear";
  static constexpr const char* deck_help = "p = K (rho/rho0 - 1), K from the elastic constants";
};
inline void describe(Schema&, LinearEos&) {}

}  // namespace brunt
