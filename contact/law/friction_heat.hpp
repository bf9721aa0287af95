#pragma once
#include <optional>

#include "core/schema.hpp"

namespace brunt {

/// What becomes of the heat of friction: `fraction` of it goes to the two bodies, the rest leaves
/// the scene. Of what goes to a body that keeps no temperature nothing is left either.
/// docs/theory/heat.md (H16), (H17).
struct FrictionHeat {
  Real fraction = 1;          ///< [1]
  std::optional<Real> split;  ///< [1] of it to the first body; none: by sqrt(k rho cp) of both
};

inline void describe(Schema& s, FrictionHeat& heat) {
  s.real({"fraction", "share of it that heats the bodies; the rest leaves the scene"},
         heat.fraction, {"1", between(0, 1)});
  s.real_or_word({"split",
                  "share of that for the body that `between` names first, in `default` the first "
                  "of the deck; effusivity: by sqrt(k rho cp)"},
                 heat.split, {"1", between(0, 1)}, "effusivity");
}

}  // namespace brunt
