#pragma once
/// Asks for what elements read before their turn comes. It has forty places far apart, more than a
/// processor follows by itself; no value depends on it.
#include "fe/element_step.hpp"

namespace brunt {

/// Into the second cache: what a tile hands from its kinematics to its forces fills the first.
BRUNT_INLINE void fetch(const void* at) {
  constexpr int kRead = 0, kSecondCache = 1;
  __builtin_prefetch(at, kRead, kSecondCache);
}
/// kGroup values of a field, which begin a cache line; none where it is empty.
BRUNT_INLINE void fetch(const std::vector<Real>& field, std::size_t first) {
  if (!field.empty()) fetch(field.data() + first);
}

/// What kinematics read of the kGroup material points from p on.
template <int Dim>
BRUNT_INLINE void fetch_stress(const ElementBlock<Dim>& block, std::size_t p) {
  const MaterialState& state = block.state;
  for (const auto& component : state.deviator) fetch(component, p);
  fetch(state.pressure, p), fetch(state.bulk, p);
  if (block.gauss > 1 || block.conducts) fetch(block.reference_volume, p);
}

/// What their material reads beside it.
template <int Dim>
BRUNT_INLINE void fetch_material(const ElementBlock<Dim>& block, std::size_t p) {
  const MaterialState& state = block.state;
  for (const auto* field : {&state.eps_p, &state.strain_rate, &state.temperature, &state.heat,
                            &state.energy, &state.compression_heat}) {
    fetch(*field, p);
  }
  if (block.conducts) fetch(state.expansion_work, p);
}

/// What the kGroup elements from e on read and write besides their material points.
template <int Dim>
BRUNT_INLINE void fetch_elements(const ElementBlock<Dim>& block, std::size_t e,
                                 const ElementStep<Dim>& step) {
  const auto padded = slot_of(block.n_padded);
  const auto corners = slot_of(block.corners);
  const LocalIndex* corner = block.corner.data() + e * corners;
  for (int k = 0; k < kGroup; ++k, corner += corners) {
    // Two that lie across: others are theirs, or near them in memory.
    for (const LocalIndex node : {corner[0], corner[corners - 2]}) {
      fetch(step.x + node);
      fetch(step.v + node);
    }
  }
  for (const auto* field : {&block.element_volume, &block.mass, &block.reference_size,
                            &block.guard_reach, &block.viscous_pressure, &block.stress_work,
                            &block.hourglass_work, &block.viscous_work, &block.stable_step}) {
    fetch(*field, e);
  }
  for (std::size_t k = 0; k < block.hourglass.size(); k += padded) fetch(block.hourglass, k + e);
  if (block.heat_given.empty()) return;
  fetch(block.heat_given, e);
  for (std::size_t I = 0; I < corners; ++I) fetch(block.heat_share, block.heat_share_at(e, I));
}

/// True where a group begins at element e, and one of the next tile stands as it does: what that
/// one needs is asked for then. A tile's requests are spread over the work of the one before; all
/// at once they waited for each other.
template <int Dim>
BRUNT_INLINE bool looks_ahead(const ElementBlock<Dim>& block, std::size_t e) {
  return e % kGroup == 0 && e + slot_of(block.elements_per_tile()) < slot_of(block.n_padded);
}

/// Asks so for elements of one material point.
template <int Dim>
BRUNT_INLINE void fetch_ahead(const ElementBlock<Dim>& block, std::size_t e,
                              const ElementStep<Dim>& step) {
  if (!looks_ahead(block, e)) return;
  fetch_elements(block, e + kTile, step);
  fetch_stress(block, e + kTile);
  fetch_material(block, e + kTile);
}

}  // namespace brunt
// Tested by tests/unit/fe/finite_elements_test.cpp.
