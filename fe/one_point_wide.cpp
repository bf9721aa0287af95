/// Compiled for AVX-512 at the width of AVX2 (fe/CMakeLists.txt). All that it calls is inlined: a
/// function that other sources share must not be taken from here.
#include "fe/one_point_wide.hpp"

#ifdef __AVX512VL__
#include "fe/one_point_kernel.hpp"
#endif

namespace brunt {

#ifdef __AVX512VL__
const bool kHasWideKernel = true;

template <int Dim>
void advance_one_point_wide(ElementBlock<Dim>& block, int index, const ElementStep<Dim>& step) {
  one_point::advance(block, index, step);
}
#else
const bool kHasWideKernel = false;

template <int Dim>
void advance_one_point_wide(ElementBlock<Dim>& block, int index, const ElementStep<Dim>& step) {
  advance_one_point_narrow(block, index, step);
}
#endif

template void advance_one_point_wide(ElementBlock<2>&, int, const ElementStep<2>&);
template void advance_one_point_wide(ElementBlock<3>&, int, const ElementStep<3>&);

}  // namespace brunt
// Tested by tests/unit/fe/one_point_wide_test.cpp.
