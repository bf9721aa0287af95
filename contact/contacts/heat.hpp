#pragma once
#include "contact/contacts/friction.hpp"
#include "contact/geometry/common_plane.hpp"
#include "contact/geometry/particle_face.hpp"

namespace brunt {

/// What stands behind one side of a contact for heat.
struct HeatSide {
  Real capacity = 0;                ///< [J/K]; [kg] where its specific heat varies
  LocalIndex surface = 0;           ///< whose points
  std::int32_t specific_heat = -1;  ///< among those of the points, where it varies
};

/// Heat that one contact gives to its nodes: what passes through it, or what friction makes.
template <int Dim>
struct HeatFlow {
  static constexpr int kNodes = 2 * Facet<Dim>::kNodes;
  static constexpr std::uint32_t kFriction = 32;  ///< ordinals of friction begin here
  ContactKey key;
  Label lower_body = 0, upper_body = 0;
  Real area = 0;          ///< [m^2] through which heat passes
  Real h_area = 0;        ///< [W/K]; infinite: perfect; 0: friction alone
  HeatSide lower, upper;  ///< behind the contact
  Real through = 0;       ///< [W] into the upper body, out of the lower one
  int n_nodes = 0;
  std::array<LocalIndex, kNodes> node{};
  std::array<Real, kNodes> weight{};  ///< of the temperature there; of the lower side negative
  std::array<Real, kNodes> rate{};    ///< [W] into each node
};

/// Heat that a contact elsewhere gives to one node of this rank.
struct HeatShare {
  ContactKey key;
  LocalIndex node;
  Real rate;  ///< [W]
};

/// Heat rate [W] from the lower to the upper side that are so much [K] apart before it flows: h A
/// times what they are apart after it, by backward Euler: dT / (1/(h A) + dt/C), C = C1 C2/(C1 +
/// C2). Stable for any step, exact where temperatures are steady, and of one temperature where h is
/// infinite.
/// docs/theory/heat.md (H11), (H12).
/// h_area  [W/K]
/// lower, upper  heat capacities behind the sides [J/K]
Real heat_between(Real h_area, Real lower, Real upper, Real difference, Real dt);

/// The way of heat between two faces, by the weights of the middle of `plane`, of which an area
/// `pressed` [m^2] is under `pressure` [Pa] and the rest under none. docs/theory/heat.md (H13).
template <int Dim>
HeatFlow<Dim> heat_path(const ContactFace<Dim>& lower, const ContactFace<Dim>& upper,
                        const CommonPlane<Dim>& plane, const ContactHeat& heat, Real pressed,
                        Real pressure);

/// A particle that heat reaches from a face.
template <int Dim>
struct ParticleTouch {
  const ContactParticle& particle;
  const ContactFace<Dim>& face;
  const ParticleHit<Dim>& hit;
  Real area = 0;      ///< [m^2] of it
  Real pressure = 0;  ///< [Pa]
  int contacts = 1;   ///< of the particle, which share its capacity
};

/// The way of heat between a particle and a face, by the weights of the nearest point: over half a
/// spacing inside the particle, nothing inside the face. docs/theory/heat.md (H14).
template <int Dim>
HeatFlow<Dim> heat_path(const ContactNodes<Dim>& nodes, const ParticleTouch<Dim>& touch,
                        const ContactHeat& heat);

/// What passes at the temperatures that the nodes have at the end of a step without it, so that a
/// perfect contact leaves both sides alike. A capacity that varies counts as the least between the
/// two temperatures: so much heat never brings one side past the other.
template <int Dim>
void exchange_heat(const ContactNodes<Dim>& nodes, const std::vector<Surface<Dim>*>& surfaces,
                   Real dt, HeatFlow<Dim>& flow);

/// A side that friction heats.
struct HeatedSide {
  Label body = 0;
  bool takes = false;   ///< it keeps a temperature
  Real effusivity = 0;  ///< [J/m^2/K/s^(1/2)]
};
/// What of the heat of friction goes to each side [1]; the rest leaves the scene.
struct FrictionShares {
  Real lower = 0, upper = 0;
  Real sum() const { return lower + upper; }
};
/// Split by effusivities all goes to a side alone that takes some; a split by number is of the body
/// with the lower label, and half each within a body.
FrictionShares friction_shares(const FrictionHeat& heat, const HeatedSide& lower,
                               const HeatedSide& upper);

/// What of the heat of friction goes to each node.
template <int Dim>
void share_heat(const FrictionStep<Dim>& step, const FrictionShares& shares,
                Friction<Dim>& friction);

/// The heat of friction in a step of dt [s], as far as it stays.
template <int Dim>
HeatFlow<Dim> heat_of_friction(const ContactRecord<Dim>& record, const Friction<Dim>& friction,
                               Real dt);

}  // namespace brunt
