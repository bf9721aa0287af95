#pragma once
#include "core/schema.hpp"

namespace brunt {

struct NoContactHeat {
  static constexpr const char* deck_name = "none";
  static constexpr const char* deck_help = "no heat passes";
  Real conductance(Real) const { return 0; }
  Real gap() const { return 0; }
};
struct PerfectContactHeat {
  static constexpr const char* deck_name = "perfect";
  static constexpr const char* deck_help = "both sides have the same temperature";
  Real conductance(Real) const { return kInfinity; }
  Real gap() const { return 0; }
};

inline void describe(Schema&, NoContactHeat&) {}
inline void describe(Schema&, PerfectContactHeat&) {}

}  // namespace brunt
// Tested by tests/verification/contact_heat_options_test.cpp.
