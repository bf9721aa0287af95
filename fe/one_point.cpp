/// One-point elements, by the kernel that the processor runs best.
#include "fe/one_point_kernel.hpp"
#include "fe/one_point_wide.hpp"

namespace brunt {

bool has_wide_registers() {
#if defined(__x86_64__) && defined(__GNUC__)
  return kHasWideKernel && __builtin_cpu_supports("avx512f") &&
         __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw") &&
         __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512cd");
#else
  return false;
#endif
}

template <int Dim>
void advance_one_point_narrow(ElementBlock<Dim>& block, int index, const ElementStep<Dim>& step) {
  one_point::advance(block, index, step);
}

template <int Dim>
void advance_one_point(ElementBlock<Dim>& block, int index, const ElementStep<Dim>& step) {
  static const bool wide = has_wide_registers();
  if (wide) {
    advance_one_point_wide(block, index, step);
  } else {
    advance_one_point_narrow(block, index, step);
  }
}

template void advance_one_point_narrow(ElementBlock<2>&, int, const ElementStep<2>&);
template void advance_one_point_narrow(ElementBlock<3>&, int, const ElementStep<3>&);
template void advance_one_point(ElementBlock<2>&, int, const ElementStep<2>&);
template void advance_one_point(ElementBlock<3>&, int, const ElementStep<3>&);

}  // namespace brunt
// Tested by tests/unit/fe/one_point_wide_test.cpp.
