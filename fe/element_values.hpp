#pragma once
/// What an element carries from step to step, listed once: rows of a checkpoint and hashes read it.
#include "core/materials/state_rows.hpp"
#include "fe/element_block.hpp"

namespace brunt {

/// Hands every value that element e carries to f(value, use). Rows of a checkpoint have this order.
template <class Block, class F>
void visit_element(Block& block, std::size_t e, const F& f) {
  for (int g = 0; g < block.gauss; ++g) {
    visit_material_point(block.state, block.point(static_cast<LocalIndex>(e), g), kSaved, f);
  }
  for (std::size_t k = e; k < block.hourglass.size(); k += slot_of(block.n_padded)) {
    f(block.hourglass[k], kState);
  }
  f(block.viscous_pressure[e], kState);
  f(block.stress_work[e], kSaved);
  f(block.hourglass_work[e], kSaved);
  f(block.viscous_work[e], kSaved);
  f(block.stable_step[e], kSaved);
  if (!block.heat_given.empty()) f(block.heat_given[e], kSaved);
  if (!block.volume_ratio.empty()) f(block.volume_ratio[e], kState);
}

}  // namespace brunt
// Tested by tests/unit/fe/state_test.cpp.
