#pragma once
/// Rows of a tile that are kept over a step.
#include <algorithm>

#include "core/materials/material.hpp"
#include "core/simd.hpp"

namespace brunt {

/// A value of each point of a tile.
struct alignas(32) Row {
  Real at[kTile];
};
inline Row copied(const Real* from, int count) {
  Row row;
  std::copy_n(from, count, row.at);
  return row;
}

/// V/V0 of a tile before and after a step, while it shows others.
struct RatioRows {
  Row old, now;
  explicit RatioRows(const MaterialTile& tile)
      : old(copied(tile.ratio_old, tile.count)), now(copied(tile.ratio, tile.count)) {}
  void show(MaterialTile& tile) const {
    std::copy_n(old.at, tile.count, tile.ratio_old);
    std::copy_n(now.at, tile.count, tile.ratio);
  }
};

/// Deviators of a tile, [component][point].
struct alignas(32) DeviatorRows {
  Real at[6][kTile];
};
inline DeviatorRows copied_deviator(const MaterialTile& tile) {
  DeviatorRows rows;
  for (std::size_t c = 0; c < 6; ++c) {
    std::copy_n(tile.state->deviator[c].data() + tile.first, tile.count, rows.at[c]);
  }
  return rows;
}

/// Work [J/m^3 reference] of the deviator in this step at points i .. i + kLanes - 1,
/// 1/2 (J s before + J s after) : strain, J = V/V0.
BRUNT_INLINE Pack deviatoric_work(const MaterialTile& tile, const DeviatorRows& before, int i) {
  const Pack half_old = 0.5 * load(tile.ratio_old + i), half = 0.5 * load(tile.ratio + i);
  Pack sum{};
  for (std::size_t c = 0; c < 6; ++c) {
    const Real* after = tile.state->deviator[c].data() + tile.first + i;
    const Pack mean = half_old * load(before.at[c] + i) + half * load(after);
    sum = sum + (c < 3 ? 1.0 : 2.0) * (mean * load(tile.strain[c] + i));
  }
  return sum;
}

}  // namespace brunt
// Tested by tests/unit/core/material_test.cpp.
