#include "core/ledger.hpp"

#include <bit>

namespace brunt {

std::string_view column_name(Column column) {
  static constexpr std::array<std::string_view, kColumns> names = {
      "kinetic",           "internal",       "plastic_heat",    "hourglass",        "viscosity",
      "artificial_stress", "contact.spring", "contact.damping", "contact.friction", "contact.pairs",
      "boundary",          "damping",        "eroded",          "integration"};
  return names[static_cast<std::size_t>(column)];
}

std::uint64_t mix(std::uint64_t hash, Real value) {
  return mix(hash, std::bit_cast<std::uint64_t>(value));
}

}  // namespace brunt
