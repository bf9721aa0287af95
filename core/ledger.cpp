#include "core/ledger.hpp"

namespace brunt {

std::string_view column_name(Column column) {
  static constexpr std::array<std::string_view, kColumns> names = {
      "kinetic",           "internal",       "plastic_heat",    "hourglass",        "viscosity",
      "artificial_stress", "contact.spring", "contact.damping", "contact.friction", "contact.pairs",
      "boundary",          "damping",        "eroded",          "expansion",        "integration"};
  return names[slot_of(column)];
}

}  // namespace brunt
