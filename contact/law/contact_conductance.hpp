#pragma once
#include <array>
#include <optional>

#include "core/schema.hpp"

namespace brunt {

/// Heat that passes by the difference of temperatures, by pressure, and over a gap.
/// docs/theory/heat.md (H13) to (H15).
struct ContactConductance {
  static constexpr const char* deck_name = "conductance";
  static constexpr const char* deck_help = "heat passes by the difference of temperatures";
  static constexpr bool deck_open = true;
  std::optional<Varying> per_area;  ///< [W/m^2/K] constant or over pressure; always there
  Real width = 0;                   ///< [m] opening up to which heat passes, at no pressure

  Real conductance(Real pressure) const { return per_area ? per_area->at(pressure) : kInfinity; }
  Real gap() const { return width; }
};

inline void describe(Schema& s, ContactConductance& heat) {
  static constexpr std::array kOver{Varying::Over::pressure};
  s.varying(
      {"conductance", "heat through a square metre for a degree of difference", Need::required},
      heat.per_area, {"W/m^2/K", at_least(0), between(1, 1e8)}, kOver);
  s.real({"gap", "opening up to which heat passes"}, heat.width,
         {"m", at_least(0), between(0, 0.01)});
}

}  // namespace brunt
// Tested by tests/verification/contact_heat_options_test.cpp.
