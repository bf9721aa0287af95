#include "app/scene/scene.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <stdexcept>

#include "core/boundaries/heat_step.hpp"
#include "core/gather_view.hpp"
#include "core/parallel/packing.hpp"

namespace brunt {

namespace {
constexpr const char* kHeatWindows = "heat windows";
}

template <int Dim>
StepLimit Scene<Dim>::stable_step(Real time, const StepLimit& of_heat) const {
  StepLimit step_limit;
  for (const auto& solid : solids) {
    step_limit.take(solid->stable_step());
  }
  step_limit.take(of_heat);
  if (contact) step_limit.take(contact->stable_step());
  if (rigid) step_limit.take(rigid->stable_step());
  step_limit.take(loads.stable_step(time));
  step_limit.take(boundaries.stable_step());
  return step_limit;
}

template <int Dim>
bool Scene<Dim>::conducts() const {
  return std::any_of(solids.begin(), solids.end(),
                     [](const auto& solid) { return solid->points().conducts; });
}

template <int Dim>
StepLimit Scene<Dim>::heat_step() const {
  StepLimit step_limit;
  for (const auto& solid : solids) {
    step_limit.take(brunt::heat_step(solid->points(), heat_windows.bounding_steps()));
  }
  return step_limit;
}

template <int Dim>
void Scene<Dim>::begin_heat(std::int64_t step, Real time, Real dt, Real bound) {
  const Real longest = heat_windows.bounding_steps() * bound;
  if (boundaries.switches_heat(time, time + dt)) heat_windows.restart(step);
  const bool due = heat_windows.is_due(step, dt, longest);
  if (due) heat_windows.begin(step, dt, longest);
  heat_windows.advance(dt);
  for (auto& solid : solids) {
    solid->points().evaluates_conduction = due;
    solid->points().conduction_steps = heat_windows.steps();
  }
}

template <int Dim>
void Scene<Dim>::add_heat(Real time, Real dt) {
  {
    const PhaseTimer timer(phases, Phase::points);
    boundaries.add_heat(time, dt);
  }
  for (auto& solid : solids) {
    const PhaseTimer timer(phases, solid->n_particles() ? Phase::particles : Phase::elements);
    solid->add_conduction(dt);
  }
  if (contact) {
    const PhaseTimer timer(phases, Phase::contact);
    contact->add_heat(dt);
  }
  const PhaseTimer timer(phases, Phase::points);
  boundaries.hold_temperatures(time, dt);
}

namespace {
/// Facets of boundaries on a surface that are no longer there.
template <int Dim>
void let_go(const std::vector<std::unique_ptr<Solid<Dim>>>& solids, Boundaries<Dim>& boundaries) {
  for (const auto& solid : solids) {
    if (solid->surface().changed) boundaries.keep_facets(solid->surface());
  }
}
}  // namespace

template <int Dim>
void Scene<Dim>::erode(Real dt) {
  for (auto& solid : solids) solid->erode(dt);
  let_go(solids, boundaries);
  if (contact) return;  // it looks at what has changed
  for (auto& solid : solids) solid->surface().changed = false;
}

template <int Dim>
void Scene<Dim>::refresh_motion() {
  if (ranks->alone()) return;
  for (auto& solid : solids) {
    auto& points = solid->points();
    const auto each_copied = [&](const auto& f) {
      Points<Dim>::visit_fields(points, copied_in(f));
    };
    std::size_t width = 0;
    each_copied([&](const auto& field) {
      width += width_of(typename std::remove_cvref_t<decltype(field)>::value_type{});
    });
    refresh_ghosts(
        *ranks, solid->ghosts(), width,
        [&](std::size_t i, Real* out) {
          each_copied([&](const auto& field) { out = write_value(field[i], out); });
        },
        [&](std::size_t i, const Real* in) {
          each_copied([&](auto& field) { in = read_value(in, field[i]); });
        });
  }
}

template <int Dim>
void Scene<Dim>::rearrange() {
  for (auto& solid : solids) solid->rearrange();
  if (contact) contact->rearrange();
}

namespace {
/// Part of the state hash of a point.
template <int Dim>
std::uint64_t point_hash(const Points<Dim>& points, std::size_t i) {
  EntityHash hash(points.id[i]);
  hash_values<Dim>(hash, [&](const auto& add) {
    Points<Dim>::visit_fields(points, [&](const auto& field, FieldUse use) { add(field[i], use); });
  });
  return hash.value();
}

/// Exact sums of owned points first .. last, all of one body.
template <int Dim>
void sum_points(const Points<Dim>& points, std::size_t first, std::size_t last, Real dt,
                Totals<Dim>& totals) {
  ExactColumns<4 + 2 * Dim> sums;
  for (std::size_t i = first; i < last; ++i) {
    const Real m = points.mass[i];
    const Real heat = points.conducts ? points.heat[i] : 0.0;
    if (m == 0) {
      if (heat != 0) sums.add({0, 0, 0, heat});
      continue;
    }
    // m v(n-1/2).v(n+1/2)/2, the kinetic energy that velocity Verlet keeps: docs/theory/ledger.md
    // (L2); as a product it is 0 to the last digit in the first step from rest
    const Vec<Dim> half = 0.5 * dt * points.a[i];
    const Real kinetic = 0.5 * m * (points.v[i] - half).dot(points.v[i] + half);
    std::array<Real, 4 + 2 * Dim> values{m, kinetic, points.integration[i], heat};
    for (int c = 0; c < Dim; ++c) {
      values[4 + c] = m * points.x[i][c];
      values[4 + Dim + c] = m * points.v[i][c];
    }
    sums.add(values);
  }
  auto& body = totals.bodies[points.body[first]];
  body.mass.add(sums.sum(0)), body.kinetic.add(sums.sum(1)), body.integration.add(sums.sum(2));
  for (std::size_t c = 0; c < Dim; ++c) {
    body.mass_position[c].add(sums.sum(4 + c)), body.momentum[c].add(sums.sum(4 + Dim + c));
  }
  if (!points.conducts) return;
  body.heat.add(sums.sum(3)), totals.heat.stored.add(sums.sum(3));
  ExactColumns<1> moved;
  for (std::size_t i = first; i < last; ++i) moved.add({std::fabs(points.heat[i])});
  totals.heat.moved.add(moved.sum(0));
}

/// Exact sums of owned points first .. last by body, and their part of the state hash.
template <int Dim>
void add_points(const Points<Dim>& points, std::size_t first, std::size_t last, Real dt,
                Totals<Dim>& totals) {
  for (std::size_t i = first; totals.hashes && i < last; ++i) {
    totals.state_hash += point_hash(points, i);
  }
  while (first < last) {
    std::size_t end = first + 1;
    while (end < last && points.body[end] == points.body[first]) ++end;
    sum_points(points, first, end, dt, totals);
    first = end;
  }
}

/// What is summed exactly, one after another: every sum that a row of history starts from.
template <int Dim, class Visit>
void visit_sums(Totals<Dim>& totals, const Visit& visit) {
  for (auto& column : totals.columns) visit(column);
  for (auto& body : totals.bodies) {
    for (auto* sum :
         {&body.mass, &body.kinetic, &body.internal, &body.hourglass, &body.heat, &body.stress_work,
          &body.viscosity, &body.absorbed, &body.artificial_stress, &body.integration}) {
      visit(*sum);
    }
    visit(body.tension), visit(body.artificial_tension), visit(body.thin_mass);
    visit(body.eroded), visit(body.eroded_mass);
    for (auto& sum : body.mass_position) visit(sum);
    for (auto& sum : body.momentum) visit(sum);
  }
  auto& heat = totals.heat;
  for (auto* sum : {&heat.stored, &heat.plastic, &heat.compression, &heat.friction, &heat.boundary,
                    &heat.moved}) {
    visit(*sum);
  }
}

template <int Dim>
void sum_over_ranks(Totals<Dim>& totals, const Communicator& ranks) {
  std::vector<ExactSum> sums;
  visit_sums(totals, [&](const ExactSum& sum) { sums.push_back(sum); });
  ranks.reduce_all(std::span(sums), [](ExactSum& a, const ExactSum& b) { a.add(b); });
  std::size_t next = 0;
  visit_sums(totals, [&](ExactSum& sum) { sum = sums[next++]; });
  totals.state_hash = ranks.sum(totals.state_hash);
}
}  // namespace

template <int Dim>
Totals<Dim> Scene<Dim>::totals(Real dt, bool hashes) const {
  Totals<Dim> totals;
  totals.hashes = hashes;
  totals.bodies.resize(body_names.size());
  for (const auto& solid : solids) {
    const auto& points = solid->points();
    const auto n = points.owned();
    add_in_shares(n, totals, [&](std::size_t first, std::size_t last, Totals<Dim>& part) {
      add_points(points, first, last, dt, part);
    });
    solid->add_totals(totals);
  }
  for (const auto& body : totals.bodies) {  // so far of points, once for both
    totals.columns[slot_of(Column::integration)].add(body.integration);
  }
  if (contact) contact->add_totals(totals);
  rigid_motions.add_totals(totals);
  boundaries.add_totals(totals);
  loads.add_totals(totals);
  if (rigid) rigid->add_totals(totals);
  if (rigid && ranks->is_root()) {
    rigid->add_body_totals(dt, totals);
    loads.add_rigid_totals(totals);
  }
  if (!ranks->alone()) sum_over_ranks(totals, *ranks);
  for (const auto& body : totals.bodies) totals.columns[0].add(body.kinetic);
  return totals;
}

template <int Dim>
std::string Scene<Dim>::advice(const StepLimit& step_limit) const {
  const std::string_view reason = step_limit.reason;
  if (reason == "contact stiffness" || reason == "contact speed") {
    return "contact: faces are deep in each other or very fast there; try finer elements, or a "
           "lower "
           "contact `stiffness`";
  }
  std::string mine;
  if (reason == "element") {  // particles and rigid bodies have numbers of their own
    for (const auto& solid : solids) {
      if (mine.empty()) mine = solid->advice(step_limit.entity);
    }
  }
  for (const Bytes& bytes : ranks->all_gather((Packer() << mine).take())) {
    std::string one;
    Unpacker(bytes) >> one;
    if (!one.empty()) return one;
  }
  return "look at the last frame for what collapsed there";
}

namespace {
/// Positions relative to the origin of a scene become absolute.
template <int Dim>
void shift(std::vector<Real>& position, const Vec<Dim>& origin) {
  for (std::size_t i = 0; i < position.size(); ++i) {
    const auto c = static_cast<int>(i % 3);
    if (c < Dim) position[i] += origin[c];
  }
}
}  // namespace

template <int Dim>
WantedFields Scene<Dim>::with_ids(WantedFields fields) const {
  if (fields.names && !ranks->alone()) fields.names->push_back("id");
  return fields;
}

template <int Dim>
BodyView Scene<Dim>::own_view(Label body, const WantedFields& wanted) const {
  const WantedFields fields = with_ids(wanted);
  BodyView view;
  for (const auto& solid : solids) {
    const auto& bodies = solid->points().body;
    if (std::find(bodies.begin(), bodies.end(), body) == bodies.end()) continue;
    view = solid->view(body, fields);
    break;
  }
  view.body = body_names[body];
  if (body < mirrors.size()) view.mirrors = mirrors[body];
  shift<Dim>(view.position, origin);
  return view;
}

template <int Dim>
BodyView Scene<Dim>::own_converted(Label body, const WantedFields& wanted) const {
  const WantedFields fields = with_ids(wanted);
  BodyView view;
  for (const auto& solid : solids) {
    const auto& bodies = solid->points().body;
    if (!solid->rides()) continue;
    if (std::find(bodies.begin(), bodies.end(), body) == bodies.end()) continue;
    view = solid->view(body, fields);
    break;
  }
  view.body = body_names[body] + ".particles";
  shift<Dim>(view.position, origin);
  return view;
}

template <int Dim>
BodyView Scene<Dim>::view(Label body, const WantedFields& wanted) const {
  BodyView view = gather_view(own_view(body, wanted), *ranks);
  if (body < mirrors.size()) view.mirrors = mirrors[body];
  return view;
}

template <int Dim>
ContactView Scene<Dim>::own_contacts() const {
  ContactView view = contact->view();
  shift<Dim>(view.position, origin);
  return view;
}

template <int Dim>
void Scene<Dim>::save_state(std::vector<StateTable>& tables) const {
  for (const auto& solid : solids) solid->save_state(tables);
  rigid_motions.save_state(tables);
  boundaries.save_state(tables);
  if (rigid) rigid->save_state(tables);
  loads.save_state(tables);
  if (contact) contact->save_state(tables);
  if (!conducts()) return;
  save_row(
      kHeatWindows, [&](auto& row) { HeatWindows::visit(row, heat_windows); }, tables);
}

template <int Dim>
void Scene<Dim>::load_state(const StateTables& tables) {
  for (auto& solid : solids) solid->load_state(tables);
  for (auto& solid : solids) solid->rearrange();
  let_go(solids, boundaries);
  rigid_motions.load_state(tables);
  boundaries.load_state(tables);
  if (rigid) rigid->load_state(tables);
  loads.load_state(tables);
  if (contact) contact->load_state(tables);
  if (!conducts()) return;
  load_row(
      kHeatWindows, [&](auto& row) { HeatWindows::visit(row, heat_windows); }, tables);
  for (auto& solid : solids) solid->points().conduction_steps = heat_windows.steps();
}

template <int Dim>
std::size_t Scene<Dim>::n_points() const {
  std::size_t n = 0;
  for (const auto& solid : solids) n += slot_of(solid->points().n_owned);
  return ranks->sum(n);
}

template <int Dim>
std::size_t Scene<Dim>::n_elements() const {
  std::size_t n = 0;
  for (const auto& solid : solids) n += solid->n_elements();
  return ranks->sum(n);
}

template <int Dim>
std::size_t Scene<Dim>::n_particles() const {
  std::size_t n = 0;
  for (const auto& solid : solids) n += solid->n_particles();
  return ranks->sum(n);
}

template struct Scene<2>;
template struct Scene<3>;

}  // namespace brunt
