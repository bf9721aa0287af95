/// How friction goes on from step to step: its past, its books, and what faces carry.
#include <algorithm>
#include <sstream>

#include "contact/contacts/keyed_rows.hpp"
#include "contact/manager/implementation.hpp"
#include "core/state_hash.hpp"

namespace brunt {

namespace {
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
  for (auto& share : friction.warms) row(share);
  row(friction.slips);
  row(friction.warmth);
  row(friction.heat);
}

/// Sums what each face carries, from contacts of all ranks in the order of keys.
template <int Dim>
class TractionSum {
 public:
  /// elsewhere  from other ranks, sorted by key
  TractionSum(Entities<Dim>& entities, std::vector<TractionShare<Dim>> elsewhere)
      : entities_(entities), elsewhere_(std::move(elsewhere)) {
    for (auto& traction : entities_.tractions) {
      area_before_.push_back(traction.area);
      traction = {};
    }
  }
  void add(const ContactRecord<Dim>& record, const Friction<Dim>& friction) {
    if (record.of_particle) return;
    while (next_ < elsewhere_.size() && elsewhere_[next_].key < friction.key) add_next();
    add(static_cast<std::size_t>(record.first_place), friction.area, -friction.slider());
    add(static_cast<std::size_t>(record.second_place), friction.area, friction.slider());
  }
  /// Adds what is left, and tells how areas have grown.
  void finish() {
    while (next_ < elsewhere_.size()) add_next();
    for (std::size_t f = 0; f < area_before_.size(); ++f) {
      auto& traction = entities_.tractions[f];
      if (!(area_before_[f] > 0 && traction.area > 0)) continue;
      traction.growth = traction.area / area_before_[f];
    }
  }

 private:
  void add(std::size_t face, Real area, const Vec<Dim>& force) {
    if (entities_.faces[face].rigid()) return;  // on several ranks nobody has all of its contacts
    auto& traction = entities_.tractions[face];
    traction.area += area;
    traction.force += force;
  }
  void add_next() {
    const auto& share = elsewhere_[next_++];
    add(entities_.face_with(share.key.second), share.area, Vec<Dim>(share.force));
  }

  Entities<Dim>& entities_;
  std::vector<TractionShare<Dim>> elsewhere_;
  std::size_t next_ = 0;
  std::vector<Real> area_before_;  // [m^2]
};

constexpr const char* kFrictionTable = "contact.friction";
constexpr const char* kGrowths = "contact.friction.growth";
}  // namespace

template <int Dim>
void ContactManager<Dim>::Implementation::save_friction(std::vector<StateTable>& tables) const {
  std::vector<const Friction<Dim>*> all;
  records.visit_with_friction([&](const ContactRecord<Dim>&, const Friction<Dim>* friction) {
    if (friction != nullptr) all.push_back(friction);
  });
  save_keyed(
      kFrictionTable, all, [](auto& row, const auto& friction) { visit_friction(row, friction); },
      tables);
  save_growths(tables);
}

template <int Dim>
void ContactManager<Dim>::Implementation::load_friction(const StateTables& tables) {
  std::vector<Friction<Dim>> known;
  const auto visit = [](auto& row, auto& friction) { visit_friction(row, friction); };
  load_keyed(kFrictionTable, entities, tables, visit, known);
  records.attach([&](const ContactKey& key) -> const Friction<Dim>* {
    const auto at = std::lower_bound(
        known.begin(), known.end(), key,
        [](const Friction<Dim>& one, const ContactKey& wanted) { return one.key < wanted; });
    return at == known.end() || !(at->key == key) ? nullptr : &*at;
  });
  sum_tractions();
  load_growths(tables);
}

template <int Dim>
void ContactManager<Dim>::Implementation::save_growths(std::vector<StateTable>& tables) const {
  std::vector<std::size_t> grown;
  for (std::size_t f = 0; f < entities.faces.size(); ++f) {
    if (entities.faces[f].owned && entities.tractions[f].growth != 1) grown.push_back(f);
  }
  save_rows(
      kGrowths, grown.size(), [&](std::size_t k) { return entities.faces[grown[k]].id; },
      [&](auto& row, std::size_t k) { row(entities.tractions[grown[k]].growth); }, tables);
}

template <int Dim>
void ContactManager<Dim>::Implementation::load_growths(const StateTables& tables) {
  for (auto& traction : entities.tractions) traction.growth = 1;
  if (!tables.has(kGrowths)) return;
  const auto& rows = tables.rows(kGrowths);
  for (std::size_t f = 0; f < entities.faces.size(); ++f) {
    const auto& face = entities.faces[f];
    if (face.owned && rows.has(face.id)) entities.tractions[f].growth = rows.row(face.id, 1)[0];
  }
}

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
void ContactManager<Dim>::Implementation::begin_friction(Real dt) {
  if (!entities.nodes.has_friction) return;
  history.clear();
  records.visit_with_friction([&](const ContactRecord<Dim>&, const Friction<Dim>* friction) {
    if (friction != nullptr) history.add(*friction, entities.nodes, dt);
  });
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
  ended_heat = history.ended_heat();
  history.visit_ended([&](const FrictionMemory<Dim>& friction) {
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

template <int Dim>
void ContactManager<Dim>::Implementation::name_nodes() {
  records.name_nodes([&](ContactRecord<Dim>& record) {
    std::size_t n = 0;
    const auto add = [&](GlobalId id, bool particle, LocalIndex& place) {
      const std::size_t at = particle ? entities.particle_with(id) : entities.face_with(id);
      place = static_cast<LocalIndex>(at);
      if (particle) {
        record.node[n++] = entities.particles[at].node;
        return;
      }
      const auto& face = entities.faces[at];
      for (std::size_t c = 0; c < static_cast<std::size_t>(face.n_nodes); ++c) {
        record.node[n++] = face.node[c];
      }
    };
    add(record.first, record.of_particle, record.first_place);
    add(record.second, record.of_two_particles, record.second_place);
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

template void ContactManager<2>::check(Real, const Vec<2>&) const;
template void ContactManager<3>::check(Real, const Vec<3>&) const;
template struct ContactManager<2>::Implementation;
template struct ContactManager<3>::Implementation;

}  // namespace brunt
