#pragma once
#include "contact/geometry/particle_face.hpp"

namespace brunt {

/// Nearest points of `n` quads: the four triangles of one about its centre are lanes, of one quad
/// at a time (Pack) or of two (Wide, to be called where wide_lanes() says so).
/// nearest  out, all of it
template <class V>
void nearest_on_quads(const NearQuery<3>* of, std::size_t n, NearestPoint<3>* nearest);

}  // namespace brunt
