#pragma once
/// How a rank takes its part out of a whole group.
#include <vector>

#include "fe/element_block.hpp"

namespace brunt {

/// Elements of a whole that touch a point of this rank, with their nodes as the whole numbers them.
/// owner  rank of each point of the whole
template <int Dim>
std::vector<ElementSet<Dim>> elements_of(const std::vector<ElementBlock<Dim>>& blocks,
                                         const std::vector<int>& owner, int rank);

/// The facets of the kept elements; the owner of its first corner evaluates a facet.
/// place  of each point of the whole here; -1: it is not
template <int Dim>
std::vector<Facet<Dim>> facets_of(const std::vector<Facet<Dim>>& whole,
                                  const std::vector<ElementSet<Dim>>& sets,
                                  const std::vector<LocalIndex>& place, LocalIndex n_owned);

/// Names the nodes of elements of a whole as they are numbered here.
template <int Dim>
void renumber_corners(const std::vector<LocalIndex>& place, std::vector<ElementSet<Dim>>& sets) {
  for (auto& set : sets) {
    for (auto& corners : set.corners) {
      for (auto& node : corners) node = place[node];
    }
  }
}

}  // namespace brunt
// Tested by tests/parallel/ranks.sh.
