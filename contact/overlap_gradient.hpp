#pragma once
#include "contact/overlap_push.hpp"

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

/// dU/dA where G and the distances D from borders are known: squared G^2 + linear G and for each
/// pair of borders by_room (D_l + D_u). What the sides of the overlap carry.
template <int Dim>
struct Density {
  Real squared = 0, linear = 0;
  Real energy;                                         ///< [m^(Dim + 1)] U
  std::array<Real, BorderFade<Dim>::kMost> by_room{};  ///< of each pair of the fade

  Density(const BorderFade<Dim>& fade, Real total, const CommonPlane<Dim>& plane) {
    energy = 0.25 * plane.ramp * (1 + plane.facing) * total * plane.penetration;
    squared = 0.5 * plane.ramp;
    linear = energy * fade.by_volume;
    for (int b = 0; b < fade.n; ++b) {
      const auto k = static_cast<std::size_t>(b);
      by_room[k] = energy * fade.pair[k].by_room;
    }
  }
};

/// Sets the pushes of the plane.
/// total  [m^3] integral of the penetration
template <int Dim>
void finish(const FacePlane<Dim>& lower, const FacePlane<Dim>& upper, Real opening, Real total,
            const BorderFade<Dim>& fade, Real share, const OverlapGradient<Dim>& gradient,
            CommonPlane<Dim>& plane);

}  // namespace brunt
