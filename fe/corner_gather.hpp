#pragma once
#include <vector>

#include "fe/element_block.hpp"

namespace brunt {

/// For each node the places of its element corners in the buffer of corner values, by ascending
/// element id and corner: the order of every nodal sum, whatever the storage.
struct CornerGather {
  std::vector<std::int64_t> offset;  ///< n_nodes + 1
  std::vector<LocalIndex> place;     ///< corner index: block's first_corner + element * corners + I

  /// sum [values by corner] of width W onto each node: out[node] += sum value[place].
  template <int W>
  void add(const Real* value, std::vector<Vec<W>>& out) const;
};

/// For the first n_nodes nodes: ghosts behind them get no sums.
template <int Dim>
CornerGather make_corner_gather(const std::vector<ElementBlock<Dim>>& blocks, LocalIndex n_nodes);

}  // namespace brunt
