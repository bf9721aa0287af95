#include "core/geometry/curve.hpp"

#include <algorithm>
#include <numeric>

namespace brunt {

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
    std::uint64_t cell[Dim];
    for (int c = 0; c < Dim; ++c) {
      cell[c] = static_cast<std::uint64_t>((x[i][c] - low[c]) * scale);
    }
    std::uint64_t key = 0;
    for (int b = bits - 1; b >= 0; --b) {
      for (int c = Dim - 1; c >= 0; --c) key = key << 1 | ((cell[c] >> b) & 1);
    }
    keys[i] = key;
  }
  return keys;
}

std::vector<std::size_t> order_of(const std::vector<std::uint64_t>& keys) {
  std::vector<std::size_t> order(keys.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return keys[a] < keys[b]; });
  return order;
}

template std::vector<std::uint64_t> curve_keys<2>(const std::vector<Vec<2>>&);
template std::vector<std::uint64_t> curve_keys<3>(const std::vector<Vec<3>>&);

}  // namespace brunt
// Tested by tests/unit/core/shapes_test.cpp.
