#pragma once
#include <cstdint>
#include <vector>

#include "core/types.hpp"

namespace brunt {

/// Key of each point along Morton's curve through their bounding box: points with near keys lie
/// near each other. Depends on positions only up to a common scale and shift.
/// x  positions [m]
template <int Dim>
std::vector<std::uint64_t> curve_keys(const std::vector<Vec<Dim>>& x);

/// Places of the keys, fewer than 2^32, in ascending order, equal ones as they stand.
std::vector<std::uint32_t> order_of(std::vector<std::uint64_t> keys);

}  // namespace brunt
