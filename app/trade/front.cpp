#include "app/trade/front.hpp"

#include <algorithm>

namespace brunt {

Repeated repeated(std::vector<Real> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size(), middle = n / 2;
  Repeated result;
  result.median = n % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
  result.low = values.front();
  result.high = values.back();
  result.count = static_cast<int>(n);
  return result;
}

namespace {
constexpr Real kSameError = 0.01;  // nobody pays for a hundredth of an error
constexpr Real kRoundOff = 1e-12;
}  // namespace

std::vector<Dominance> dominated(const std::vector<CostError>& all) {
  std::vector<Dominance> result(all.size());
  for (std::size_t b = 0; b < all.size(); ++b) {
    bool any_clear = false;
    for (std::size_t a = 0; a < all.size(); ++a) {
      const bool cheaper = all[a].cost.median < all[b].cost.median;
      const bool as_dear = all[a].cost.median == all[b].cost.median;
      const bool better = all[a].error < all[b].error;
      const bool no_worse = all[a].error <= (1 + kSameError) * all[b].error + kRoundOff;
      if (!(cheaper && no_worse) && !(as_dear && better)) continue;
      any_clear = any_clear || all[a].cost.high <= all[b].cost.low;
      auto& by = result[b].by;
      if (!by || all[a].error < all[*by].error) by = a;
    }
    result[b].clear = !result[b].by || any_clear;
  }
  return result;
}

}  // namespace brunt
