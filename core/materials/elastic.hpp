#pragma once
/// No limit of strength: the deviator follows the strain elastically (J = 2 G dev D).
#include "core/schema.hpp"

namespace brunt {

/// The deck's `strength: none`; also what a material without the key has.
struct NoStrength {
  static constexpr const char* deck_name = "none";
  static constexpr const char* deck_help = "never yields: the stress deviator stays elastic";
};
inline void describe(Schema&, NoStrength&) {}

}  // namespace brunt
