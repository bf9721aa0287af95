#pragma once
#include "contact/contacts/heat.hpp"
#include "contact/geometry/particle_face.hpp"

namespace brunt {

/// b of the barrier between two particles over the stiffer one's own spring. Alone with each
/// other, two of a kind that meet at five times the speed of sound turn back before their centres
/// meet: 25/4 m c^2 = 25/4 M dp^3 <= b R^2/4, R = dp/2, b = 200 phi M dp, phi = 1/2.
inline constexpr Real kPairBarrier = 200;

/// How two particles stand to each other.
template <int Dim>
struct ParticleMeeting {
  Vec<Dim> normal;    ///< unit, from the first to the second
  Real distance = 0;  ///< [m] of their centres
  Real overlap = 0;   ///< [m] sum of their radii less distance
  Real closing = 0;   ///< [m/s]

  /// x, v  [m], [m/s] of the second relative to the first; reach  [m] sum of the radii. Centres
  /// in one place have no normal of their own: it is that of the first axis.
  ParticleMeeting(const Vec<Dim>& x, const Vec<Dim>& v, Real reach) : distance(x.norm()) {
    normal = distance > 0 ? Vec<Dim>(x / distance) : Vec<Dim>(Vec<Dim>::Unit(0));
    overlap = reach - distance;
    closing = -v.dot(normal);
  }
};

/// One of two particles that may touch, and the other: each owned one has a row of all others.
struct PairCandidate {
  LocalIndex particle = 0, other = 0;
  LocalIndex mirror = -1;  ///< the same pair in the row of the other; -1: another rank has it
  Real stiffness = 0;      ///< [N/m] per breadth
  Real barrier = 0;        ///< [N/m] per breadth
  Real zeta = 0;
  PairLaws laws{};
};

/// What stands behind one side of a contact of two particles for heat.
struct PairSide {
  Real area = 0;      ///< [m^2] of its section, shared by its contacts with the same body
  Real capacity = 0;  ///< [J/K] or [kg], as of HeatSide, shared by all of its contacts
};

/// The way of heat between two particles, complete once both sides are known.
template <int Dim>
struct PairHeatPath {
  HeatFlow<Dim> flow;
  Real per_area = 0;          ///< [W/m^2/K] of the contact and half a spacing in each; 0: friction
  std::size_t candidate = 0;  ///< whose sides these are
  void complete(const PairSide& lower, const PairSide& upper) {
    flow.area = std::min(lower.area, upper.area);
    flow.h_area = flow.area * per_area;
    flow.lower.capacity = lower.capacity, flow.upper.capacity = upper.capacity;
  }
};

}  // namespace brunt
