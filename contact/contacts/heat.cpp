#include "contact/contacts/heat.hpp"

#include <algorithm>
#include <cmath>

#include "contact/contacts/record.hpp"

namespace brunt {

Real heat_between(Real h_area, Real lower, Real upper, Real difference, Real dt) {
  if (!(lower > 0) || !(upper > 0) || !(dt > 0)) return 0;
  // A surface that is held takes any heat: its capacity is infinite.
  const Real smaller = std::min(lower, upper), larger = std::max(lower, upper);
  const Real both = std::isinf(larger) ? smaller : lower * upper / (lower + upper);
  return difference / (1 / h_area + dt / both);
}

template <int Dim>
HeatFlow<Dim> heat_path(const ContactFace<Dim>& lower, const ContactFace<Dim>& upper,
                        const CommonPlane<Dim>& plane, const ContactHeat& heat, Real pressed,
                        Real pressure) {
  HeatFlow<Dim> flow;
  flow.key = {ContactKind::face_face, plane.ordinal, lower.id, upper.id};
  flow.lower_body = lower.body, flow.upper_body = upper.body;
  flow.lower = {lower.capacity * plane.area, lower.surface, lower.specific_heat};
  flow.upper = {upper.capacity * plane.area, upper.surface, upper.specific_heat};
  const Real open = conductance_of(heat, 0), under = conductance_of(heat, pressure);
  flow.area = plane.area;
  flow.h_area = under * plane.area;
  if (open != under) flow.h_area = under * pressed + open * (plane.area - pressed);
  const auto take = [&](const ContactFace<Dim>& face, const auto& weight, Real sign) {
    for (std::size_t c = 0; c < slot_of(face.n_nodes); ++c) {
      const auto k = slot_of(flow.n_nodes++);
      flow.node[k] = face.node[c];
      flow.weight[k] = sign * weight[c];
    }
  };
  take(lower, plane.lower_at_middle, -1);
  take(upper, plane.upper_at_middle, 1);
  return flow;
}

template <int Dim>
HeatFlow<Dim> heat_path(const ContactNodes<Dim>& nodes, const ParticleTouch<Dim>& touch,
                        const ContactHeat& heat) {
  const auto& [particle, face, hit, area, pressure, contacts] = touch;
  HeatFlow<Dim> flow;
  flow.key = {ContactKind::particle_face, 0, particle.id, face.id};
  flow.lower_body = face.body, flow.upper_body = particle.body;
  flow.node[0] = particle.node, flow.weight[0] = 1;
  for (std::size_t c = 0; c < slot_of(face.n_nodes); ++c) {
    flow.node[c + 1] = face.node[c];
    flow.weight[c + 1] = -hit.nearest.weight[c];
  }
  flow.n_nodes = 1 + face.n_nodes;
  // What just touches has no share of a force: such contacts share the particle among them.
  const Real share = (hit.share > 0 ? hit.share : 1.0 / contacts) * area;
  flow.area = share;
  flow.lower = {face.capacity * share, face.surface, face.specific_heat};
  flow.upper = {nodes.capacity[slot_of(particle.node)] / contacts, particle.surface,
                particle.specific_heat};
  flow.h_area = share / (1 / conductance_of(heat, pressure) +
                         particle.radius / particle.matter->conductivity);
  return flow;
}

namespace {
/// Temperatures [K] of both sides, lower first.
template <int Dim>
std::array<Real, 2> temperatures_of(const ContactNodes<Dim>& nodes, const HeatFlow<Dim>& flow) {
  std::array<Real, 2> T{};
  for (std::size_t k = 0; k < slot_of(flow.n_nodes); ++k) {
    const Real part = flow.weight[k] * nodes.temperature[slot_of(flow.node[k])];
    flow.weight[k] < 0 ? T[0] -= part : T[1] += part;
  }
  return T;
}

/// [J/K] least between the temperatures of both sides.
template <int Dim>
Real capacity_between(const HeatSide& side, const std::array<Real, 2>& T,
                      const std::vector<Surface<Dim>*>& surfaces) {
  if (side.specific_heat < 0) return side.capacity;
  const auto& points = *surfaces[slot_of(side.surface)]->points;
  const auto& cp = points.specific_heats[slot_of(side.specific_heat)];
  return side.capacity * cp.least_between(T[0], T[1]);
}
}  // namespace

template <int Dim>
void exchange_heat(const ContactNodes<Dim>& nodes, const std::vector<Surface<Dim>*>& surfaces,
                   Real dt, HeatFlow<Dim>& flow) {
  if (flow.h_area == 0) return;
  const auto T = temperatures_of(nodes, flow);
  const Real lower = capacity_between(flow.lower, T, surfaces);
  const Real upper = capacity_between(flow.upper, T, surfaces);
  flow.through = heat_between(flow.h_area, lower, upper, T[0] - T[1], dt);
  for (std::size_t k = 0; k < slot_of(flow.n_nodes); ++k) {
    flow.rate[k] = flow.weight[k] * flow.through;
  }
}

FrictionShares friction_shares(const FrictionHeat& heat, const HeatedSide& lower,
                               const HeatedSide& upper) {
  Real of_lower = 0;
  if (heat.split) {
    of_lower = lower.body < upper.body ? *heat.split : 1 - *heat.split;
    if (lower.body == upper.body) of_lower = 0.5;
  } else if (const Real both = lower.effusivity + upper.effusivity; both > 0) {
    of_lower = lower.effusivity / both;
  } else {
    of_lower = lower.takes ? 1 : 0;
  }
  return {lower.takes ? heat.fraction * of_lower : 0.0,
          upper.takes ? heat.fraction * (1 - of_lower) : 0.0};
}

template <int Dim>
void share_heat(const FrictionStep<Dim>& step, const FrictionShares& shares,
                Friction<Dim>& friction) {
  friction.heat_share = shares.sum();
  const auto give = [&](const ContactSide& side, Real share) {
    for (int i = side.first; i < side.last; ++i) {
      const auto k = slot_of(i);
      friction.heat_shares[k] = step.weight[k] * share;
    }
  };
  give(step.lower, shares.lower);
  give(step.upper, shares.upper);
}

template <int Dim>
HeatFlow<Dim> heat_of_friction(const ContactRecord<Dim>& record, const Friction<Dim>& friction,
                               Real dt) {
  HeatFlow<Dim> flow;
  flow.key = key_of(record);
  flow.key.ordinal += HeatFlow<Dim>::kFriction;
  flow.lower_body = record.lower_body, flow.upper_body = record.upper_body;
  flow.n_nodes = record.n_nodes;
  flow.node = record.node;
  const Real power = friction.heat / dt;
  for (std::size_t k = 0; k < slot_of(flow.n_nodes); ++k) {
    flow.rate[k] = friction.heat_shares[k] * power;
  }
  return flow;
}

template HeatFlow<2> heat_path<2>(const ContactFace<2>&, const ContactFace<2>&,
                                  const CommonPlane<2>&, const ContactHeat&, Real, Real);
template HeatFlow<2> heat_path<2>(const ContactNodes<2>&, const ParticleTouch<2>&,
                                  const ContactHeat&);
template void exchange_heat<2>(const ContactNodes<2>&, const std::vector<Surface<2>*>&, Real,
                               HeatFlow<2>&);
template void share_heat<2>(const FrictionStep<2>&, const FrictionShares&, Friction<2>&);
template void share_heat<3>(const FrictionStep<3>&, const FrictionShares&, Friction<3>&);
template HeatFlow<2> heat_of_friction<2>(const ContactRecord<2>&, const Friction<2>&, Real);
template HeatFlow<3> heat_path<3>(const ContactFace<3>&, const ContactFace<3>&,
                                  const CommonPlane<3>&, const ContactHeat&, Real, Real);
template HeatFlow<3> heat_path<3>(const ContactNodes<3>&, const ParticleTouch<3>&,
                                  const ContactHeat&);
template void exchange_heat<3>(const ContactNodes<3>&, const std::vector<Surface<3>*>&, Real,
                               HeatFlow<3>&);
template HeatFlow<3> heat_of_friction<3>(const ContactRecord<3>&, const Friction<3>&, Real);

}  // namespace brunt
