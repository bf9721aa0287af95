#include "io/vtk/colour_map.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace brunt {

namespace {

/// From pale to dark by even steps of lightness: what is at rest stays pale, and mesh lines are
/// seen.
constexpr std::array<Colour, 9> kSequential = {{{240, 240, 236},
                                                {250, 228, 184},
                                                {253, 204, 124},
                                                {250, 170, 84},
                                                {240, 130, 68},
                                                {220, 88, 70},
                                                {186, 50, 82},
                                                {138, 26, 86},
                                                {82, 12, 74}}};
/// Even steps of the blue-white-red map of Moreland 2009.
constexpr std::array<Colour, 9> kDiverging = {{{59, 76, 192},
                                               {98, 130, 234},
                                               {141, 176, 254},
                                               {184, 208, 249},
                                               {221, 221, 221},
                                               {245, 196, 173},
                                               {244, 154, 123},
                                               {222, 96, 77},
                                               {180, 4, 38}}};

}  // namespace

std::array<Colour, 256> colour_map(bool diverging) {
  const std::span<const Colour> stops = diverging ? std::span(kDiverging) : std::span(kSequential);
  std::array<Colour, 256> map{};
  for (std::size_t i = 0; i < map.size(); ++i) {
    const Real place =
        static_cast<Real>(i * (stops.size() - 1)) / static_cast<Real>(map.size() - 1);
    const auto low = std::min(static_cast<std::size_t>(place), stops.size() - 2);
    const Real part = place - static_cast<Real>(low);
    for (std::size_t c = 0; c < 3; ++c) {
      const Real value = (1 - part) * stops[low][c] + part * stops[low + 1][c];
      map[i][c] = static_cast<std::uint8_t>(std::lround(value));
    }
  }
  return map;
}

bool is_diverging(const Interval& range) {
  return std::min(-range.low, range.high) > 0.1 * std::max(-range.low, range.high);
}

Interval colour_range(const Interval& range, bool from_zero) {
  if (range.empty()) return {0, 1};
  Interval result = range;
  if (is_diverging(range)) {
    result.high = std::max(-range.low, range.high);
    result.low = -result.high;
  } else if (from_zero) {
    if (range.low > 0 && range.low < 0.3 * range.high) result.low = 0;
    if (range.high < 0 && range.high > 0.3 * range.low) result.high = 0;
  }
  const Real least = 1e-12 * std::max({std::fabs(result.low), std::fabs(result.high), 1e-300});
  if (result.high - result.low <= least) {
    const Real half = result.high == 0 ? 0.5 : 0.5 * std::fabs(result.high);
    result.low -= half;
    result.high += half;
  }
  return result;
}

}  // namespace brunt
// Tested by tests/unit/io/render_test.cpp.
