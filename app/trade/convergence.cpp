#include "app/trade/convergence.hpp"

#include <algorithm>
#include <cmath>

#include "io/number.hpp"

namespace brunt {

namespace {
constexpr Real kLeastOrder = 0.5, kMostOrder = 2.5, kFormalOrder = 2;
constexpr Real kSafe = 1.25, kUnsafe = 3;
/// Order that three sizes can vouch for: coarse ones show a higher one where shocks or contact have
/// the first, or less, to the end.
constexpr Real kHeldOrder = 1;

Real spread_of(const std::vector<SizedValue>& values) {
  const auto [low, high] = std::minmax_element(
      values.begin(), values.end(), [](const auto& a, const auto& b) { return a.value < b.value; });
  return high->value - low->value;
}

/// What may differ by rounding alone.
Real rounding_of(const std::vector<SizedValue>& values) {
  constexpr Real kRounding = 1e-12;
  Real largest = 0;
  for (const auto& one : values) largest = std::max(largest, std::fabs(one.value));
  return kRounding * largest;
}

/// f_0 and C of f_0 + C h^p, and what remains, by least squares.
struct Fit {
  Real order = 0, limit = 0, slope = 0;
  Real remainder = kInfinity;  ///< root of the mean square
};

Fit fit_of_order(const std::vector<SizedValue>& values, Real order) {
  const auto n = static_cast<Real>(values.size());
  Real x = 0, f = 0, xx = 0, xf = 0;
  // Sizes over the largest, so that powers stay near one.
  const Real largest = values.back().size;
  const auto power = [&](const SizedValue& one) { return std::pow(one.size / largest, order); };
  for (const auto& one : values) x += power(one) / n, f += one.value / n;
  for (const auto& one : values) {
    xx += (power(one) - x) * (power(one) - x), xf += (power(one) - x) * (one.value - f);
  }
  Fit fit{order, 0, xf / xx, 0};
  fit.limit = f - fit.slope * x;
  for (const auto& one : values) {
    const Real rest = one.value - fit.limit - fit.slope * power(one);
    fit.remainder += rest * rest / n;
  }
  fit.remainder = std::sqrt(fit.remainder);
  return fit;
}

Fit best_fit(const std::vector<SizedValue>& values) {
  constexpr Real kFinestOrder = 0.01;
  constexpr int kOrders = 600;
  Fit best;
  for (int k = 1; k <= kOrders; ++k) {
    const Fit fit = fit_of_order(values, k * kFinestOrder);
    if (fit.remainder < best.remainder) best = fit;
  }
  return best;
}

std::string order_text(Real order) { return "order " + rounded(order, 2); }

/// The bound of one order, from the difference of the two finest values.
Real index_of(const SizedValue& finest, const SizedValue& next, Real difference, Real order,
              Real factor) {
  return factor * difference / (std::pow(next.size / finest.size, order) - 1);
}

/// Of two sizes, which give no order.
Convergence of_two(const std::vector<SizedValue>& values) {
  Convergence result;
  const Real difference = std::fabs(values[1].value - values[0].value);
  result.bound = index_of(values[0], values[1], difference, kFormalOrder, kUnsafe);
  result.words = "two sizes give no order";
  return result;
}

/// Of three sizes, or the finest three of more, whose order was found.
Convergence of_three(const std::vector<SizedValue>& values, Real order) {
  const auto& [finest, next, coarsest] = std::tie(values[0], values[1], values[2]);
  Convergence result;
  result.order = order;
  const Real difference = std::fabs(next.value - finest.value);
  const Real ratio = next.size / finest.size;
  if (order >= kLeastOrder && order <= kMostOrder) {
    result.asymptotic = true;
    result.limit = finest.value + (finest.value - next.value) / (std::pow(ratio, order) - 1);
    result.bound = index_of(finest, next, difference, std::min(order, kHeldOrder), kSafe);
    result.words = order_text(order);
    return result;
  }
  if (order > kMostOrder) {
    // The two finest may agree by chance: what the coarser two would leave at second order.
    const Real coarser = std::fabs(coarsest.value - next.value) /
                         (std::pow(coarsest.size / next.size, kFormalOrder) - 1) *
                         (1 - std::pow(ratio, -kFormalOrder));
    result.bound = index_of(finest, next, std::max(difference, coarser), kFormalOrder, kUnsafe);
    result.words = "not asymptotic: " + order_text(order) + " is more than elements have";
    return result;
  }
  result.bound =
      std::max(index_of(finest, next, difference, kLeastOrder, kSafe), kUnsafe * spread_of(values));
  result.words = "not asymptotic: " + order_text(order) + ", hardly converges";
  return result;
}

/// Of more than three: the fit of all, where it follows them.
void take_fit(const std::vector<SizedValue>& values, Convergence& result) {
  constexpr Real kFollows = 0.1;  // of the spread
  const Fit fit = best_fit(values);
  const Real spread = spread_of(values);
  const bool follows =
      fit.remainder <= kFollows * spread && fit.order >= kLeastOrder && fit.order <= kMostOrder;
  if (!follows) {
    result.asymptotic = false;
    result.limit.reset();
    result.bound = std::max(result.bound, fit.remainder);
    if (result.words.starts_with("order")) {
      result.words = "not asymptotic: the coarser sizes do not follow " + result.words;
    }
    return;
  }
  const Real at_finest =
      fit.limit + fit.slope * std::pow(values[0].size / values.back().size, fit.order);
  result.asymptotic = true;
  result.order = fit.order;
  result.limit = fit.limit;
  result.bound = kSafe * std::fabs(values[0].value - fit.limit) + fit.remainder +
                 std::fabs(values[0].value - at_finest);
  result.words = order_text(fit.order);
}

}  // namespace

std::optional<Real> observed_order(const SizedValue& finest, const SizedValue& middle,
                                   const SizedValue& coarsest) {
  const Real fine = middle.value - finest.value, coarse = coarsest.value - middle.value;
  if (!(fine * coarse > 0)) return std::nullopt;
  const Real wanted = coarse / fine;
  const auto ratio = [&](Real p) {
    const Real middle_power = std::pow(middle.size / finest.size, p);
    return (std::pow(coarsest.size / finest.size, p) - middle_power) / (middle_power - 1);
  };
  // The ratio grows with the order, from that of the logarithms at order 0.
  Real low = 1e-6, high = 20;
  if (!(wanted > ratio(low))) return std::nullopt;
  if (!(wanted < ratio(high))) return high;
  for (int k = 0; k < 100; ++k) {
    const Real order = 0.5 * (low + high);
    (ratio(order) < wanted ? low : high) = order;
  }
  return 0.5 * (low + high);
}

Convergence fit_convergence(std::vector<SizedValue> values) {
  std::sort(values.begin(), values.end(),
            [](const auto& a, const auto& b) { return a.size < b.size; });
  const Real spread = spread_of(values);
  if (spread <= rounding_of(values)) {
    Convergence same;
    same.asymptotic = true;
    same.limit = values[0].value;
    same.bound = spread;
    same.words = "does not depend on the size";
    return same;
  }
  if (values.size() == 2) return of_two(values);
  const auto order = observed_order(values[0], values[1], values[2]);
  Convergence result;
  if (order) {
    result = of_three(values, *order);
  } else {
    const Real fine = values[1].value - values[0].value;
    const Real coarse = values[2].value - values[1].value;
    result.bound = kUnsafe * spread;
    result.words = fine * coarse < 0 ? "not asymptotic: it oscillates"
                                     : "not asymptotic: differences do not shrink";
  }
  if (values.size() > 3) take_fit(values, result);
  return result;
}

std::vector<Real> effective_sizes(const std::vector<Real>& nominal,
                                  const std::vector<Real>& cells) {
  const auto [low, high] = std::minmax_element(nominal.begin(), nominal.end());
  const auto fine = slot_of(low - nominal.begin());
  const auto coarse = slot_of(high - nominal.begin());
  if (!(*low > 0) || !(*high > *low) || !(cells[fine] > cells[coarse])) return nominal;
  const Real exponent = std::log(cells[fine] / cells[coarse]) / std::log(*high / *low);
  const Real directions = std::round(exponent);
  constexpr Real kFar = 0.35;  // between two numbers of directions nothing is known
  if (directions < 1 || directions > 3 || std::fabs(exponent - directions) > kFar) return nominal;
  std::vector<Real> sizes;
  for (std::size_t k = 0; k < nominal.size(); ++k) {
    sizes.push_back(nominal[fine] * std::pow(cells[fine] / cells[k], 1 / directions));
  }
  return sizes;
}

}  // namespace brunt
