#pragma once
#include "core/types.hpp"

namespace brunt {

/// Nodes node .. node + n - 1, which are points point .. point + n - 1 of a surface.
struct NodeRun {
  LocalIndex node = 0, surface = 0, point = 0, n = 0;
};

}  // namespace brunt
// Tested by tests/unit/contact/moved_nodes_test.cpp.
