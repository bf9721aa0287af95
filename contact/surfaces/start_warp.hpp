#pragma once
#include <cmath>

#include "contact/surfaces/entities.hpp"

namespace brunt {

/// A face whose corners leave their mean plane by more than kWarpLimit times the root of its area
/// at time 0 is not simple, by more than kFlatLimit not flat, as one is that does so by the area
/// now. Faces that grow keep their depth and their spring, and a corner that dips in by a part of
/// what they have grown to would be far in the barrier once they split.
template <int Dim>
void compare_with_start(const ContactFace<Dim>& face, FacePlane<Dim>& plane) {
  if (!(face.area_start > 0)) return;
  const Real width = std::sqrt(face.area_start);
  plane.simple = plane.simple && plane.warp <= kWarpLimit * width;
  plane.flat = plane.flat && plane.warp <= kFlatLimit * width;
}

}  // namespace brunt
// Tested by tests/unit/contact/start_warp_test.cpp.
