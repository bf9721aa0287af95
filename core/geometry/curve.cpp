#include "core/geometry/curve.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace brunt {

namespace {
/// The lowest bits of x with as many places between them as there are other axes: the upper half
/// moves up, then the upper half of each half, and so on (Warren, Hacker's Delight, 7-2).
/// x  below 2^31 in the plane, 2^21 in space
template <int Dim>
std::uint64_t spread_bits(std::uint64_t x) {
  if constexpr (Dim == 2) {
    x = (x | x << 16) & 0x0000FFFF0000FFFFULL;
    x = (x | x << 8) & 0x00FF00FF00FF00FFULL;
    x = (x | x << 4) & 0x0F0F0F0F0F0F0F0FULL;
    x = (x | x << 2) & 0x3333333333333333ULL;
    return (x | x << 1) & 0x5555555555555555ULL;
  } else {
    x = (x | x << 32) & 0x001F00000000FFFFULL;
    x = (x | x << 16) & 0x001F0000FF0000FFULL;
    x = (x | x << 8) & 0x100F00F00F00F00FULL;
    x = (x | x << 4) & 0x10C30C30C30C30C3ULL;
    return (x | x << 2) & 0x1249249249249249ULL;
  }
}

/// Keys and the places that they had.
struct PlacedKeys {
  std::vector<std::uint64_t> key;
  std::vector<std::uint32_t> place;
};

/// Sorts by some bits of the keys, equal ones as they stand, out of one array into the other; false
/// where all are equal, and nothing is done.
bool sort_by_digit(const PlacedKeys& from, int first_bit, int bits, PlacedKeys& to) {
  const std::uint64_t mask = (std::uint64_t{1} << bits) - 1;
  const auto digit = [&](std::uint64_t key) { return key >> first_bit & mask; };
  std::vector<std::size_t> begin(mask + 2, 0);
  for (const std::uint64_t key : from.key) ++begin[digit(key) + 1];
  if (begin[digit(from.key.front()) + 1] == from.key.size()) return false;
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  for (std::size_t k = 0; k < from.key.size(); ++k) {
    const std::size_t at = begin[digit(from.key[k])]++;
    to.key[at] = from.key[k], to.place[at] = from.place[k];
  }
  return true;
}
}  // namespace

template <int Dim>
std::vector<std::uint64_t> curve_keys(const std::vector<Vec<Dim>>& x) {
  constexpr int bits = Dim == 2 ? 31 : 20;
  std::vector<std::uint64_t> keys(x.size());
  if (x.empty()) return keys;
  Vec<Dim> low = x.front(), high = x.front();
  for (const auto& p : x) low = low.cwiseMin(p), high = high.cwiseMax(p);
  const Real extent = (high - low).maxCoeff();
  const Real scale = extent > 0 ? (std::uint64_t{1} << bits) * (1 - 1e-9) / extent : 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (int c = 0; c < Dim; ++c) {
      keys[i] |= spread_bits<Dim>(static_cast<std::uint64_t>((x[i][c] - low[c]) * scale)) << c;
    }
  }
  return keys;
}

/// By the lowest digits first: each pass keeps the order of the last.
std::vector<std::uint32_t> order_of(std::vector<std::uint64_t> keys) {
  constexpr int kDigit = 11, kBits = 64;
  const std::size_t n = keys.size();
  PlacedKeys sorted{std::move(keys), std::vector<std::uint32_t>(n)};
  std::iota(sorted.place.begin(), sorted.place.end(), 0U);
  PlacedKeys other{std::vector<std::uint64_t>(n), std::vector<std::uint32_t>(n)};
  for (int bit = 0; bit < kBits && n > 0; bit += kDigit) {
    if (sort_by_digit(sorted, bit, std::min(kDigit, kBits - bit), other)) {
      std::swap(sorted, other);
    }
  }
  return sorted.place;
}

template std::vector<std::uint64_t> curve_keys<2>(const std::vector<Vec<2>>&);
template std::vector<std::uint64_t> curve_keys<3>(const std::vector<Vec<3>>&);

}  // namespace brunt
// Tested by tests/unit/core/shapes_test.cpp.
