/// What finite elements carry from step to step, as tables: points by their ids, elements by
/// theirs.
#include "core/points_state.hpp"
#include "fe/element_values.hpp"
#include "fe/erosion.hpp"
#include "fe/finite_elements.hpp"

namespace brunt {
namespace {

/// A name for all blocks whose elements have rows of the same columns, and as many of them: control
/// of hourglasses and laws of materials keep what their names do not tell.
template <int Dim>
std::string table_of(const ElementBlock<Dim>& block) {
  StateCounter values;
  if (block.n > 0) visit_element(block, 0, saved_in(values));
  return "elements." + std::to_string(block.gauss) + fields_of(block.state) +
         (block.heat_given.empty() ? "" : ".given") + (block.volume_ratio.empty() ? "" : ".ratio") +
         "." + std::to_string(values.count);
}

}  // namespace

template <int Dim>
void FiniteElements<Dim>::save_state(std::vector<StateTable>& tables) const {
  save_points(points_, tables);
  for (const auto& block : blocks_) {
    std::vector<std::size_t> owned;
    for (std::size_t e = 0; e < slot_of(block.n); ++e) {
      if (block.owned[e]) owned.push_back(e);
    }
    save_rows(
        table_of(block), owned.size(), [&](std::size_t k) { return block.id[owned[k]]; },
        [&](auto& row, std::size_t k) { visit_element(block, owned[k], saved_in(row)); }, tables);
  }
  if (!erosion_) return;
  save_eroded(tables);
  save_volumes(tables);
}

/// The padding repeats the last element, so it takes that one's row.
template <int Dim>
void FiniteElements<Dim>::load_state(const StateTables& tables) {
  stepped_ = true;
  load_points(points_, tables);
  if (erosion_) {
    load_eroded(tables);
    load_volumes(tables);
  }
  for (auto& block : blocks_) {
    block.wake();
    load_rows(
        table_of(block), slot_of(block.n_padded), [&](std::size_t e) { return block.id[e]; },
        [&](auto& row, std::size_t e) { visit_element(block, e, saved_in(row)); }, tables);
  }
}

template void FiniteElements<2>::save_state(std::vector<StateTable>&) const;
template void FiniteElements<3>::save_state(std::vector<StateTable>&) const;
template void FiniteElements<2>::load_state(const StateTables&);
template void FiniteElements<3>::load_state(const StateTables&);

}  // namespace brunt
// Tested by tests/unit/fe/state_test.cpp.
