#include "contact/manager/manager.hpp"

#include <algorithm>
#include <utility>

#include "contact/manager/implementation.hpp"
#include "contact/surfaces/own_springs.hpp"

namespace brunt {

namespace {
/// How much longer than the last a step may be where particles look ahead for what is near. That is
/// a step limit: of less than half a step's it leaves room for twice the step.
Real step_growth(Real safety) { return std::max(4.0, 2 / safety); }

/// Friction between particles needs to know how the material about them turns; some friction, how
/// hot and hard what slides is.
template <int Dim>
void set_needs(const std::vector<Surface<Dim>*>& surfaces, const PairTable& pairs) {
  for (auto* surface : surfaces) {
    surface->needs_spin = pairs.particles_have_friction();
    surface->needs_material = pairs.needs_material();
  }
}
}  // namespace

template <int Dim>
void ContactManager<Dim>::Implementation::take_rigid(const RigidSprings& of_scene) {
  rigid = of_scene;
  if (!rigid.neighbours.empty()) {
    entities = Entities<Dim>(surfaces, pairs, section, ranks, rigid);
  }
}

template <int Dim>
StepLimit ContactManager<Dim>::Implementation::longest_after(Real dt) const {
  StepLimit longest = entities.stiffness_limit();
  longest.take(rigid.step_limit);
  if (dt > 0 && !entities.particles.empty()) {
    const auto& first = entities.particles.front();
    longest.take({step_growth(options.safety) * dt, "contact look-ahead", first.body, first.id});
  }
  return longest;
}

template <int Dim>
Real ContactManager<Dim>::Implementation::look_ahead(Real dt, const StepLimit& longest) const {
  if (dt > 0) return step_growth(options.safety) * dt;
  // Where nothing is near no face bounds the step: the elements behind them do.
  return -ranks.all->max(-std::min(longest.step, entities.longest_step));
}

template <int Dim>
bool ContactManager<Dim>::Implementation::find_near_bodies(Real ahead) {
  return near.look(surfaces, entities, pairs, candidates.speed() * ahead, *ranks.all);
}

template <int Dim>
void ContactManager<Dim>::Implementation::renew(Real ahead, bool with_motion) {
  Entities<Dim> fresh(surfaces, pairs, section, ranks, rigid);
  if (started) fresh.nodes.inherit(entities.nodes);
  std::swap(entities, fresh);
  entities.longest_step = std::min(entities.longest_step, rigid.step_limit.step);
  entities.choose(near.near());
  if (with_motion) entities.nodes.read_motion(surfaces);
  entities.refresh_planes();
  candidates.build(entities, pairs, ahead, imports);
  if (started) entities.inherit_tractions(fresh);
}

template <int Dim>
void ContactManager<Dim>::Implementation::evaluate(Real dt, const StepLimit& longest, Real ahead,
                                                   FrictionHistory<Dim>* past) {
  records.clear();
  const bool repeated = past == nullptr;
  const EvaluationStep step{dt,
                            ahead,
                            {&memory.touches(), repeated && !started, repeated && started},
                            entities.longest_step,
                            rigid.step_limit.step,
                            candidates.way_of_faces(entities) > 0};
  const auto on_faces = candidates.faces();
  if (!on_faces.empty()) entities.refresh_reaches();
  records.for_parts(on_faces.size(), kWorthThreads,
                    [&](std::size_t first, std::size_t last, auto& part) {
                      evaluate_faces<Dim>(entities, on_faces.subspan(first, last - first), section,
                                          step, past, part);
                    });
  const auto rows = candidates.pair_starts();
  loads.assign(rows.empty() ? 0 : entities.particles.size(), {});
  sides.assign(entities.nodes.conduct ? candidates.pairs().size() : 0, {});
  const ParticleRows beside_faces = candidates.particle_rows(pairs, ahead);
  if (!beside_faces.row_clearances.empty()) {
    records.for_parts(beside_faces.row_clearances.size(), kWorthThreads,
                      [&](std::size_t first, std::size_t last, auto& part) {
                        evaluate_particles<Dim>(entities, beside_faces.part(first, last), section,
                                                step, past, loads, part);
                      });
  }
  if (!rows.empty()) {
    records.for_parts(rows.size() - 1, kWorthThreads,
                      [&](std::size_t first, std::size_t last, auto& part) {
                        const PairRows chosen{candidates.pairs(),
                                              rows.subspan(first, last - first + 1), loads, sides};
                        evaluate_pairs<Dim>(entities, chosen, section, step, past, part);
                      });
  }
  memory.keep_touches(records);
  step_limit = longest;
  step_limit.take(records.step_limit());
}

template <int Dim>
ContactManager<Dim>::ContactManager(ContactOptions options, Geometry geometry,
                                    std::vector<Surface<Dim>*> surfaces,
                                    std::vector<std::string> body_names, Real depth) {
  PairTable pairs(options, surfaces, body_names);
  if (!options.gravity.empty()) {
    const Vec<Dim> gravity = Eigen::Map<const Vec<Dim>>(options.gravity.data());
    pairs.lay(resting_bodies<Dim>(surfaces, {geometry, depth}, gravity), gravity.norm());
  }
  set_needs(surfaces, pairs);
  implementation_ = std::make_unique<Implementation>(
      options, Section{geometry, depth}, std::move(pairs), std::move(surfaces), ContactRanks{});
  auto& own = *implementation_;
  own.take_rigid(springs_of_rigid<Dim>(own.pairs, own.section, own.entities));
  rearrange();
}

template <int Dim>
ContactManager<Dim>::ContactManager(const ContactManager& whole,
                                    std::vector<Surface<Dim>*> surfaces, const Partition& partition,
                                    const Communicator& ranks) {
  const auto& own = *whole.implementation_;
  set_needs(surfaces, own.pairs);
  implementation_ = std::make_unique<Implementation>(
      own.options, own.section, own.pairs, std::move(surfaces), ContactRanks{&ranks, &partition});
  implementation_->take_rigid(own.rigid);
  rearrange();
}

template <int Dim>
ContactManager<Dim>::~ContactManager() = default;

template <int Dim>
StepLimit ContactManager<Dim>::stable_step(Real) const {
  return implementation_->step_limit;
}

template <int Dim>
void ContactManager<Dim>::rearrange() {
  auto& own = *implementation_;
  if (own.started) {
    own.renew(own.ahead_last, false);
    own.records.name_nodes(own.entities);
    return;
  }
  own.entities.refresh_planes();
  const Real ahead = own.look_ahead(0, own.longest_after(0));
  own.renew(ahead, false);
  if (own.find_near_bodies(ahead)) own.renew(ahead, false);
  own.evaluate(0, own.longest_after(0), ahead, nullptr);
  own.records.clear();
}

template <int Dim>
void ContactManager<Dim>::start() {
  auto& own = *implementation_;
  if (own.started || !own.pairs.presses()) return;
  own.evaluate(0, own.step_limit, own.ahead_last, nullptr);
  own.press_at_start();  // row 0 of a history reads the records that are left
}

template <int Dim>
void ContactManager<Dim>::add_forces(Real dt, Real time) {
  auto& own = *implementation_;
  auto& nodes = own.entities.nodes;
  const auto read_motion = [&] {
    nodes.read_motion(own.surfaces);
    own.imports.refresh_motion(nodes);
    own.entities.refresh_planes();
  };
  read_motion();
  own.memory.begin_step(own.records, nodes, dt);
  StepLimit longest = own.longest_after(dt);
  const Real ahead = own.look_ahead(dt, longest);
  {
    const WallTimer timer(own.list_time, *own.ranks.all);
    const bool complete = own.candidates.complete(own.entities, ahead, *own.ranks.all);
    const Real speed = own.candidates.speed();
    // Without a step nobody knows how points have come to where they are.
    const bool look = own.near.due(speed * dt, speed * ahead) || dt == 0;
    const bool others = look && own.find_near_bodies(ahead);
    if (others || !complete) {
      own.renew(ahead, true);
      read_motion();
      longest = own.longest_after(dt);
    }
  }
  own.imports.refresh_tractions(own.entities);
  own.read_materials();
  own.evaluate(dt, longest, ahead, &own.memory.past());
  own.memory.keep_lost(own.records, own.entities, dt, time);
  const auto elsewhere = own.imports.send_home(own.records, nodes);
  apply<Dim>(own.records, elsewhere, dt, own.surfaces, nodes);
  own.end_friction();
  own.dt_last = dt;
  own.ahead_last = ahead;
  own.started = true;
}

template <int Dim>
WallTime ContactManager<Dim>::take_list_time() {
  return std::exchange(implementation_->list_time, {});
}

template <int Dim>
void ContactManager<Dim>::add_heat(Real dt) {
  auto& own = *implementation_;
  auto& nodes = own.entities.nodes;
  if (!nodes.conduct || !own.near.any()) return;
  nodes.predict_temperatures(own.surfaces, dt);
  own.imports.refresh_temperatures(nodes.temperature);
  own.complete_pair_heat();
  own.records.change_heat(
      [&](HeatFlow<Dim>& flow) { exchange_heat<Dim>(nodes, own.surfaces, dt, flow); });
  const auto elsewhere = own.imports.send_heat(own.records, nodes, own.ended_heat);
  apply_heat<Dim>(own.records, elsewhere, own.surfaces, nodes);
  if (!(dt > 0)) return;
  for (const auto& ended : own.ended_heat) {
    auto& points = *own.surfaces[static_cast<std::size_t>(ended.surface)]->points;
    points.heat_rate[static_cast<std::size_t>(points.find(ended.point))] += ended.heat / dt;
  }
}

template <int Dim>
void ContactManager<Dim>::add_totals(Totals<Dim>& totals) const {
  const auto& nodes = implementation_->entities.nodes;
  const auto add = [&](std::size_t first, std::size_t last, Totals<Dim>& part) {
    for (std::size_t i = first; i < last; ++i) {
      if (!nodes.owned[i]) continue;
      part.add(Column::contact_pairs, nodes.spring_work[i]);
      part.add(Column::contact_damping, nodes.damping_energy[i]);
      EntityHash hash(nodes.id[i]);
      hash.add(static_cast<std::uint64_t>(nodes.surface[i]));
      hash.add(nodes.spring_work[i]);
      hash.add(nodes.damping_energy[i]);
      for (int c = 0; c < Dim; ++c) hash.add(nodes.spring[i][c]), hash.add(nodes.damping[i][c]);
      part.state_hash += hash.value();
      if (nodes.conduct) part.heat.friction.add(nodes.friction_given[i]);
      if (!nodes.has_friction) continue;
      part.add(Column::contact_friction, nodes.friction_heat[i]);
      part.add(Column::contact_spring, nodes.friction_stored[i]);
      part.add(Column::contact_damping, nodes.friction_damped[i]);
      part.add(Column::contact_pairs, nodes.pair_energy[i]);
    }
  };
  add_in_shares(nodes.size(), totals, add);
  // Springs hold what their overlaps say. What their forces have taken from motion beyond that went
  // with contacts that began or ended in the middle of it, or changed in place, area or direction.
  implementation_->records.visit([&](const ContactRecord<Dim>& record) {
    totals.add(Column::contact_spring, record.stored);
    totals.add(Column::contact_pairs, -record.stored);
  });
  totals.state_hash += implementation_->memory.hash(implementation_->records);
}

template <int Dim>
std::size_t ContactManager<Dim>::n_pairs() const {
  return implementation_->pairs.pairs().size();
}

template <int Dim>
std::size_t ContactManager<Dim>::n_facets() const {
  std::size_t n = 0;
  for (const auto* surface : implementation_->surfaces) n += surface->facets.size();
  return n;
}

template <int Dim>
ContactWork ContactManager<Dim>::work() const {
  const auto& own = *implementation_;
  return {
      own.candidates.builds(),
      own.candidates.faces().size() + own.candidates.n_particles() + own.candidates.pairs().size(),
      own.records.size(), own.candidates.skin(), own.entities.near_faces.size()};
}

template <int Dim>
std::vector<std::vector<Real>> ContactManager<Dim>::point_work() const {
  // [ns] of a candidate, near or far alike (docs/performance.md); only their ratio matters.
  constexpr Real kFacePair = 1500, kParticleOnFace = 400, kParticlePair = 50;
  const auto& own = *implementation_;
  const auto& nodes = own.entities.nodes;
  std::vector<std::vector<Real>> work;
  for (const auto* surface : own.surfaces) {
    work.emplace_back(static_cast<std::size_t>(surface->points->n_owned), 0.0);
  }
  const auto add = [&](LocalIndex node, Real cost) {
    const auto i = static_cast<std::size_t>(node);
    if (!nodes.owned[i] || nodes.point[i] < 0) return;
    auto& of_surface = work[static_cast<std::size_t>(nodes.surface[i])];
    const auto point = static_cast<std::size_t>(nodes.point[i]);
    if (point < of_surface.size()) of_surface[point] += cost;
  };
  for (const auto& pair : own.candidates.faces()) {
    const auto& face = own.entities.faces[static_cast<std::size_t>(pair.lower)];
    for (int c = 0; c < face.n_nodes; ++c) {
      add(face.node[static_cast<std::size_t>(c)], kFacePair / face.n_nodes);
    }
  }
  const ParticleRows rows = own.candidates.particle_rows(own.pairs, own.ahead_last);
  for (std::size_t row = 0; row < rows.row_clearances.size(); ++row) {
    const auto [first, last] = rows.range(row);
    const auto particle = static_cast<std::size_t>(rows.row_clearances[row].entity);
    add(own.entities.particles[particle].node, kParticleOnFace * static_cast<Real>(last - first));
  }
  for (const auto& pair : own.candidates.pairs()) {
    add(own.entities.particles[static_cast<std::size_t>(pair.particle)].node, kParticlePair);
  }
  return work;
}

template class ContactManager<2>;
template class ContactManager<3>;

}  // namespace brunt
