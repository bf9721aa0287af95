/// How friction goes on from step to step: its past, its books, and what faces carry.
#include <sstream>

#include "contact/manager/implementation.hpp"

namespace brunt {

template <int Dim>
void ContactManager<Dim>::Implementation::read_materials() {
  auto& nodes = entities.nodes;
  if (!nodes.needs_material) return;
  entities.read_materials(surfaces);
  imports.refresh_materials(entities.materials);
  nodes.read_temperatures(surfaces);
  imports.refresh_temperatures(nodes.temperature);
}

template <int Dim>
void ContactManager<Dim>::Implementation::refuse_friction(const ContactRecord<Dim>& record,
                                                          const Friction<Dim>& friction) {
  const auto& at = friction.state;
  std::ostringstream cause;
  cause << "it must be at least 0, and is found at T = " << at.temperature
        << " K, yield = " << at.flow_stress << " Pa, p = " << at.pressure << " Pa, v = " << at.speed
        << " m/s";
  const auto pair = pairs.find(record.lower_body, record.upper_body);
  wrong_friction = {0,
                    "",
                    "contact " + pairs.name(pair.value()),
                    "coefficient of friction",
                    friction.coefficient,
                    cause.str()};
  wrong_friction_at = friction.point;
  step_limit.take({-1, "coefficient of friction", 0, 0});
}

template <int Dim>
void ContactManager<Dim>::check(Real time, const Vec<Dim>& origin) const {
  if (!implementation_->wrong_friction) return;
  PhysicsFailure failure = *implementation_->wrong_friction;
  failure.time = time;
  const Vec<Dim> at = implementation_->wrong_friction_at + origin;
  std::ostringstream place;
  for (int c = 0; c < Dim; ++c) place << (c == 0 ? " at (" : ", ") << at[c];
  failure.entity += place.str() + ") m";
  throw PhysicsError(failure);
}

template <int Dim>
void ContactManager<Dim>::Implementation::end_friction() {
  auto& nodes = entities.nodes;
  if (!nodes.has_friction) return;
  wrong_friction.reset();
  if (!near.any()) return;
  // One pass for all: of a million faces, reading records takes longer than what is done with them.
  TractionSum<Dim> tractions(entities, imports.send_tractions(records, entities));
  records.visit_with_friction([&](const ContactRecord<Dim>& record, const Friction<Dim>* friction) {
    if (friction == nullptr) return;
    const bool right = friction->coefficient >= 0 && friction->coefficient < kInfinity;
    if (!right && !wrong_friction) refuse_friction(record, *friction);
    const auto at = static_cast<std::size_t>(record.node[0]);
    nodes.friction_heat[at] += friction->heat;
    if (friction->warmth > 0) nodes.friction_given[at] += friction->warmth * friction->heat;
    nodes.friction_stored[at] += friction->stored;
    nodes.friction_damped[at] += friction->damped;
    nodes.pair_energy[at] += friction->pairs;
    tractions.add(record, *friction);
  });
  tractions.finish();
  // What ended gives its spring's energy away. Its forces acted for the first half of the step:
  // heat where it was slipping and did not turn back, shared as that of the step before.
  ended_heat = memory.past().ended_heat();
  memory.past().visit_ended([&](const FrictionMemory<Dim>& friction) {
    const std::size_t at = book_of(entities, friction.key);
    nodes.friction_stored[at] -= friction.energy();
    const Real heat = friction.last_heat();
    nodes.pair_energy[at] += friction.energy();
    nodes.pair_energy[at] += friction.taken - heat;
    nodes.friction_heat[at] += heat;
    if (friction.slips && nodes.conduct) nodes.friction_given[at] += friction.warmth * heat;
  });
}

template <int Dim>
void ContactManager<Dim>::Implementation::sum_tractions() {
  TractionSum<Dim> sum(entities, imports.send_tractions(records, entities));
  records.visit_with_friction([&](const ContactRecord<Dim>& record, const Friction<Dim>* friction) {
    if (friction != nullptr) sum.add(record, *friction);
  });
  sum.finish();
}

template void ContactManager<2>::check(Real, const Vec<2>&) const;
template void ContactManager<3>::check(Real, const Vec<3>&) const;
template struct ContactManager<2>::Implementation;
template struct ContactManager<3>::Implementation;

}  // namespace brunt
