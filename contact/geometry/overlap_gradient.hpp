#pragma once
#include "contact/geometry/overlap_push.hpp"

namespace brunt {

/// Gradient of the potential of an overlap, by k: what its two files fill and finish() makes pushes
/// of. Places of corners are those in the plane, whose normal is held.
template <int Dim>
struct OverlapGradient {
  static constexpr int kCorners = CommonPlane<Dim>::kCorners;
  std::array<Vec<Dim>, kCorners> lower, upper;  ///< [m^3] by the place of each corner
  Real push = 0;                                ///< [m^3] by G: int dU/dG dA
  Vec<Dim> push_moment = Vec<Dim>::Zero();      ///< [m^4] the same times p - plane.origin
  Vec<Dim> by_normal = Vec<Dim>::Zero();        ///< [m^4] where the breadth depends on it
  Real by_place = 0;                            ///< [m^3] the same by moving along the normal
  OverlapGradient() {
    lower.fill(Vec<Dim>::Zero());
    upper.fill(Vec<Dim>::Zero());
  }
};

/// dU/dA where G and the distances D from borders are known: squared G^2 + linear G + uniform, for
/// each pair of borders by_room (D_l + D_u), and cubed u^3 of the barrier, u = G - g0 where it
/// pushes. What the sides of the overlap carry.
template <int Dim>
struct Density {
  Real squared = 0, linear = 0;
  Real uniform = 0;                                  ///< [m]
  Real cubed = 0;                                    ///< [1/m]
  std::array<Real, BorderFade<Dim>::kMost> by_room;  ///< of each pair of the fade

  Density(const BorderFade<Dim>& fade, const CommonPlane<Dim>& plane) {
    squared = 0.5 * plane.ramp;
    linear = plane.energy_by_fade * fade.by_volume;
    uniform = plane.energy_by_fade * fade.by_area;
    if (plane.barrier.onset > 0) cubed = plane.ramp * plane.barrier.steepness() / 3;
    for (int b = 0; b < fade.n; ++b) {
      const auto k = slot_of(b);
      by_room[k] = plane.energy_by_fade * fade.pair[k].by_room;
    }
  }
};

/// Sets the pushes of the plane. gradient  is used up: a copy would wait for what has just been
/// written
template <int Dim>
void finish(const FacePlane<Dim>& lower, const FacePlane<Dim>& upper, Real opening, Real share,
            OverlapGradient<Dim>& gradient, CommonPlane<Dim>& plane);

}  // namespace brunt
// Tested by tests/unit/contact/overlap_push_test.cpp.
