#include "contact/law/pair_laws.hpp"

#include <algorithm>

namespace brunt {

Real PairLaws::slip_limit(const ContactState& at, Real& coefficient) const {
  if (at.pressure > 0 || at.bonded) coefficient = friction->coefficient(at);
  return friction->limited(
      at, at.bonded ? bond.slip_limit(at, coefficient) : coefficient * std::max(at.push, 0.0));
}

}  // namespace brunt
// Tested by tests/unit/contact/cohesive_bond_test.cpp.
