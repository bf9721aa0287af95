#include "fe/rest.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace brunt {
namespace {

/// Nodes of the corners of a tile.
template <int Dim>
std::span<const LocalIndex> nodes_of(const ElementBlock<Dim>& block, int tile) {
  const auto count = slot_of(block.elements_per_tile()) * slot_of(block.corners);
  return {block.corner.data() + slot_of(tile) * count, count};
}

/// True where no node moves. Bits of a velocity of -0 count as motion, which is no harm.
template <int Dim>
bool no_node_moves(std::span<const LocalIndex> nodes, const Vec<Dim>* v) {
  std::uint64_t bits = 0;
  for (const LocalIndex node : nodes) {
    for (int c = 0; c < Dim; ++c) bits |= std::bit_cast<std::uint64_t>(v[node][c]);
  }
  return bits == 0;
}

/// True where volumes about the nodes are those of time 0, if the elements average them: they
/// change with elements of other tiles too.
template <int Dim>
bool keeps_volumes(const ElementBlock<Dim>& block, std::span<const LocalIndex> nodes,
                   const ElementStep<Dim>& step) {
  if (!block.formulation->averages_volumes()) return true;
  return std::all_of(nodes.begin(), nodes.end(),
                     [&](LocalIndex node) { return step.node_ratio[node] == 1; });
}

/// True where no node moves and all stand where they stood at time 0.
template <int Dim>
bool lies_still(const ElementBlock<Dim>& block, int tile, const ElementStep<Dim>& step) {
  const auto nodes = nodes_of(block, tile);
  return no_node_moves<Dim>(nodes, step.v) && keeps_volumes(block, nodes, step) &&
         std::all_of(nodes.begin(), nodes.end(),
                     [&](LocalIndex node) { return step.x[node] == step.x_start[node]; });
}

bool all_zero(const std::vector<Real>& field, std::size_t first, std::size_t count) {
  if (field.empty()) return true;
  const auto begin = field.begin() + static_cast<std::ptrdiff_t>(first);
  return std::all_of(begin, begin + static_cast<std::ptrdiff_t>(count),
                     [](Real value) { return value == 0; });
}

/// True without stress and without forces of hourglass control.
template <int Dim>
bool free_of_stress(const ElementBlock<Dim>& block, int tile) {
  const std::size_t point = slot_of(tile) * kTile;
  const auto n = slot_of(block.elements_per_tile());
  const std::size_t e = slot_of(tile) * n;
  bool none =
      all_zero(block.state.pressure, point, kTile) && all_zero(block.viscous_pressure, e, n);
  for (const auto& component : block.state.deviator)
    none = none && all_zero(component, point, kTile);
  for (std::size_t k = 0; k < block.hourglass.size(); k += slot_of(block.n_padded)) {
    none = none && all_zero(block.hourglass, k + e, n);
  }
  return none;
}

}  // namespace

template <int Dim>
bool rests(const ElementBlock<Dim>& block, int tile, const ElementStep<Dim>& step) {
  if (block.rest[slot_of(tile)] != Rest::unstrained) return false;
  const auto nodes = nodes_of(block, tile);
  return no_node_moves<Dim>(nodes, step.v) && keeps_volumes(block, nodes, step);
}

template <int Dim>
void keep_rest(ElementBlock<Dim>& block, int tile, const ElementStep<Dim>& step) {
  Rest& rest = block.rest[slot_of(tile)];
  if (rest == Rest::moved) return;
  // Where heat flows, temperatures move the stress of what lies still.
  const bool stays =
      !block.conducts && lies_still(block, tile, step) && free_of_stress(block, tile);
  rest = stays ? Rest::unstrained : Rest::moved;
}

template bool rests(const ElementBlock<2>&, int, const ElementStep<2>&);
template bool rests(const ElementBlock<3>&, int, const ElementStep<3>&);
template void keep_rest(ElementBlock<2>&, int, const ElementStep<2>&);
template void keep_rest(ElementBlock<3>&, int, const ElementStep<3>&);

}  // namespace brunt
// Tested by tests/unit/fe/rest_test.cpp.
