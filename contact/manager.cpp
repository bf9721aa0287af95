#include "contact/manager.hpp"

#include <utility>

#include "contact/implementation.hpp"

namespace brunt {

namespace {
/// How much longer than the last a step may be where particles look ahead for what is near.
constexpr Real kStepGrowth = 4;
}  // namespace

template <int Dim>
StepVote ContactManager<Dim>::Implementation::longest_after(Real dt) const {
  StepVote longest = entities.stiffness_vote();
  if (dt > 0 && !entities.particles.empty()) {
    const auto& first = entities.particles.front();
    longest.take({kStepGrowth * dt, "contact look-ahead", first.body, first.id});
  }
  return longest;
}

template <int Dim>
void ContactManager<Dim>::Implementation::evaluate(Real dt, const StepVote& longest) {
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
                                  section, {dt, longest.step}, part);
        });
  }
  vote = longest;
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
    own.candidates.build(own.entities, own.pairs, own.longest_last);
    return;
  }
  const StepVote longest = own.longest_after(0);
  own.candidates.build(own.entities, own.pairs, longest.step);
  own.evaluate(0, longest);
  own.records.clear();
}

template <int Dim>
void ContactManager<Dim>::add_forces(Real dt) {
  auto& own = *implementation_;
  own.entities.nodes.read_motion(own.surfaces);
  own.entities.refresh_planes();
  const StepVote longest = own.longest_after(dt);
  if (!own.candidates.complete(own.entities, longest.step)) {
    own.candidates.build(own.entities, own.pairs, longest.step);
  }
  own.evaluate(dt, longest);
  apply(own.records, dt, own.surfaces, own.entities.nodes);
  own.dt_last = dt;
  own.longest_last = longest.step;
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
