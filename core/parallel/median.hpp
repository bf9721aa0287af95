#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <span>
#include <vector>

#include "core/parallel/communicator.hpp"

namespace brunt {

/// The median of the values of all ranks, none of them negative; 0 without any. Collective: numbers
/// that are not negative ascend with their bits, which are found eight at a time by counting.
/// values  of this rank; reordered
inline Real median_of_all(std::vector<Real>& values, const Communicator& ranks) {
  const std::uint64_t n = ranks.sum(values.size());
  if (n == 0) return 0;
  std::uint64_t rank = n / 2;  // of the median among all
  if (ranks.alone()) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(rank);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
  }
  constexpr int kBits = 8;
  std::uint64_t found = 0;
  for (int shift = 64 - kBits; shift >= 0; shift -= kBits) {
    std::array<std::uint64_t, 1 << kBits> counts{};
    const std::uint64_t higher = shift + kBits < 64 ? ~std::uint64_t{0} << (shift + kBits) : 0;
    for (const Real value : values) {
      const auto bits = std::bit_cast<std::uint64_t>(value);
      if ((bits & higher) == found) ++counts[bits >> shift & (counts.size() - 1)];
    }
    ranks.reduce_all(std::span<std::uint64_t>(counts),
                     [](std::uint64_t& a, std::uint64_t b) { a += b; });
    std::uint64_t bin = 0;
    while (rank >= counts[bin]) rank -= counts[bin++];
    found |= bin << shift;
  }
  return std::bit_cast<Real>(found);
}

}  // namespace brunt
// Tested by tests/parallel/ranks.sh.
