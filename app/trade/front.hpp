#pragma once
#include <optional>
#include <vector>

#include "core/types.hpp"

namespace brunt {

/// A number that was measured several times.
struct Repeated {
  Real median = 0;
  Real low = 0, high = 0;  ///< smallest and largest
  int count = 0;
};
/// values  one or more
Repeated repeated(std::vector<Real> values);

/// What one variant costs and how wrong it is.
struct CostError {
  Repeated cost;
  Real error = 0;  ///< at least 0
};

/// Whether something else is cheaper and no worse, or better and no dearer.
struct Dominance {
  std::optional<std::size_t> by;  ///< the least wrong that dominates; none: on the front
  bool clear = true;              ///< false: their costs lie within each other's spread
};

/// The front of cost and error (Pareto). a dominates b where the median cost of a is smaller and
/// its error no more than a hundredth larger, or its error is smaller at the same cost.
std::vector<Dominance> dominated(const std::vector<CostError>& all);

}  // namespace brunt
