#include "contact/manager/search.hpp"

#include <algorithm>
#include <utility>

namespace brunt {

namespace {
/// How much longer than the last a step may be where particles look ahead for what is near. That is
/// a step limit: of less than half a step's it leaves room for twice the step.
Real step_growth(Real safety) { return std::max(4.0, 2 / safety); }
/// How much longer than the last a step may be where pairs of faces are watched: what they pressed
/// has bounced off, and what is behind may push them together again before anybody sees it.
constexpr Real kWatchedGrowth = 1.02;

template <int Dim>
Entities<Dim> entities_of(const ContactSetup<Dim>& setup) {
  return Entities<Dim>(setup.surfaces, setup.pairs, setup.section, setup.ranks, setup.rigid);
}
}  // namespace

template <int Dim>
ContactSearch<Dim>::ContactSearch(const ContactSetup<Dim>& setup)
    : setup_(setup),
      entities_(entities_of(setup)),
      imports_(setup.ranks, setup.surfaces),
      candidates_(setup.options.search, setup.options.skin) {}

template <int Dim>
void ContactSearch<Dim>::take_rigid() {
  if (!setup_.rigid.neighbours.empty()) entities_ = entities_of(setup_);
}

template <int Dim>
void ContactSearch<Dim>::refresh_motion() {
  entities_.nodes.read_motion(setup_.surfaces);
  imports_.refresh_motion(entities_.nodes);
  entities_.refresh_planes();
}

template <int Dim>
void ContactSearch<Dim>::refresh_friction() {
  imports_.refresh_tractions(entities_);
  entities_.refresh_sides();
  auto& nodes = entities_.nodes;
  if (!nodes.needs_material) return;
  entities_.read_materials(setup_.surfaces);
  imports_.refresh_materials(entities_.materials);
  nodes.read_temperatures(setup_.surfaces);
  imports_.refresh_temperatures(nodes.temperature);
}

template <int Dim>
StepLimit ContactSearch<Dim>::longest_after(Real dt) const {
  StepLimit longest = entities_.stiffness_limit();
  longest.take(setup_.rigid.step_limit);
  if (dt > 0 && setup_.pairs.watched() && !entities_.faces.empty()) {
    const auto& first = entities_.faces.front();
    const Real grown = kWatchedGrowth / setup_.options.safety * dt;
    longest.take({grown, "contact look-ahead", first.body, first.id});
  }
  if (dt > 0 && !entities_.particles.empty()) {
    const auto& first = entities_.particles.front();
    const Real grown = step_growth(setup_.options.safety) * dt;
    longest.take({grown, "contact look-ahead", first.body, first.id});
  }
  return longest;
}

template <int Dim>
LookAhead ContactSearch<Dim>::look_ahead(Real dt) const {
  const StepLimit longest = longest_after(dt);
  if (dt > 0) return {longest, step_growth(setup_.options.safety) * dt};
  // Where nothing is near no face bounds the step: the elements behind them do.
  const Real mine = std::min(longest.step, entities_.longest_step);
  return {longest, -setup_.ranks.all->max(-mine)};
}

template <int Dim>
LookAhead ContactSearch<Dim>::renew_if_needed(Real dt) {
  const bool changed = take_changes();
  LookAhead ahead = look_ahead(dt);
  const bool complete = candidates_.complete(entities_, ahead.time, *setup_.ranks.all);
  const Real speed = candidates_.speed();
  // Without a step nobody knows how points have come to where they are.
  const bool look = near_.needs_look(speed * dt, speed * ahead.time) || dt == 0;
  const bool others = look && find_near_bodies(ahead.time);
  if (others || !complete || changed) {
    renew(ahead.time, changed ? Tables::inherited : Tables::kept, true);
    // What other ranks show has come without its motion.
    if (!setup_.ranks.all->alone()) refresh_motion();
    ahead.longest = longest_after(dt);
  }
  return ahead;
}

template <int Dim>
bool ContactSearch<Dim>::take_changes() {
  bool changed = false;
  for (auto* surface : setup_.surfaces) {
    changed = changed || surface->changed;
    surface->changed = false;
  }
  return changed;
}

template <int Dim>
void ContactSearch<Dim>::take_surfaces() {
  if (take_changes()) entities_ = entities_of(setup_);
}

template <int Dim>
LookAhead ContactSearch<Dim>::begin(Tables tables) {
  entities_.refresh_planes();
  const Real ahead = look_ahead(0).time;
  renew(ahead, tables, false);
  if (find_near_bodies(ahead)) renew(ahead, Tables::kept, false);
  return {longest_after(0), ahead};
}

template <int Dim>
void ContactSearch<Dim>::renew(Real ahead, Tables tables, bool with_motion) {
  // Where nothing came or went, tables made anew would hold what is there, but for what other ranks
  // show.
  const bool keeps = tables == Tables::kept, alone = setup_.ranks.all->alone();
  CarriedTractions<Dim> carried;
  if (tables == Tables::inherited || !alone) carried = entities_.carried_tractions();
  if (keeps) {
    entities_.begin_motion(setup_.surfaces);
  } else {
    ContactNodes<Dim> before;
    if (tables == Tables::inherited) before = std::move(entities_.nodes);
    entities_ = {};  // old tables and new ones side by side would be the most memory of a run
    entities_ = entities_of(setup_);
    if (tables == Tables::inherited) entities_.nodes.inherit(before);
  }
  entities_.longest_step = std::min(entities_.longest_step, setup_.rigid.step_limit.step);
  entities_.choose(near_.near());
  if (with_motion) entities_.nodes.read_motion(setup_.surfaces);
  entities_.refresh_planes();
  candidates_.build(entities_, setup_.pairs, ahead, imports_);
  if (tables == Tables::inherited || (keeps && !alone)) entities_.inherit_tractions(carried);
}

/// Finds the bodies that may touch others; true where they are not the same as before. Collective.
template <int Dim>
bool ContactSearch<Dim>::find_near_bodies(Real ahead) {
  return near_.look(setup_.surfaces, entities_, setup_.pairs, candidates_.speed() * ahead,
                    *setup_.ranks.all);
}

template <int Dim>
void ContactSearch<Dim>::end_births() {
  if (!entities_.any_born) return;
  entities_.end_births();
  for (auto* surface : setup_.surfaces) {
    for (auto& facet : surface->facets) facet.born = false;
    for (auto& particle : surface->particles) particle.born = false;
  }
}

template <int Dim>
void ContactSearch<Dim>::sum_tractions(const Records<Dim>& records) {
  TractionSum<Dim> sum(entities_, imports_.send_tractions(records, entities_));
  records.visit_with_friction([&](const ContactRecord<Dim>& record, const Friction<Dim>* friction) {
    if (friction != nullptr) sum.add(record, *friction);
  });
  sum.finish();
}

template class ContactSearch<2>;
template class ContactSearch<3>;

}  // namespace brunt
// Tested by tests/unit/contact/rebuild_test.cpp.
