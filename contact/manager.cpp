#include "contact/manager.hpp"

#include <cmath>
#include <utility>

#include "contact/implementation.hpp"

namespace brunt {

template <int Dim>
void ContactManager<Dim>::Implementation::evaluate(Real dt) {
  records.clear();
  const auto on_faces = candidates.faces();
  records.for_parts(on_faces.size(), kWorthThreads,
                    [&](std::size_t first, std::size_t last, auto& part) {
                      evaluate_faces<Dim>(entities, on_faces.subspan(first, last - first), section,
                                          part.face_on_face);
                    });
  const auto on_particles = candidates.particles();
  const auto starts = candidates.particle_starts();
  if (!starts.empty()) {
    records.for_parts(
        starts.size() - 1, kWorthThreads, [&](std::size_t first, std::size_t last, auto& part) {
          evaluate_particles<Dim>(entities, on_particles, starts.subspan(first, last - first + 1),
                                  section, dt, part);
        });
  }
  vote = entities.stiffness_vote();
  vote.take(records.vote());
}

template <int Dim>
ContactManager<Dim>::ContactManager(ContactOptions options, Geometry geometry,
                                    std::vector<Surface<Dim>*> surfaces,
                                    std::vector<std::string> body_names, Real depth)
    : implementation_(std::make_unique<Implementation>(options, Section{geometry, depth},
                                                       std::move(surfaces), body_names)) {
  rearrange();
}

template <int Dim>
ContactManager<Dim>::~ContactManager() = default;

template <int Dim>
StepVote ContactManager<Dim>::stable_step(Real) const {
  return implementation_->vote;
}

template <int Dim>
bool ContactManager<Dim>::must_rearrange(Real dt) const {
  const auto& own = *implementation_;
  return !own.candidates.will_be_complete(own.entities, own.surfaces, dt);
}

template <int Dim>
void ContactManager<Dim>::rearrange() {
  auto& own = *implementation_;
  Entities<Dim> fresh(own.surfaces, own.pairs, own.section);
  if (own.started) fresh.nodes.inherit(own.entities.nodes);
  own.entities = std::move(fresh);
  own.entities.refresh_planes();
  if (own.started) {
    own.candidates.build(own.entities, own.pairs, own.dt_last);
    return;
  }
  // The first votes: near is what the longest step that contact allows would bring near.
  const Real longest = own.entities.stiffness_vote().step;
  const Real dt = std::isfinite(longest) ? longest : 0.0;
  own.candidates.build(own.entities, own.pairs, dt);
  own.evaluate(dt);
  own.records.clear();
}

template <int Dim>
void ContactManager<Dim>::add_forces(Real dt) {
  auto& own = *implementation_;
  own.entities.nodes.read_motion(own.surfaces);
  own.entities.refresh_planes();
  if (!own.candidates.complete(own.entities, dt)) {
    own.candidates.build(own.entities, own.pairs, dt);
  }
  own.evaluate(dt);
  apply(own.records, dt, own.surfaces, own.entities.nodes);
  own.dt_last = dt;
  own.started = true;
}

template <int Dim>
void ContactManager<Dim>::add_totals(Totals<Dim>& totals) const {
  const auto& nodes = implementation_->entities.nodes;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    totals.add(Column::contact_spring, nodes.spring_energy[i]);
    totals.add(Column::contact_damping, nodes.damping_energy[i]);
    std::uint64_t hash = mix(mix(0, nodes.id[i]), static_cast<std::uint64_t>(nodes.surface[i]));
    hash = mix(mix(hash, nodes.spring_energy[i]), nodes.damping_energy[i]);
    for (int c = 0; c < Dim; ++c) hash = mix(mix(hash, nodes.spring[i][c]), nodes.damping[i][c]);
    totals.state_hash += hash;
  }
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
  return {own.candidates.builds(),
          own.candidates.faces().size() + own.candidates.particles().size(), own.records.size(),
          own.candidates.skin()};
}

template class ContactManager<2>;
template class ContactManager<3>;

}  // namespace brunt
