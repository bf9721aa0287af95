#pragma once
/// The kernel of one-point elements twice: one for the instruction set of the program, and one for
/// processors with 32 vector registers instead of 16, where a quarter of what the first writes to
/// the stack and reads again stays in them. Both are the same operations on four elements side by
/// side, and so the same bits.
#include "fe/element_step.hpp"

namespace brunt {

/// False where the program was built for no processor that has a wider brother.
extern const bool kHasWideKernel;
/// True where there is such a kernel and this processor runs it.
bool has_wide_registers();

template <int Dim>
void advance_one_point_narrow(ElementBlock<Dim>& block, int index, const ElementStep<Dim>& step);
/// Only where has_wide_registers().
template <int Dim>
void advance_one_point_wide(ElementBlock<Dim>& block, int index, const ElementStep<Dim>& step);

}  // namespace brunt
