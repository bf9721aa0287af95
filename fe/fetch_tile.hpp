#pragma once
/// Asks for what the next tile reads before its turn comes. It has forty places far apart, more
/// than a processor follows by itself; no value depends on it.
#include "fe/element_block.hpp"

namespace brunt {

/// count values from `first` on of a field; none where it is empty.
template <class T>
BRUNT_INLINE void fetch(const std::vector<T>& field, std::size_t first, std::size_t count) {
  constexpr std::size_t kLine = 64;  // bytes
  if (field.empty()) return;
  const char* at = reinterpret_cast<const char*>(field.data() + first);
  for (std::size_t k = 0; k < count * sizeof(T); k += kLine) __builtin_prefetch(at + k);
}

/// x, v  of the nodes
template <int Dim>
void fetch_tile(const ElementBlock<Dim>& block, int tile, const Vec<Dim>* x, const Vec<Dim>* v) {
  if (tile >= block.n_tiles()) return;
  const auto n = slot_of(block.elements_per_tile());
  const std::size_t point = slot_of(tile) * kTile;
  const std::size_t e = slot_of(tile) * n;
  const auto corners = slot_of(block.corners);
  const LocalIndex* corner = block.corner.data() + e * corners;
  for (std::size_t k = 0; k < n; ++k, corner += corners) {
    // Two that lie across: others are theirs, or near them in memory.
    for (const LocalIndex node : {corner[0], corner[corners - 2]}) {
      __builtin_prefetch(x + node);
      __builtin_prefetch(v + node);
    }
  }
  const MaterialState& state = block.state;
  for (const auto& component : state.deviator) fetch(component, point, kTile);
  for (const auto* field : {&state.pressure, &state.bulk, &state.eps_p, &state.strain_rate,
                            &state.temperature, &state.heat, &state.energy}) {
    fetch(*field, point, kTile);
  }
  if (block.gauss > 1) fetch(block.reference_volume, point, kTile);
  for (const auto* field : {&block.element_volume, &block.mass, &block.reference_size,
                            &block.guard_reach, &block.viscous_pressure, &block.stress_work,
                            &block.hourglass_work, &block.viscous_work, &block.stable_step}) {
    fetch(*field, e, n);
  }
  const auto padded = slot_of(block.n_padded);
  for (std::size_t k = 0; k < block.hourglass.size(); k += padded) {
    fetch(block.hourglass, k + e, n);
  }
}

}  // namespace brunt
// Tested by tests/unit/fe/finite_elements_test.cpp.
