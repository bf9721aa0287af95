#pragma once
#include <span>
#include <vector>

#include "core/parallel/communicator.hpp"

namespace brunt {

/// Which rank owns each point of the scene, by point id.
struct Partition {
  std::vector<std::int32_t> owner;
  int of(GlobalId point) const { return owner[point]; }
};

/// Partitions points by recursive coordinate bisection (Zoltan), so that every rank gets about the
/// same weight and points that are near each other stay together. Every rank passes all points, by
/// id, and gets the same partition. Ranks may come out empty. Points without weight, as those of a
/// large rigid wall, shape no part: they go to the rank in whose region they lie. x  [m], weight
/// [any unit, not negative] parts  for how many ranks, where that is not how many there are: a tool
/// asks what a larger run
///        would be; 0: for those that are there
template <int Dim>
Partition make_partition(const Communicator& ranks, std::span<const Vec<Dim>> x,
                         std::span<const Real> weight, int parts = 0);

}  // namespace brunt
