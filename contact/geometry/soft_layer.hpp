#pragma once
#include <algorithm>

#include "contact/geometry/common_plane.hpp"

namespace brunt {

/// A soft layer over the spring of two faces: their pressure is
///   k [s g + (1 - s) <g - d>] + barrier,
/// s k in the layer, k once it is used up.
struct SoftLayer {
  Real softness = 1;  ///< s
  Real depth = 0;     ///< [m] d
  bool acts() const { return softness < 1 || depth > 0; }
  /// Pressure by k [m] that its damper may have at a penetration g: as much as the spring of the
  /// layer, and less again where it is used up, nothing from 2 d on. What passes through loses at
  /// most s k d^2 by area, both ways.
  Real most_damped(Real g) const { return softness * std::max(std::min(g, 2 * depth - g), 0.0); }
};

/// The planes between two faces with the layer over their spring: the potential of the overlap from
/// the faces on, with s k, and that from d on, with (1 - s) k (docs/theory/contact.md (C46)). Sets
/// damped_volume and firm_area of the planes too. needs  pushes
template <int Dim>
int layered_planes(const FacePlane<Dim>& lower, const FacePlane<Dim>& upper, const Section& section,
                   const SoftLayer& layer, std::array<CommonPlane<Dim>, 4>& plane,
                   PlaneNeeds needs);

}  // namespace brunt
