#pragma once
namespace brunt {

/// Gathers the pages of the heap into large ones, where the system can (Linux from 6.1 on): of a
/// scene that is built, before its steps. Blocks from 128 kB on stand in large pages as it is.
void gather_heap();

/// Whether large blocks that are given back wait for the next that asks for as much, within what
/// was in use at once before: from when a scene is built until its first step, which needs much for
/// a short time.
void keep_freed_blocks(bool keeps);

}  // namespace brunt
// Tested by tests/unit/core/large_blocks_test.cpp.
