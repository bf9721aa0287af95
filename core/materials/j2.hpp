#pragma once
/// Plasticity after von Mises (J2) with isotropic hardening, without rate and heat.
#include <array>
#include <optional>

#include "core/materials/law.hpp"
#include "core/schema.hpp"

namespace brunt {

/// The deck's `strength: {j2: {...}}`.
/// flow stress = yield + R(eps_p), R = H eps_p or a table.   von Mises 1913
struct J2 {
  static constexpr const char* deck_name = "j2";
  static constexpr const char* deck_help = "von Mises plasticity with isotropic hardening";
  Real yield = 0;                    ///< [Pa] flow stress at no plastic strain
  std::optional<Varying> hardening;  ///< [Pa] modulus H; or a table of R over eps_p; none: perfect
};
inline void describe(Schema& s, J2& law) {
  static constexpr std::array over{Varying::Over::eps_p};
  s.real({"yield", "flow stress at no plastic strain", Need::required}, law.yield,
         {"Pa", at_least(0), between(1e3, 1e10)});
  s.varying({"hardening",
             "modulus: flow stress gained per plastic strain; or a table over eps_p of the stress "
             "gained; without it the material is perfectly plastic"},
            law.hardening, {"Pa", at_least(0), between(0, 1e11)}, over);
}

}  // namespace brunt
