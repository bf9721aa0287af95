#pragma once
#include <array>
#include <optional>
#include <variant>

#include "core/schema.hpp"

namespace brunt {

/// The deck's `heat` of a pair: whether heat passes from body to body where they touch.
struct NoContactHeat {
  static constexpr const char* deck_name = "none";
  static constexpr const char* deck_help = "no heat passes";
};
struct PerfectContactHeat {
  static constexpr const char* deck_name = "perfect";
  static constexpr const char* deck_help = "both sides have the same temperature";
};
struct ContactConductance {
  static constexpr const char* deck_name = "conductance";
  static constexpr const char* deck_help = "heat passes by the difference of temperatures";
  static constexpr bool deck_open = true;
  std::optional<Varying> per_area;  ///< [W/m^2/K] constant or over pressure; always there
  Real gap = 0;                     ///< [m] opening up to which heat passes, at no pressure
};
using ContactHeat = std::variant<NoContactHeat, PerfectContactHeat, ContactConductance>;

/// [W/m^2/K] through a contact under a pressure [Pa], infinite where it is perfect.
inline Real conductance_of(const ContactHeat& heat, Real pressure) {
  if (std::holds_alternative<NoContactHeat>(heat)) return 0;
  const auto* given = std::get_if<ContactConductance>(&heat);
  return given != nullptr && given->per_area ? given->per_area->at(pressure) : kInfinity;
}
/// [m] opening up to which heat passes.
inline Real gap_of(const ContactHeat& heat) {
  const auto* given = std::get_if<ContactConductance>(&heat);
  return given != nullptr ? given->gap : 0.0;
}

/// What becomes of the heat of friction: `fraction` of it goes to the two bodies, the rest leaves
/// the scene. Of what goes to a body that keeps no temperature nothing is left either.
struct FrictionHeat {
  Real fraction = 1;          ///< [1]
  std::optional<Real> split;  ///< [1] of it to the first body; none: by sqrt(k rho cp) of both
};

inline void describe(Schema&, NoContactHeat&) {}
inline void describe(Schema&, PerfectContactHeat&) {}
inline void describe(Schema& s, ContactConductance& heat) {
  static constexpr std::array kOver{Varying::Over::pressure};
  s.varying(
      {"conductance", "heat through a square metre for a degree of difference", Need::required},
      heat.per_area, {"W/m^2/K", at_least(0), between(1, 1e8)}, kOver);
  s.real({"gap", "opening up to which heat passes"}, heat.gap,
         {"m", at_least(0), between(0, 0.01)});
}
inline void describe(Schema& s, FrictionHeat& heat) {
  s.real({"fraction", "share of it that warms the bodies; the rest leaves the scene"},
         heat.fraction, {"1", between(0, 1)});
  s.real_or_word({"split",
                  "share of that for the body that `between` names first, in `default` the first "
                  "of the deck; effusivity: by sqrt(k rho cp)"},
                 heat.split, {"1", between(0, 1)}, "effusivity");
}

}  // namespace brunt
// Tested by tests/verification/contact_heat_options_test.cpp.
