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

/// What the nodes of a gather get of the mechanical heat of elements: of each corner, in its order,
/// the element, counted over all blocks with their padding, and its share.
struct HeatShares {
  std::vector<LocalIndex> element;
  std::vector<Real> share;

  /// Adds share times heat [values by element] of all corners of each node to it.
  void add(const CornerGather& gather, const Real* heat, std::vector<Real>& out) const;
};
template <int Dim>
HeatShares make_heat_shares(const std::vector<ElementBlock<Dim>>& blocks,
                            const CornerGather& gather);

/// For the first n_nodes nodes: ghosts behind them get no sums.
template <int Dim>
CornerGather make_corner_gather(const std::vector<ElementBlock<Dim>>& blocks, LocalIndex n_nodes);

}  // namespace brunt
