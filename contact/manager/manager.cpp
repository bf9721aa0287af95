#include "contact/manager/manager.hpp"

#include <algorithm>
#include <utility>

#include "contact/manager/implementation.hpp"
#include "contact/surfaces/own_springs.hpp"

namespace brunt {

namespace {
/// Friction between particles needs to know how the material about them turns; some friction, how
/// hot and hard what slides is.
template <int Dim>
void set_needs(const std::vector<Surface<Dim>*>& surfaces, const PairTable& pairs) {
  for (auto* surface : surfaces) {
    surface->needs_spin = pairs.particles_have_friction();
    surface->needs_material = pairs.needs_material();
  }
}

/// Ids of the facets that went in the step under way, ascending.
template <int Dim>
std::vector<GlobalId> dead_of(const std::vector<Surface<Dim>*>& surfaces) {
  std::vector<GlobalId> died;
  for (const auto* surface : surfaces) {
    died.insert(died.end(), surface->died.begin(), surface->died.end());
  }
  std::sort(died.begin(), died.end());
  return died;
}
}  // namespace

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
  implementation_ = std::make_unique<Implementation>(ContactSetup<Dim>{
      options, {geometry, depth}, ContactRanks{}, std::move(surfaces), std::move(pairs)});
  auto& [setup, search, evaluation, memory, friction_check, last] = *implementation_;
  setup.rigid = springs_of_rigid<Dim>(setup.pairs, setup.section, search.entities());
  search.take_rigid();
  implementation_->begin(Tables::kept);
}

template <int Dim>
ContactManager<Dim>::ContactManager(const ContactManager& whole,
                                    std::vector<Surface<Dim>*> surfaces, const Partition& partition,
                                    const Communicator& ranks) {
  ContactSetup<Dim> setup = whole.implementation_->setup;
  set_needs(surfaces, setup.pairs);
  setup.ranks = {&ranks, &partition};
  setup.surfaces = std::move(surfaces);
  implementation_ = std::make_unique<Implementation>(std::move(setup));
  implementation_->begin(Tables::kept);
}

template <int Dim>
void ContactManager<Dim>::Implementation::begin(Tables tables) {
  const LookAhead ahead = search.begin(tables);
  evaluation.run(setup, search, 0, ahead, memory.step(true), nullptr);
  memory.begin(evaluation.records());
  evaluation.records().clear();
}

template <int Dim>
ContactManager<Dim>::~ContactManager() = default;

template <int Dim>
StepLimit ContactManager<Dim>::stable_step() const {
  StepLimit step_limit = implementation_->evaluation.step_limit();
  step_limit.take(implementation_->friction_check.step_limit());
  return step_limit;
}

template <int Dim>
void ContactManager<Dim>::rearrange() {
  auto& [setup, search, evaluation, memory, friction_check, last] = *implementation_;
  if (last.started) {
    search.renew(last.ahead, Tables::inherited, false);
    evaluation.records().name_nodes(search.entities());
    return;
  }
  implementation_->begin(Tables::anew);
}

template <int Dim>
void ContactManager<Dim>::renew_lists(Real dt) {
  auto& [setup, search, evaluation, memory, friction_check, last] = *implementation_;
  // Refresh: where everything is, and what contacts carry into this step.
  search.refresh_motion();
  memory.begin_step(evaluation.records(), search.entities().nodes, dt);
  memory.bury(dead_of(setup.surfaces));
  book_eroded(evaluation.records(), memory.died(), dt, search.entities().nodes);
  // Search: lists anew where they may miss a contact.
  last.listed = search.renew_if_needed(dt);
}

template <int Dim>
void ContactManager<Dim>::add_forces(Real dt, Real time) {
  auto& [setup, search, evaluation, memory, friction_check, last] = *implementation_;
  if (!last.listed) renew_lists(dt);
  const LookAhead ahead = *last.listed;
  auto& entities = search.entities();
  search.refresh_friction();
  // Evaluate what is listed.
  const auto& records = evaluation.records();
  evaluation.run(setup, search, dt, ahead, memory.step(), &memory.past());
  search.end_births();
  // Exchange with the ranks whose nodes are moved, and apply.
  const auto elsewhere = search.imports().send_home(records, entities.nodes);
  apply<Dim>(records, elsewhere, dt, setup.surfaces, entities.nodes);
  // Remember.
  memory.end_step(records, entities, dt, time);
  if (entities.nodes.has_friction) friction_check.clear();
  if (entities.nodes.has_friction && search.any_near()) {
    book_friction<Dim>(records, memory.past(), memory.died(), setup.pairs,
                       search.imports().send_tractions(records, entities), friction_check,
                       entities);
  }
  if (setup.pairs.holds()) book_losses(records, entities);
  last = {dt, ahead.time, true, std::nullopt};
}

template <int Dim>
void ContactManager<Dim>::add_heat(Real dt) {
  auto& [setup, search, evaluation, memory, friction_check, last] = *implementation_;
  auto& nodes = search.entities().nodes;
  if (!nodes.conduct || !search.any_near()) return;
  if (setup.pairs.passes_heat()) {
    nodes.predict_temperatures(setup.surfaces, dt);
    search.imports().refresh_temperatures(nodes.temperature);
  }
  evaluation.complete_pair_heat(setup, search);
  const auto& surfaces = setup.surfaces;
  evaluation.records().change_heat(
      [&](HeatFlow<Dim>& flow) { exchange_heat<Dim>(nodes, surfaces, dt, flow); });
  auto ended = memory.past().ended_heat();
  const auto elsewhere = search.imports().send_heat(evaluation.records(), nodes, ended);
  apply_heat<Dim>(evaluation.records(), elsewhere, setup.surfaces, nodes);
  if (!(dt > 0)) return;
  for (const auto& one : ended) {
    auto& points = *setup.surfaces[slot_of(one.surface)]->points;
    points.heat_rate[slot_of(points.find(one.point))] += one.heat / dt;
  }
}

template <int Dim>
void ContactManager<Dim>::check(Real time, const Vec<Dim>& origin) const {
  implementation_->friction_check.check(time, origin);
}

template class ContactManager<2>;
template class ContactManager<3>;

}  // namespace brunt
