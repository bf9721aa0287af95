#pragma once
#include <algorithm>
#include <bit>
#include <vector>

#include "core/parallel/communicator.hpp"

namespace brunt {

/// The median of the values of all ranks, none of them negative; 0 without any. Collective: bits of
/// numbers that are not negative ascend with them, and are halved until one is left.
/// values  of this rank; reordered
inline Real median_of_all(std::vector<Real>& values, const Communicator& ranks) {
  std::sort(values.begin(), values.end());
  const std::uint64_t n = ranks.sum(values.size());
  if (n == 0) return 0;
  if (ranks.alone()) return values[n / 2];
  std::uint64_t low = 0, high = std::bit_cast<std::uint64_t>(kInfinity);
  while (low < high) {
    const std::uint64_t middle = low + (high - low) / 2;
    const auto end = std::upper_bound(values.begin(), values.end(), std::bit_cast<Real>(middle));
    const std::uint64_t below = ranks.sum(static_cast<std::uint64_t>(end - values.begin()));
    if (below > n / 2) {
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  return std::bit_cast<Real>(low);
}

}  // namespace brunt
// Tested by tests/parallel/ranks.sh.
