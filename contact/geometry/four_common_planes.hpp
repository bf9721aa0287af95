#pragma once
#include <array>

#include "contact/geometry/common_plane.hpp"

namespace brunt {

/// Two quads of which neither is split beside the other, and where their common plane goes.
struct QuadPair {
  const FacePlane<3>*lower, *upper;
  PlaneNeeds needs;  ///< not `whole`, `at_point` or `turned`; with pushes
  CommonPlane<3>* plane;
  bool presses = false;  ///< out: the plane carries pressure
};

/// What common_planes gives of each of four pairs, side by side, with the same bits. Those beyond n
/// repeat the last one, and get nothing.
void four_common_planes(std::array<QuadPair, 4>& pair, int n);

}  // namespace brunt
// Tested by tests/unit/contact/four_common_planes_test.cpp.
