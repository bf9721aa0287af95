#include "fe/gauss_kernel.hpp"

namespace brunt {

template void advance_gauss<2, Wide>(ElementBlock<2>&, int, const ElementStep<2>&);
template void advance_gauss<3, Wide>(ElementBlock<3>&, int, const ElementStep<3>&);

}  // namespace brunt
// Tested by tests/unit/fe/wide_lanes_test.cpp.
