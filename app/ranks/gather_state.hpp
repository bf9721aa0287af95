#pragma once
#include <vector>

#include "core/parallel/communicator.hpp"
#include "core/state.hpp"

namespace brunt {

/// The tables of all ranks on every rank: a partition may send any row anywhere. Collective.
std::vector<StateTable> of_all_ranks(const std::vector<StateTable>& mine,
                                     const Communicator& ranks);

}  // namespace brunt
