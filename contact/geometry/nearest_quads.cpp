#include "contact/geometry/nearest_quads_kernel.hpp"

namespace brunt {

template void nearest_on_quads<Pack>(const NearQuery<3>*, std::size_t, NearestPoint<3>*);

}  // namespace brunt
// Tested by tests/unit/contact/nearest_quads_test.cpp.
