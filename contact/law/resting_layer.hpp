#pragma once
/// What bodies rest on under gravity: a soft, damped layer (docs/theory/contact.md (C46) to (C48)).
#include <algorithm>
#include <map>
#include <vector>

#include "contact/geometry/soft_layer.hpp"
#include "core/surface.hpp"

namespace brunt {

/// The layer between two bodies, over the springs of their contact. A body of elastic elements that
/// gravity finds unloaded swings on its springs for good, and under Coulomb friction its swinging
/// grows (Martins and Simoes 1995): it slides down a slope that should hold it. Springs as stiff as
/// its elements reflect its waves whatever their dampers; one as soft as the whole body takes them
/// up. Contacts know it as far as weights press, and impacts hardly.
struct RestingLayer {
  Real stiffness = 0;  ///< [Pa/m]; 0: there is none
  Real depth = 0;      ///< [m] of penetration that the soft spring is alone

  /// The layer over a spring k [Pa/m] of faces or particles that let go, or are as large as, `size`
  /// [m]. No deeper than a part of that: what is so soft that its weight alone would bring it
  /// farther, or so high, is to sink no deeper than others.
  SoftLayer over(Real k, Real size) const {
    return {stiffness > 0 && stiffness < k ? stiffness / k : 1.0, std::min(depth, kMost * size)};
  }
  bool acts() const { return stiffness > 0; }
  static constexpr Real kMost = 0.02;      ///< of the size of what touches
  static constexpr Real kStiffness = 0.4;  ///< of the spring M/H of the body that rests
  static constexpr Real kDamping = 0.2;    ///< its least fraction of critical, of the whole spring
  /// That of the layer between a pair with its own.
  static Real damping_of(Real zeta) { return std::max(zeta, kDamping); }
};

/// What a body's weight says of the layer that it rests on.
struct RestingBody {
  Real height = 0;       ///< [m] along gravity at time 0
  Real modulus = 0;      ///< [Pa] M of what deforms; 0: nothing does
  Real sound_speed = 0;  ///< [m/s] of it
};

/// Those of all bodies by label; none without gravity. gravity  [m/s^2]
template <int Dim>
std::map<Label, RestingBody> resting_bodies(const std::vector<Surface<Dim>*>& surfaces,
                                            const Section& section, const Vec<Dim>& gravity);

/// The layer between two bodies: the lower one rests on the other, with
///   k_s = 0.4 M/H,  d = weights rho g H / k_s
/// from the modulus and density of what deforms. None between rigid bodies.
/// gravity  [m/s^2];  weights  [1] pressure at which the layer is used up
RestingLayer resting_layer(const RestingBody& a, const RestingBody& b, Real gravity, Real weights);

}  // namespace brunt
