#pragma once
#include "core/parallel/partition.hpp"

namespace brunt {

/// The ranks of a run as contact needs them: how to reach them, and whose each point is.
struct ContactRanks {
  const Communicator* all = &lone_rank();
  const Partition* partition = nullptr;  ///< none: one rank owns everything
  bool alone() const { return all->alone(); }
  int owner_of(GlobalId point) const { return partition == nullptr ? 0 : partition->of(point); }
  bool owns(GlobalId point) const { return alone() || owner_of(point) == all->rank(); }
};

}  // namespace brunt
