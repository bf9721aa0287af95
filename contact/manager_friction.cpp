/// How friction goes on from step to step: its past, its books, and what faces carry.
#include <algorithm>

#include "contact/implementation.hpp"
#include "core/state_hash.hpp"

namespace brunt {

namespace {
/// The node to which the energies of a contact are booked; its evaluator owns it.
template <int Dim>
std::size_t book_of(const Entities<Dim>& entities, const ContactKey& key) {
  const LocalIndex node = key.of_particle
                              ? entities.particles[entities.particle_with(key.first)].node
                              : entities.faces[entities.face_with(key.first)].node[0];
  return static_cast<std::size_t>(node);
}

template <class Row, class AnyFriction>
void visit_friction(Row& row, AnyFriction& friction) {
  row(friction.key.second);
  row(friction.key.ordinal);
  row(friction.body);
  row(friction.piece);
  row(friction.normal);
  row(friction.point);
  row(friction.traction);
  row(friction.drag);
  row(friction.area);
  row(friction.stiffness);
  row(friction.n_nodes);
  for (auto& force : friction.force) row(force);
  row(friction.slips);
  row(friction.warms);
  row(friction.heat);
}

/// kind  of_particle of the contact's key
std::string table_of(std::uint32_t kind, std::size_t place) {
  static constexpr const char* kTables[] = {"contact.friction.face.", "contact.friction.particle.",
                                            "contact.friction.particles."};
  return kTables[kind] + std::to_string(place);
}
}  // namespace

template <int Dim>
void ContactManager<Dim>::Implementation::save_friction(std::vector<StateTable>& tables) const {
  std::vector<std::vector<const Friction<Dim>*>> by_place[3];
  const Friction<Dim>* last = nullptr;
  std::size_t place = 0;
  records.visit_with_friction([&](const ContactRecord<Dim>&, const Friction<Dim>* friction) {
    if (friction == nullptr) return;
    const auto& key = friction->key;
    const bool same =
        last != nullptr && last->key.first == key.first && last->key.of_particle == key.of_particle;
    place = same ? place + 1 : 0;
    last = friction;
    auto& places = by_place[key.of_particle];
    if (places.size() <= place) places.resize(place + 1);
    places[place].push_back(friction);
  });
  for (std::uint32_t kind = 0; kind < 3; ++kind) {
    const auto& places = by_place[kind];
    for (std::size_t p = 0; p < places.size(); ++p) {
      const auto& chosen = places[p];
      save_rows(
          table_of(kind, p), chosen.size(), [&](std::size_t k) { return chosen[k]->key.first; },
          [&](auto& row, std::size_t k) { visit_friction(row, *chosen[k]); }, tables);
    }
  }
}

template <int Dim>
void ContactManager<Dim>::Implementation::load_friction(const StateTables& tables) {
  std::vector<Friction<Dim>> known;
  const auto load = [&](std::uint32_t kind, GlobalId first) {
    for (std::size_t place = 0; tables.has(table_of(kind, place)); ++place) {
      const auto& rows = tables.rows(table_of(kind, place));
      if (!rows.has(first)) return;
      auto& friction = known.emplace_back();
      friction.key.of_particle = kind;
      friction.key.first = first;
      StateCounter counter;
      visit_friction(counter, friction);
      StateReader row(rows.row(first, counter.count));
      visit_friction(row, friction);
    }
  };
  for (const auto& face : entities.faces) {
    if (face.owned) load(0, face.id);
  }
  for (const std::uint32_t kind : {1, 2}) {
    for (const auto& particle : entities.particles) {
      if (particle.owned) load(kind, particle.id);
    }
  }
  records.attach([&](const ContactKey& key) -> const Friction<Dim>* {
    const auto at = std::lower_bound(
        known.begin(), known.end(), key,
        [](const Friction<Dim>& one, const ContactKey& wanted) { return one.key < wanted; });
    return at == known.end() || !(at->key == key) ? nullptr : &*at;
  });
  sum_tractions();
}

template <int Dim>
void ContactManager<Dim>::Implementation::begin_friction(Real dt) {
  if (!entities.nodes.rubs) return;
  history.clear();
  records.visit_with_friction([&](const ContactRecord<Dim>&, const Friction<Dim>* friction) {
    if (friction != nullptr) history.add(*friction);
  });
  history.take_work(entities.nodes, dt);
}

template <int Dim>
void ContactManager<Dim>::Implementation::end_friction() {
  auto& nodes = entities.nodes;
  if (!nodes.rubs) return;
  records.visit_with_friction([&](const ContactRecord<Dim>&, const Friction<Dim>* friction) {
    if (friction == nullptr) return;
    const std::size_t at = book_of(entities, friction->key);
    nodes.friction_heat[at] += friction->heat;
    if (friction->warms) nodes.friction_given[at] += friction->heat;
    nodes.friction_stored[at] += friction->stored;
    nodes.friction_damped[at] += friction->damped;
    nodes.pair_energy[at] += friction->pairs;
  });
  // What ended gives its spring's energy away. Its forces acted for the first half of the step:
  // heat where it was slipping, for the node that holds its books.
  std::fill(nodes.ended_heat.begin(), nodes.ended_heat.end(), 0.0);
  history.visit_ended([&](const Friction<Dim>& friction) {
    const std::size_t at = book_of(entities, friction.key);
    nodes.friction_stored[at] -= friction.energy();
    nodes.pair_energy[at] += friction.energy();
    const bool takes = nodes.warm && nodes.capacity[at] > 0;
    const bool is_heat = friction.slips && (takes || !friction.warms);
    (is_heat ? nodes.friction_heat : nodes.pair_energy)[at] += friction.taken;
    if (!is_heat || !takes) return;
    nodes.ended_heat[at] += friction.taken;
    nodes.friction_given[at] += friction.taken;
  });
  sum_tractions();
}

template <int Dim>
void ContactManager<Dim>::Implementation::sum_tractions() {
  auto& tractions = entities.tractions;
  std::fill(tractions.begin(), tractions.end(), FaceTraction<Dim>{});
  const auto elsewhere = imports.send_tractions(records, entities);
  auto next = elsewhere.begin();
  const auto add = [&](GlobalId face, Real area, const Vec<Dim>& force) {
    const std::size_t at = entities.face_with(face);
    if (entities.faces[at].rigid()) return;  // on several ranks nobody has all of its contacts
    auto& traction = tractions[at];
    traction.area += area;
    traction.force += force;
  };
  const auto add_next = [&] {
    add(next->key.second, next->area, Vec<Dim>(next->force));
    ++next;
  };
  records.visit_with_friction([&](const ContactRecord<Dim>&, const Friction<Dim>* friction) {
    if (friction == nullptr || friction->key.of_particle) return;
    while (next != elsewhere.end() && next->key < friction->key) add_next();
    add(friction->key.first, friction->area, -friction->slider());
    add(friction->key.second, friction->area, friction->slider());
  });
  while (next != elsewhere.end()) add_next();
}

template <int Dim>
void ContactManager<Dim>::Implementation::name_nodes() {
  records.name_nodes([&](const ContactRecord<Dim>& record) {
    auto node = record.node;
    std::size_t n = 0;
    const auto add_face = [&](GlobalId id) {
      const auto& face = entities.faces[entities.face_with(id)];
      for (int c = 0; c < face.n_nodes; ++c) node[n++] = face.node[static_cast<std::size_t>(c)];
    };
    const auto add = [&](GlobalId id, bool particle) {
      if (!particle) return add_face(id);
      node[n++] = entities.particles[entities.particle_with(id)].node;
    };
    add(record.first, record.of_particle);
    add(record.second, record.of_two_particles);
    return node;
  });
}

template <int Dim>
std::uint64_t ContactManager<Dim>::Implementation::friction_hash() const {
  std::uint64_t sum = 0;
  records.visit_with_friction([&](const ContactRecord<Dim>&, const Friction<Dim>* friction) {
    if (friction == nullptr) return;
    EntityHash hash(friction->key.first);
    hash.add(friction->key.second);
    hash.add(friction->area);
    for (int c = 0; c < Dim; ++c) hash.add(friction->traction[c]);
    sum += hash.value();
  });
  return sum;
}

template struct ContactManager<2>::Implementation;
template struct ContactManager<3>::Implementation;

}  // namespace brunt
