#include "contact/heat.hpp"

#include "contact/record.hpp"

namespace brunt {

template <int Dim>
Real heat_between(const HeatFlow<Dim>& flow, Real difference, Real dt) {
  const Real lower = flow.lower_capacity, upper = flow.upper_capacity;
  if (!(lower > 0) || !(upper > 0) || !(dt > 0)) return 0;
  const Real both = lower * upper / (lower + upper);
  return difference / (1 / flow.h_area + dt / both);
}

template <int Dim>
HeatFlow<Dim> heat_path(const ContactFace<Dim>& lower, const ContactFace<Dim>& upper,
                        const CommonPlane<Dim>& plane, Real conductance) {
  HeatFlow<Dim> flow;
  flow.key = {0, plane.ordinal, lower.id, upper.id};
  flow.lower_body = lower.body, flow.upper_body = upper.body;
  flow.lower_capacity = lower.capacity * plane.area;
  flow.upper_capacity = upper.capacity * plane.area;
  flow.h_area = conductance * plane.area;
  const auto take = [&](const ContactFace<Dim>& face, const auto& weight, Real sign) {
    for (std::size_t c = 0; c < static_cast<std::size_t>(face.n_nodes); ++c) {
      const auto k = static_cast<std::size_t>(flow.n_nodes++);
      flow.node[k] = face.node[c];
      flow.weight[k] = sign * weight[c];
    }
  };
  take(lower, plane.lower_at_middle, -1);
  take(upper, plane.upper_at_middle, 1);
  return flow;
}

template <int Dim>
HeatFlow<Dim> heat_path(const ContactNodes<Dim>& nodes, const ContactRecord<Dim>& record,
                        const ContactParticle& particle, const ContactFace<Dim>& face,
                        Real conductance, int contacts) {
  HeatFlow<Dim> flow;
  flow.key = key_of(record);
  flow.lower_body = record.lower_body, flow.upper_body = record.upper_body;
  flow.n_nodes = record.n_nodes;
  flow.node = record.node;
  flow.weight = record.weight;
  flow.lower_capacity = face.capacity * record.area;
  flow.upper_capacity = nodes.capacity[static_cast<std::size_t>(particle.node)] / contacts;
  flow.h_area = record.area / (1 / conductance + particle.radius / particle.conductivity);
  return flow;
}

template <int Dim>
void exchange_heat(const ContactNodes<Dim>& nodes, Real dt, HeatFlow<Dim>& flow) {
  if (flow.h_area == 0) return;
  Real difference = 0;  // lower less upper
  for (std::size_t k = 0; k < static_cast<std::size_t>(flow.n_nodes); ++k) {
    difference -= flow.weight[k] * nodes.temperature[static_cast<std::size_t>(flow.node[k])];
  }
  flow.through = heat_between(flow, difference, dt);
  for (std::size_t k = 0; k < static_cast<std::size_t>(flow.n_nodes); ++k) {
    flow.rate[k] = flow.weight[k] * flow.through;
  }
}

template <int Dim>
HeatFlow<Dim> heat_of_friction(const ContactRecord<Dim>& record, const FrictionStep<Dim>& step,
                               const Friction<Dim>& friction, Real lower_effusivity,
                               Real upper_effusivity) {
  HeatFlow<Dim> flow;
  flow.key = key_of(record);
  flow.key.ordinal += HeatFlow<Dim>::kFriction;
  flow.lower_body = record.lower_body, flow.upper_body = record.upper_body;
  flow.n_nodes = record.n_nodes;
  flow.node = record.node;
  const Real power = friction.heat / step.dt;
  const Real lower = power * (lower_effusivity / (lower_effusivity + upper_effusivity));
  const auto give = [&](const ContactSide& side, Real rate) {
    for (int i = side.first; i < side.last; ++i) {
      const auto k = static_cast<std::size_t>(i);
      flow.rate[k] = step.weight[k] * rate;
    }
  };
  give(step.lower, lower);
  give(step.upper, power - lower);
  return flow;
}

template Real heat_between<2>(const HeatFlow<2>&, Real, Real);
template HeatFlow<2> heat_path<2>(const ContactFace<2>&, const ContactFace<2>&,
                                  const CommonPlane<2>&, Real);
template HeatFlow<2> heat_path<2>(const ContactNodes<2>&, const ContactRecord<2>&,
                                  const ContactParticle&, const ContactFace<2>&, Real, int);
template void exchange_heat<2>(const ContactNodes<2>&, Real, HeatFlow<2>&);
template Real heat_between<3>(const HeatFlow<3>&, Real, Real);
template HeatFlow<3> heat_path<3>(const ContactFace<3>&, const ContactFace<3>&,
                                  const CommonPlane<3>&, Real);
template HeatFlow<3> heat_path<3>(const ContactNodes<3>&, const ContactRecord<3>&,
                                  const ContactParticle&, const ContactFace<3>&, Real, int);
template void exchange_heat<3>(const ContactNodes<3>&, Real, HeatFlow<3>&);
template HeatFlow<2> heat_of_friction<2>(const ContactRecord<2>&, const FrictionStep<2>&,
                                         const Friction<2>&, Real, Real);
template HeatFlow<3> heat_of_friction<3>(const ContactRecord<3>&, const FrictionStep<3>&,
                                         const Friction<3>&, Real, Real);

}  // namespace brunt
