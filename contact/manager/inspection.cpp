/// What the manager shows of its work, and of how the bodies of a scene stand to each other.
#include <algorithm>
#include <map>
#include <set>

#include "contact/evaluate/ties.hpp"
#include "contact/manager/implementation.hpp"

namespace brunt {

template <int Dim>
std::size_t ContactManager<Dim>::n_pairs() const {
  return implementation_->setup.pairs.pairs().size();
}

template <int Dim>
std::size_t ContactManager<Dim>::n_facets() const {
  std::size_t n = 0;
  for (const auto* surface : implementation_->setup.surfaces) n += surface->facets.size();
  return n;
}

template <int Dim>
ContactWork ContactManager<Dim>::work() const {
  const auto& own = *implementation_;
  const auto& candidates = own.search.candidates();
  return {candidates.builds(),
          candidates.n_faces() + candidates.n_particles() + candidates.pairs().size(),
          own.evaluation.records().size(), candidates.skin(),
          own.search.entities().near_faces.size()};
}

template <int Dim>
std::vector<std::vector<Real>> ContactManager<Dim>::point_work() const {
  // [ns] of a candidate, near or far alike (docs/performance.md); only their ratio matters.
  constexpr Real kFacePair = 1500, kParticleOnFace = 400, kParticlePair = 50;
  const auto& own = *implementation_;
  const auto& entities = own.search.entities();
  const auto& candidates = own.search.candidates();
  const auto& nodes = entities.nodes;
  std::vector<std::vector<Real>> work;
  for (const auto* surface : own.setup.surfaces) {
    work.emplace_back(slot_of(surface->points->n_owned), 0.0);
  }
  const auto add = [&](LocalIndex node, Real cost) {
    const auto i = slot_of(node);
    if (!nodes.owned[i] || nodes.point[i] < 0) return;
    auto& of_surface = work[slot_of(nodes.surface[i])];
    const auto point = slot_of(nodes.point[i]);
    if (point < of_surface.size()) of_surface[point] += cost;
  };
  for (const auto& pair : candidates.faces(entities).listed()) {
    const auto& face = entities.faces[slot_of(pair.lower)];
    for (int c = 0; c < face.n_nodes; ++c) {
      add(face.node[slot_of(c)], kFacePair / face.n_nodes);
    }
  }
  const ParticleRows rows = candidates.particle_rows(own.setup.pairs, own.last.ahead);
  for (std::size_t row = 0; row < rows.row_clearances.size(); ++row) {
    const auto [first, last] = rows.range(row);
    const auto particle = slot_of(rows.row_clearances[row].entity);
    add(entities.particles[particle].node, kParticleOnFace * static_cast<Real>(last - first));
  }
  for (const auto& pair : candidates.pairs()) {
    add(entities.particles[slot_of(pair.particle)].node, kParticlePair);
  }
  return work;
}

namespace {
/// Bodies of a contact. surface  the second id of a particle on a surface names that, else a face
template <int Dim>
std::pair<Label, Label> bodies_of(const Entities<Dim>& entities, const ContactKey& key,
                                  bool surface) {
  const auto of_particle = [&](GlobalId id) {
    return entities.particles[entities.particle_with(id)].body;
  };
  const auto of_face = [&](GlobalId id) { return entities.faces[entities.face_with(id)].body; };
  if (key.kind == ContactKind::particle_particle) {
    return std::minmax(of_particle(key.first), of_particle(key.second));
  }
  if (key.kind == ContactKind::particle_face) {
    const Label other = surface ? static_cast<Label>(key.second >> 32) : of_face(key.second);
    return std::minmax(of_particle(key.first), other);
  }
  return std::minmax(of_face(key.first), of_face(key.second));
}
}  // namespace

template <int Dim>
std::vector<HeldPair> ContactManager<Dim>::held_pairs() const {
  constexpr Real kSoon = 0.95;  // of the largest closure
  const auto& own = *implementation_;
  const auto& entities = own.search.entities();
  std::map<std::size_t, HeldPair> by_pair;
  for (const auto& [names, name] : own.setup.options.pair_names) {
    const auto pair = own.setup.pairs.find(names.first, names.second);
    if (pair && own.setup.pairs.of(names.first, names.second).holds()) by_pair[*pair].name = name;
  }
  const auto find = [&](const std::pair<Label, Label>& bodies) {
    return by_pair.find(own.setup.pairs.find(bodies.first, bodies.second).value());
  };
  for (const auto& tie : own.memory.ties()) {
    const auto it = find(bodies_of(entities, tie.key, false));
    if (it != by_pair.end()) ++it->second.places;
  }
  const FacePairs<Dim> pairs = own.search.candidates().faces(entities);
  for (std::size_t k = 0; k < pairs.listed().size(); ++k) {
    const PairOptions* options = pairs.options(k).options;
    if (!options->joint) continue;
    const auto& lower = entities.faces[slot_of(pairs.listed()[k].lower)];
    const auto& upper = entities.faces[slot_of(pairs.listed()[k].upper)];
    const auto it = find(std::minmax(lower.body, upper.body));
    if (it == by_pair.end()) continue;
    const HoldingSpring spring = spring_between(lower, upper, *options);
    const JointSpring& joint = *options->joint;
    const ClosureLaw law = joint.closure();
    const Real steepest = law.any() ? law.slope(joint.normal, kSoon * law.most())
                                    : std::max(joint.normal, joint.across());
    if (steepest > spring.stiffest) {
      it->second.stiffest = spring.stiffest;
      it->second.times_elements = options->stiffest();
    }
  }
  std::vector<HeldPair> found;
  found.reserve(by_pair.size());
  for (const auto& [pair, held] : by_pair) found.push_back(held);
  return found;
}

template <int Dim>
std::vector<InitialOverlaps> ContactManager<Dim>::initial_overlaps() const {
  const auto& own = *implementation_;
  std::map<std::size_t, InitialOverlaps> by_pair;
  for (const auto& touch : own.memory.touches()) {
    if (!(touch.overlap > 0)) continue;
    const auto [a, b] = bodies_of(own.search.entities(), touch.key, true);
    const std::size_t pair = own.setup.pairs.find(a, b).value();
    auto& overlaps = by_pair[pair];
    overlaps.name = own.setup.pairs.name(pair);
    ++overlaps.contacts;
    overlaps.deepest = std::max(overlaps.deepest, touch.overlap);
  }
  std::vector<InitialOverlaps> found;
  found.reserve(by_pair.size());
  for (const auto& [pair, overlaps] : by_pair) found.push_back(overlaps);
  return found;
}

template <int Dim>
std::vector<OneSidedPair> ContactManager<Dim>::one_sided_pairs() const {
  const auto& own = *implementation_;
  std::set<Label> with_faces, open;
  for (const auto& face : own.search.entities().faces) {
    with_faces.insert(face.body);
    if (face.open) open.insert(face.body);
  }
  std::vector<OneSidedPair> found;
  for (std::size_t k = 0; k < own.setup.pairs.pairs().size(); ++k) {
    const auto [a, b] = own.setup.pairs.pairs()[k];
    if (with_faces.count(a) == 0 || with_faces.count(b) == 0) continue;
    if (open.count(a) != 0) found.push_back({own.setup.pairs.name(k), a});
    if (open.count(b) != 0 && b != a) found.push_back({own.setup.pairs.name(k), b});
  }
  return found;
}

template std::vector<OneSidedPair> ContactManager<2>::one_sided_pairs() const;
template std::vector<OneSidedPair> ContactManager<3>::one_sided_pairs() const;
template std::vector<HeldPair> ContactManager<2>::held_pairs() const;
template std::vector<HeldPair> ContactManager<3>::held_pairs() const;
template std::vector<InitialOverlaps> ContactManager<2>::initial_overlaps() const;
template std::vector<InitialOverlaps> ContactManager<3>::initial_overlaps() const;
template std::size_t ContactManager<2>::n_pairs() const;
template std::size_t ContactManager<3>::n_pairs() const;
template std::size_t ContactManager<2>::n_facets() const;
template std::size_t ContactManager<3>::n_facets() const;
template ContactWork ContactManager<2>::work() const;
template ContactWork ContactManager<3>::work() const;
template std::vector<std::vector<Real>> ContactManager<2>::point_work() const;
template std::vector<std::vector<Real>> ContactManager<3>::point_work() const;

}  // namespace brunt
// Tested by tests/unit/contact/manager_test.cpp.
