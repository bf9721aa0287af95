#pragma once

namespace brunt {

/// True where kernels of eight lanes (Wide) may be called: this processor has what they are built
/// for.
bool can_run_wide();

/// True where kernels that have a version of eight lanes use it: it is built for AVX-512, and this
/// processor has that. The environment variable BRUNT_LANES=4 says otherwise. The answer does not
/// depend on it (core/simd.hpp). docs/decisions/213-eight-lanes.md
bool wide_lanes();

}  // namespace brunt
// Tested by tests/unit/fe/wide_lanes_test.cpp.
