#include "contact/contacts/friction_books.hpp"

#include <algorithm>
#include <utility>

namespace brunt {

namespace {
/// The node to which the energies of a past contact are booked. Its face may be gone: its corners
/// are still there.
template <int Dim>
std::size_t book_of(const Entities<Dim>& entities, const FrictionMemory<Dim>& past) {
  const auto& nodes = entities.nodes;
  if (past.key.kind != ContactKind::face_face || entities.has_face(past.key.first))
    return book_of(entities, past.key);
  std::size_t at = 0;
  while (at + 1 < nodes.size() &&
         !(nodes.surface[at] == past.book_surface && nodes.id[at] == past.book_point)) {
    ++at;
  }
  return at;
}

bool has_eroded(const std::vector<GlobalId>& died, const ContactKey& key) {
  const auto went = [&](GlobalId face) {
    return std::binary_search(died.begin(), died.end(), face);
  };
  if (key.kind == ContactKind::particle_particle) return false;
  return went(key.second) || (key.kind == ContactKind::face_face && went(key.first));
}

/// What ended gives its spring's energy away. Its forces acted for the first half of the step: heat
/// where it was slipping and did not turn back, shared as that of the step before.
template <int Dim>
void book_ended(const FrictionHistory<Dim>& past, const std::vector<GlobalId>& died,
                Entities<Dim>& entities) {
  auto& nodes = entities.nodes;
  past.visit_ended([&](const FrictionMemory<Dim>& friction) {
    const std::size_t at = book_of(entities, friction);
    nodes.friction_stored[at] -= friction.energy();
    const Real heat = friction.last_heat();
    const Real lost = friction.energy() + friction.taken - heat;
    nodes.pair_energy[at] += lost;
    if (has_eroded(died, friction.key)) nodes.eroded_energy[at] += lost;
    nodes.friction_heat[at] += heat;
    if (friction.slips && nodes.conduct) nodes.friction_given[at] += friction.heat_share * heat;
  });
}
}  // namespace

template <int Dim>
void book_friction(const Records<Dim>& records, const FrictionHistory<Dim>& past,
                   const std::vector<GlobalId>& died, const PairTable& pairs,
                   std::vector<TractionShare<Dim>> elsewhere, FrictionCheck<Dim>& check,
                   Entities<Dim>& entities) {
  auto& nodes = entities.nodes;
  // One pass for all: of a million faces, reading records takes longer than what is done with them.
  TractionSum<Dim> tractions(entities, std::move(elsewhere));
  records.visit_with_friction([&](const ContactRecord<Dim>& record, const Friction<Dim>* friction) {
    if (friction == nullptr) return;
    check.see(pairs, record, *friction);
    const auto at = slot_of(record.node[0]);
    nodes.friction_heat[at] += friction->heat;
    if (friction->heat_share > 0) nodes.friction_given[at] += friction->heat_share * friction->heat;
    nodes.friction_stored[at] += friction->stored;
    nodes.friction_damped[at] += friction->damped;
    nodes.pair_energy[at] += friction->pairs;
    tractions.add(record, *friction);
  });
  tractions.finish();
  book_ended(past, died, entities);
}

template <int Dim>
void book_losses(const Records<Dim>& records, Entities<Dim>& entities) {
  records.visit_losses([&](const JointLoss& loss) {
    entities.nodes.joint_loss[book_of(entities, loss.key)] += loss.energy;
  });
}

template <int Dim>
void book_eroded(const Records<Dim>& records, const std::vector<GlobalId>& died, Real dt,
                 ContactNodes<Dim>& nodes) {
  if (died.empty()) return;
  records.visit_whole([&](const WholeRecord<Dim>& whole) {
    const auto& record = whole.record;
    if (!has_eroded(died, key_of(record))) return;
    Real energy = record.stored;
    for (std::size_t k = 0; k < slot_of(record.n_nodes); ++k) {
      const auto node = slot_of(record.node[k]);
      energy -= 0.5 * dt * whole.spring_on(k).dot(nodes.v[node]);
    }
    nodes.eroded_energy[slot_of(record.node[0])] += energy;
  });
}

template void book_losses<2>(const Records<2>&, Entities<2>&);
template void book_eroded<2>(const Records<2>&, const std::vector<GlobalId>&, Real,
                             ContactNodes<2>&);
template void book_losses<3>(const Records<3>&, Entities<3>&);
template void book_eroded<3>(const Records<3>&, const std::vector<GlobalId>&, Real,
                             ContactNodes<3>&);
template void book_friction<2>(const Records<2>&, const FrictionHistory<2>&,
                               const std::vector<GlobalId>&, const PairTable&,
                               std::vector<TractionShare<2>>, FrictionCheck<2>&, Entities<2>&);
template void book_friction<3>(const Records<3>&, const FrictionHistory<3>&,
                               const std::vector<GlobalId>&, const PairTable&,
                               std::vector<TractionShare<3>>, FrictionCheck<3>&, Entities<3>&);

}  // namespace brunt
// Tested by tests/unit/contact/friction_heat_test.cpp.
