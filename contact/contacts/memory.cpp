#include "contact/contacts/memory.hpp"

#include <algorithm>

namespace brunt {

template <int Dim>
void ContactMemory<Dim>::begin_step(const Records<Dim>& records, const ContactNodes<Dim>& nodes,
                                    Real dt) {
  if (!nodes.has_friction) return;
  past_.clear();
  records.visit_frictions([&](const Friction<Dim>& friction) { past_.add(friction, nodes, dt); });
}

template <int Dim>
void ContactMemory<Dim>::end_step(const Records<Dim>& records, const Entities<Dim>& entities,
                                  Real dt, Real time) {
  records.collect_touches(touches_);
  records.collect_ties(ties_);
  records.collect_closures(closures_);
  keep_lost(records, entities, dt, time);
}

template <int Dim>
void ContactMemory<Dim>::bury(const std::vector<GlobalId>& died) {
  died_ = died;
  if (died_.empty()) return;
  // A restart, or another rank, takes over the memories of faces that are there.
  const auto dead = [&](const auto& memory) {
    return memory.key.kind == ContactKind::face_face &&
           std::binary_search(died_.begin(), died_.end(), memory.key.first);
  };
  lost_.remove(dead);
  closures_.remove(dead);
}

template <int Dim>
void ContactMemory<Dim>::take_repeated(const Records<Dim>& records) {
  records.collect_touches(touches_);
  records.collect_ties(ties_);
  records.collect_deep(deep_);
}

/// What the evaluation noted itself, and of the particles that were deep in the one before those
/// that nothing of the same body holds any more, though they are no less deep.
template <int Dim>
void ContactMemory<Dim>::keep_lost(const Records<Dim>& records, const Entities<Dim>& entities,
                                   Real dt, Real time) {
  records.visit_lost([&](LostContact<Dim> contact) {
    contact.time = time;
    lost_.add_if_new(contact);
  });
  std::vector<DeepParticle<Dim>> before;
  before.swap(deep_);
  records.collect_deep(deep_);
  if (before.empty()) return;
  std::vector<bool> held(before.size(), false);
  records.visit([&](const ContactRecord<Dim>& record) {
    if (record.kind != ContactKind::particle_face) return;
    for (std::size_t i = 0; i < before.size(); ++i) {
      const bool same = before[i].key.first == record.first && before[i].body == record.lower_body;
      held[i] = held[i] || same;
    }
  });
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (held[i] || std::binary_search(died_.begin(), died_.end(), before[i].key.second)) continue;
    const auto& one = before[i];
    const auto& particle = entities.particles[entities.particle_with(one.key.first)];
    const Vec<Dim> point = one.point + dt * one.velocity;
    const Vec<Dim>& x = entities.nodes.x[slot_of(particle.node)];
    const Real depth = one.outward.dot(point - x);
    if (depth > one.limit) {
      lost_.add_if_new({one.key, one.body, one.body_of_particle, time, depth, point});
    }
  }
}

template <int Dim>
std::uint64_t ContactMemory<Dim>::hash(const Records<Dim>& records) const {
  std::uint64_t sum = touches_.hash() + ties_.hash() + closures_.hash();
  records.visit_frictions([&](const Friction<Dim>& friction) { sum += hash_of(friction); });
  return sum;
}

template <int Dim>
void ContactMemory<Dim>::save(const Records<Dim>& records, const Entities<Dim>& entities,
                              std::vector<StateTable>& tables) const {
  std::vector<const Friction<Dim>*> frictions;
  records.visit_frictions([&](const Friction<Dim>& friction) { frictions.push_back(&friction); });
  save_memories(frictions, tables);
  growths_of(entities).save(tables);
  touches_.save(tables);
  ties_.save(tables);
  closures_.save(tables);
  lost_.save(tables);
}

template <int Dim>
void ContactMemory<Dim>::load(const Entities<Dim>& entities, const StateTables& tables) {
  touches_.load(entities, tables);
  ties_.load(entities, tables);
  closures_.load(entities, tables);
  lost_.load(entities, tables);
}

template <int Dim>
void load_friction(const Entities<Dim>& entities, const StateTables& tables,
                   Records<Dim>& records) {
  KeyedMemory<Friction<Dim>> frictions;
  frictions.load(entities, tables);
  records.attach([&](const ContactKey& key) { return frictions.find(key); });
}

template class ContactMemory<2>;
template class ContactMemory<3>;
template void load_friction<2>(const Entities<2>&, const StateTables&, Records<2>&);
template void load_friction<3>(const Entities<3>&, const StateTables&, Records<3>&);

}  // namespace brunt
// Tested by tests/unit/contact/lost_test.cpp.
