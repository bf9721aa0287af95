#pragma once
namespace brunt {

/// Gathers the pages of the heap into large ones, where the system can (Linux from 6.1 on): of a
/// scene that is built, before its steps. Blocks from 4 MB on stand in large pages as it is.
void gather_heap();

}  // namespace brunt
// Tested by tests/unit/core/large_blocks_test.cpp.
