#pragma once
#include <cmath>

#include "contact/surfaces/entities.hpp"

namespace brunt {

/// False for a face whose corners leave their mean plane by more than kWarpLimit times the root of
/// its area at time 0: it is split, as one is that does so by the area now. Faces that grow keep
/// their depth and their spring, and a corner that dips in by a part of what they have grown to
/// would be far in the barrier once they split.
template <int Dim>
bool is_flat_as_of_start(const ContactFace<Dim>& face, const FacePlane<Dim>& plane) {
  return !(face.area_start > 0) || plane.warp <= kWarpLimit * std::sqrt(face.area_start);
}

}  // namespace brunt
// Tested by tests/unit/contact/start_warp_test.cpp.
