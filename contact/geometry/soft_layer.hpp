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
  /// Part of a damper that is the layer's at a penetration g, against that of the spring below: all
  /// of it to d, nothing from 2 d on.
  Real damped(Real g) const { return depth > 0 ? std::clamp(2 - g / depth, 0.0, 1.0) : 0.0; }
  /// Pressure by k [m] that it may have: that of the spring of the layer, and less where it is used
  /// up. What passes through loses at most s k d^2 by area each way.
  Real most_damped(Real g) const { return softness * std::max(std::min(g, 2 * depth - g), 0.0); }
};

/// The planes between two faces with the layer over their spring: the potential of the overlap from
/// the faces on, with s k, and that from d on, with (1 - s) k (docs/theory/contact.md (C46)). Sets
/// the mean penetration of the planes too. needs  pushes
template <int Dim>
int layered_planes(const FacePlane<Dim>& lower, const FacePlane<Dim>& upper, const Section& section,
                   const SoftLayer& layer, Planes<Dim>& plane, PlaneNeeds needs);

}  // namespace brunt
