#include "fe/hex_conduction_kernel.hpp"

namespace brunt {

template void conduct_hexes<Pack>(const LocalIndex*, const Real*, const ConductionStep<3>&, Real*);

}  // namespace brunt
// Tested by tests/unit/fe/conduction_test.cpp.
