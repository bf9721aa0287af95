/// What the manager remembers of contacts that did not hold.
#include "contact/contacts/lost.hpp"
#include "contact/contacts/keyed_rows.hpp"
#include "contact/manager/implementation.hpp"

namespace brunt {

namespace {
constexpr const char* kLostTable = "contact.lost";

template <class Row, class AnyLost>
void visit_lost(Row& row, AnyLost& contact) {
  row(contact.key.second);
  row(contact.key.ordinal);
  row(contact.lower_body);
  row(contact.upper_body);
  row(contact.time);
  row(contact.depth);
  row(contact.point);
}
}  // namespace

/// What the evaluation noted itself, and of the particles that were deep in the one before those
/// that nothing of the same body holds any more, though they are no less deep.
template <int Dim>
void ContactManager<Dim>::Implementation::remember_lost(Real dt, Real time) {
  records.visit_lost([&](LostContact<Dim> contact) {
    contact.time = time;
    lost.add(contact);
  });
  std::vector<DeepParticle<Dim>> before;
  before.swap(deep);
  records.collect_deep(deep);
  if (before.empty()) return;
  std::vector<bool> held(before.size(), false);
  records.visit([&](const ContactRecord<Dim>& record) {
    if (!record.of_particle || record.of_two_particles) return;
    for (std::size_t i = 0; i < before.size(); ++i) {
      const bool same = before[i].key.first == record.first && before[i].body == record.lower_body;
      held[i] = held[i] || same;
    }
  });
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (held[i]) continue;
    const auto& one = before[i];
    const auto& particle = entities.particles[entities.particle_with(one.key.first)];
    const Vec<Dim> point = one.point + dt * one.velocity;
    const Vec<Dim>& x = entities.nodes.x[static_cast<std::size_t>(particle.node)];
    const Real depth = one.outward.dot(point - x);
    if (depth > one.limit) {
      lost.add({one.key, one.body, one.body_of_particle, time, depth, point});
    }
  }
}

template <int Dim>
void ContactManager<Dim>::Implementation::save_lost(std::vector<StateTable>& tables) const {
  std::vector<const LostContact<Dim>*> all;
  for (const auto& contact : lost.all()) all.push_back(&contact);
  save_keyed(
      kLostTable, all, [](auto& row, const auto& contact) { visit_lost(row, contact); }, tables);
}

template <int Dim>
void ContactManager<Dim>::Implementation::load_lost(const StateTables& tables) {
  const auto visit = [](auto& row, auto& contact) { visit_lost(row, contact); };
  lost.all().clear();
  load_keyed(kLostTable, entities, tables, visit, lost.all());
}

template void ContactManager<2>::Implementation::remember_lost(Real, Real);
template void ContactManager<3>::Implementation::remember_lost(Real, Real);
template void ContactManager<2>::Implementation::save_lost(std::vector<StateTable>&) const;
template void ContactManager<3>::Implementation::save_lost(std::vector<StateTable>&) const;
template void ContactManager<2>::Implementation::load_lost(const StateTables&);
template void ContactManager<3>::Implementation::load_lost(const StateTables&);

}  // namespace brunt
