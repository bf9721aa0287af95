#pragma once

namespace brunt {

/// True where kernels that have a version of eight lanes (Wide) are to use it: built for AVX-512,
/// and this processor has it. The environment variable BRUNT_LANES=4 says otherwise. The answer
/// does not depend on it (core/simd.hpp). docs/decisions/213-eight-lanes.md
bool wide_lanes();

}  // namespace brunt
// Tested by tests/unit/fe/wide_lanes_test.cpp.
