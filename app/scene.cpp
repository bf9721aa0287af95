#include "app/scene.hpp"

#include <omp.h>

#include <stdexcept>

namespace brunt {

template <int Dim>
StepVote Scene<Dim>::stable_step(Real time, Real dt_last) const {
  StepVote vote;
  for (const auto& solid : solids) vote.take(solid->stable_step());
  if (contact) vote.take(contact->stable_step(dt_last));
  vote.take(loads.stable_step(time));
  return vote;
}

template <int Dim>
bool Scene<Dim>::must_rearrange(Real dt) const {
  for (const auto& solid : solids) {
    if (solid->must_rearrange(dt)) return true;
  }
  return contact && contact->must_rearrange(dt);
}

template <int Dim>
void Scene<Dim>::rearrange() {
  for (auto& solid : solids) solid->rearrange();
  if (contact) contact->rearrange();
}

namespace {
/// Exact sums of owned points first .. last by body, and their part of the state hash.
template <int Dim>
void add_points(const Points<Dim>& points, std::size_t first, std::size_t last, Real dt,
                Totals<Dim>& totals) {
  const Real correction = 0.25 * dt * dt;
  for (std::size_t i = first; i < last; ++i) {
    auto& body = totals.bodies[points.body[i]];
    const Real m = points.mass[i];
    std::uint64_t hash = mix(0, points.id[i]);
    for (int c = 0; c < Dim; ++c) {
      hash = mix(hash, points.x[i][c]);
      hash = mix(hash, points.v[i][c]);
      hash = mix(hash, points.a[i][c]);
    }
    totals.state_hash += hash;
    if (m == 0) continue;
    body.mass.add(m);
    for (int c = 0; c < Dim; ++c) {
      body.mass_position[c].add(m * points.x[i][c]);
      body.momentum[c].add(m * points.v[i][c]);
    }
    // m v(n-1/2).v(n+1/2)/2, the kinetic energy that velocity Verlet keeps (physics.md D)
    body.kinetic.add(0.5 * m *
                     (points.v[i].squaredNorm() - correction * points.a[i].squaredNorm()));
    totals.add(Column::integration, points.integration[i]);
  }
}

template <int Dim>
void merge(Totals<Dim>& into, const Totals<Dim>& from) {
  for (std::size_t c = 0; c < into.columns.size(); ++c) into.columns[c].add(from.columns[c]);
  for (std::size_t b = 0; b < into.bodies.size(); ++b) {
    auto& sum = into.bodies[b];
    const auto& part = from.bodies[b];
    sum.mass.add(part.mass), sum.kinetic.add(part.kinetic), sum.internal.add(part.internal);
    sum.hourglass.add(part.hourglass), sum.heat.add(part.heat);
    for (int c = 0; c < Dim; ++c) {
      sum.mass_position[c].add(part.mass_position[c]);
      sum.momentum[c].add(part.momentum[c]);
    }
  }
  into.state_hash += from.state_hash;
}
}  // namespace

template <int Dim>
Totals<Dim> Scene<Dim>::totals(Real dt) const {
  Totals<Dim> totals;
  totals.bodies.resize(body_names.size());
  for (const auto& solid : solids) {
    const auto& points = solid->points();
    const auto n = static_cast<std::size_t>(points.n_owned);
    // Exact sums may be cut anywhere, so each thread takes a share.
#pragma omp parallel
    {
      Totals<Dim> part;
      part.bodies.resize(body_names.size());
      const auto threads = static_cast<std::size_t>(omp_get_num_threads());
      const auto thread = static_cast<std::size_t>(omp_get_thread_num());
      add_points(points, n * thread / threads, n * (thread + 1) / threads, dt, part);
#pragma omp critical
      merge(totals, part);
    }
    solid->add_totals(totals);
  }
  for (const auto& body : totals.bodies) totals.columns[0].add(body.kinetic);
  if (contact) contact->add_totals(totals);
  supports.add_totals(totals);
  loads.add_totals(totals);
  return totals;
}

template <int Dim>
void Scene<Dim>::check(Real time) const {
  // Elements and particles first: an inverted element is why its points are no numbers.
  for (const auto& solid : solids) solid->check(time, body_names);
  for (const auto& solid : solids) {
    const auto& points = solid->points();
    for (std::size_t i = 0; i < points.x.size(); ++i) {
      // One test finds NaN and infinity in either vector.
      const Real sum = points.x[i].sum() + points.v[i].sum();
      if (sum - sum == 0) continue;
      throw PhysicsError({time, body_names[points.body[i]], "point " + std::to_string(points.id[i]),
                          "position or velocity", sum,
                          "it is not a finite number any more: try a smaller time.safety, and look "
                          "at the last frame for an element or particle that collapsed"});
    }
  }
}

template <int Dim>
BodyView Scene<Dim>::view(Label body) const {
  for (const auto& solid : solids) {
    for (const Label label : solid->points().body) {
      if (label == body) {
        BodyView view = solid->view(body);
        view.body = body_names[body];
        for (std::size_t i = 0; i < view.position.size(); ++i) {
          const auto c = static_cast<int>(i % 3);
          if (c < Dim) view.position[i] += origin[c];
        }
        return view;
      }
    }
  }
  throw std::logic_error("a body without points");
}

template <int Dim>
void Scene<Dim>::save_state(std::vector<StateTable>& tables) const {
  for (const auto& solid : solids) solid->save_state(tables);
  supports.save_state(tables);
  loads.save_state(tables);
  if (contact) contact->save_state(tables);
}

template <int Dim>
void Scene<Dim>::load_state(const StateTables& tables) {
  for (auto& solid : solids) solid->load_state(tables);
  for (auto& solid : solids) solid->rearrange();
  supports.load_state(tables);
  loads.load_state(tables);
  if (contact) contact->load_state(tables);
}

template <int Dim>
std::size_t Scene<Dim>::n_points() const {
  std::size_t n = 0;
  for (const auto& solid : solids) n += static_cast<std::size_t>(solid->points().n_owned);
  return n;
}

template <int Dim>
std::size_t Scene<Dim>::n_elements() const {
  std::size_t n = 0;
  for (const auto& solid : solids) n += solid->n_elements();
  return n;
}

template <int Dim>
std::size_t Scene<Dim>::n_particles() const {
  std::size_t n = 0;
  for (const auto& solid : solids) n += solid->n_particles();
  return n;
}

template struct Scene<2>;
template struct Scene<3>;

}  // namespace brunt
