#include "core/schema.hpp"

#include <algorithm>
#include <cassert>

namespace brunt {

Real Varying::at(Real s) const {
  if (over == Over::nothing) return constant;
  assert(!is_expression() && !abscissa.empty());
  if (s <= abscissa.front()) return ordinate.front();
  if (s >= abscissa.back()) return ordinate.back();
  const auto next = std::upper_bound(abscissa.begin(), abscissa.end(), s);
  const auto i = slot_of(next - abscissa.begin());
  const Real fraction = (s - abscissa[i - 1]) / (abscissa[i] - abscissa[i - 1]);
  return ordinate[i - 1] + fraction * (ordinate[i] - ordinate[i - 1]);
}

}  // namespace brunt
// Tested by tests/unit/app/deck_keys_test.cpp.
