#pragma once
/// What finding a plane between two faces has in common in space and in the plane.
#include <algorithm>

#include "contact/geometry/common_plane.hpp"

namespace brunt {

inline constexpr Real kTouching = 1e-12;  // of the face's size: a mean penetration below it is none
inline constexpr Real kSliver = 1e-12;    // of the smaller face's area: an overlap below it is none

/// What is known by the cosine of both faces alone, but for the ramp.
template <int Dim>
void begin(Real facing, const PlaneNeeds& needs, CommonPlane<Dim>& plane) {
  plane.facing = facing;
  plane.share = 0;
  plane.layered = 0;
  plane.fade = 1;
  plane.barrier = needs.barrier.at(facing);
}

/// The normal, origin and ramp; false if the faces do not oppose each other.
template <int Dim>
bool orient(const FacePlane<Dim>& lower, const FacePlane<Dim>& upper, const PlaneNeeds& needs,
            CommonPlane<Dim>& plane) {
  const Real facing = -lower.normal.dot(upper.normal);
  const FacingRamp<Dim> ramp(lower, upper);
  if (!(facing > (needs.turned ? kMayTurn : ramp.none))) return false;
  begin(facing, needs, plane);
  plane.ramp = needs.turned ? 1.0 : ramp.at(facing);
  plane.ramp_growth = needs.turned ? 0.0 : ramp.growth(facing);
  plane.normal = (lower.normal - upper.normal).normalized();
  plane.origin = 0.5 * (lower.center + upper.center);
  return true;
}

/// True if every corner of the upper face, warped by no more than it is, lies above the lower.
template <int Dim>
bool apart(const FacePlane<Dim>& lower, const FacePlane<Dim>& upper, const Vec<Dim>& n,
           const Vec<Dim>& origin, Real opening) {
  Real top = -kInfinity, bottom = kInfinity;
  for (int i = 0; i < lower.n_corners; ++i) {
    top = std::max(top, n.dot(lower.corner[slot_of(i)] - origin));
  }
  for (int i = 0; i < upper.n_corners; ++i) {
    bottom = std::min(bottom, n.dot(upper.corner[slot_of(i)] - origin));
  }
  // The planes lean against n by 45 degrees at most: their corners are nearer than 1.42 warps.
  return bottom - top >= 1.42 * (lower.warp + upper.warp) + opening;
}

/// Lets the spring fade as omega, and its barrier as omega^3: what came in over borders is as deep
/// as the bodies are long there, where a barrier would push a hundred times as hard as the sides
/// that meet.
template <int Dim>
void set_fade(Real omega, CommonPlane<Dim>& plane) {
  plane.fade = omega;
  plane.ramp *= omega;
  plane.barrier.strength *= omega * omega;
}

/// Sets volume and energy of a plane; returns the share that its barrier has of the push.
/// total  [m^3] integral of the penetration;  mean  [m] where the linear pressure acts
/// deep   DeepArea or DeepLine;  whole  one pressure everywhere, of the mean penetration
template <int Dim, class Deep>
Real set_spring(Real total, Real mean, const Deep& deep, bool whole, CommonPlane<Dim>& plane) {
  const auto& barrier = plane.barrier;
  const Real linear = 0.25 * (1 + plane.facing) * total * mean;
  Real beside = 0, energy = 0;
  plane.mean_slope = 1;
  if (whole) {
    plane.mean_slope = barrier.tangent(mean);
    beside = plane.area * barrier.pressure(mean);
    energy = plane.area * barrier.energy(mean);
  } else if (deep.squared > 0) {
    plane.mean_slope = 1 + 2 * barrier.steepness() * deep.linear / plane.area;
    beside = plane.half_cosine() * barrier.steepness() * deep.squared;
    energy = barrier.steepness() / 3 * deep.cubed;
  }
  plane.volume = plane.ramp * (total + beside);
  plane.energy = plane.ramp * (linear + energy);
  plane.energy_by_fade = plane.ramp * (linear + 3 * energy);
  plane.energy_by_facing = plane.ramp_growth * plane.energy + barrier.growth * plane.ramp * energy;
  return whole ? 0.0 : beside / (total + beside);
}

}  // namespace brunt
// Tested by tests/unit/contact/common_plane_test.cpp.
