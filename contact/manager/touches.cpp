/// What pairs keep from time 0, from run to run.
#include <algorithm>
#include <set>

#include "contact/manager/implementation.hpp"

namespace brunt {

/// What springs hold that press at time 0 is there from the start: nobody has done work on them.
template <int Dim>
void ContactManager<Dim>::Implementation::press_at_start() {
  auto& nodes = entities.nodes;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    nodes.spring_work[i] = 0;
    if (!nodes.owned[i]) continue;
    surfaces[static_cast<std::size_t>(nodes.surface[i])]
        ->points->f[static_cast<std::size_t>(nodes.point[i])]
        .setZero();
  }
  const auto elsewhere = imports.send_home(records, nodes);
  apply<Dim>(records, elsewhere, 0, surfaces, nodes);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!nodes.owned[i] || nodes.mass[i] == 0) continue;
    auto& points = *surfaces[static_cast<std::size_t>(nodes.surface[i])]->points;
    const auto p = static_cast<std::size_t>(nodes.point[i]);
    points.a[p] = points.f[p] / nodes.mass[i];
  }
  for (const auto* surface : surfaces) {
    for (const LocalIndex p : surface->axis) surface->points->a[static_cast<std::size_t>(p)][0] = 0;
  }
  records.visit([&](const ContactRecord<Dim>& record) {
    nodes.spring_work[book_of(entities, key_of(record))] += record.stored;
  });
}

template <int Dim>
std::vector<InitialOverlaps> ContactManager<Dim>::initial_overlaps() const {
  const auto& own = *implementation_;
  std::map<std::size_t, InitialOverlaps> by_pair;
  const auto bodies_of = [&](const ContactKey& key) -> std::pair<Label, Label> {
    const auto& entities = own.entities;
    const auto body_of = [&](GlobalId particle) {
      return entities.particles[entities.particle_with(particle)].body;
    };
    if (key.kind == ContactKind::particle_particle) {
      return std::minmax(body_of(key.first), body_of(key.second));
    }
    if (key.kind == ContactKind::particle_face) {
      return std::minmax(body_of(key.first), static_cast<Label>(key.second >> 32));
    }
    return std::minmax(entities.faces[entities.face_with(key.first)].body,
                       entities.faces[entities.face_with(key.second)].body);
  };
  for (const auto& touch : own.memory.touches()) {
    if (!(touch.overlap > 0)) continue;
    const auto [a, b] = bodies_of(touch.key);
    const std::size_t pair = own.pairs.find(a, b).value();
    auto& overlaps = by_pair[pair];
    overlaps.name = own.pairs.name(pair);
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
  for (const auto& face : own.entities.faces) {
    with_faces.insert(face.body);
    if (face.open) open.insert(face.body);
  }
  std::vector<OneSidedPair> found;
  for (std::size_t k = 0; k < own.pairs.pairs().size(); ++k) {
    const auto [a, b] = own.pairs.pairs()[k];
    if (with_faces.count(a) == 0 || with_faces.count(b) == 0) continue;
    if (open.count(a) != 0) found.push_back({own.pairs.name(k), a});
    if (open.count(b) != 0 && b != a) found.push_back({own.pairs.name(k), b});
  }
  return found;
}

template std::vector<OneSidedPair> ContactManager<2>::one_sided_pairs() const;
template std::vector<OneSidedPair> ContactManager<3>::one_sided_pairs() const;
template std::vector<InitialOverlaps> ContactManager<2>::initial_overlaps() const;
template std::vector<InitialOverlaps> ContactManager<3>::initial_overlaps() const;
template void ContactManager<2>::Implementation::press_at_start();
template void ContactManager<3>::Implementation::press_at_start();

}  // namespace brunt
// Tested by tests/unit/contact/manager_test.cpp.
