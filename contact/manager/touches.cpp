/// What pairs keep from time 0, from run to run.
#include <algorithm>
#include <set>

#include "contact/contacts/keyed_rows.hpp"
#include "contact/manager/implementation.hpp"
#include "core/state_hash.hpp"

namespace brunt {

namespace {
constexpr const char* kTouchTable = "contact.first";

template <class Row, class AnyTouch>
void visit_touch(Row& row, AnyTouch& touch) {
  row(touch.key.second);
  row(touch.overlap);
  row(touch.bonded);
  row(touch.slips);
  row(touch.side);
  row(touch.held);
  row(touch.entry);
}
}  // namespace

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
void ContactManager<Dim>::Implementation::save_touches(std::vector<StateTable>& tables) const {
  std::vector<const FirstTouch*> all;
  for (const auto& touch : touches.all()) all.push_back(&touch);
  save_keyed(
      kTouchTable, all, [](auto& row, const auto& touch) { visit_touch(row, touch); }, tables);
}

template <int Dim>
void ContactManager<Dim>::Implementation::load_touches(const StateTables& tables) {
  const auto visit = [](auto& row, auto& touch) { visit_touch(row, touch); };
  touches.clear();
  load_keyed(kTouchTable, entities, tables, visit, touches.all());
}

template <int Dim>
std::uint64_t ContactManager<Dim>::Implementation::touch_hash() const {
  std::uint64_t sum = 0;
  for (const auto& touch : touches.all()) {
    EntityHash hash(touch.key.first);
    hash.add(touch.key.second);
    hash.add(touch.overlap);
    hash.add(static_cast<std::uint64_t>(touch.bonded ? 1 : 0) + (touch.slips ? 2 : 0) +
             4 * static_cast<std::uint64_t>(touch.side + 1) + (touch.held ? 16 : 0));
    if (touch.entry != FirstTouch::kNoEntry) hash.add(touch.entry);
    sum += hash.value();
  }
  return sum;
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
    if (key.of_particle == 2) return std::minmax(body_of(key.first), body_of(key.second));
    if (key.of_particle == 1) {
      return std::minmax(body_of(key.first), static_cast<Label>(key.second >> 32));
    }
    return std::minmax(entities.faces[entities.face_with(key.first)].body,
                       entities.faces[entities.face_with(key.second)].body);
  };
  for (const auto& touch : own.touches.all()) {
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
template std::uint64_t ContactManager<2>::Implementation::touch_hash() const;
template std::uint64_t ContactManager<3>::Implementation::touch_hash() const;
template void ContactManager<2>::Implementation::save_touches(std::vector<StateTable>&) const;
template void ContactManager<3>::Implementation::save_touches(std::vector<StateTable>&) const;
template void ContactManager<2>::Implementation::load_touches(const StateTables&);
template void ContactManager<3>::Implementation::load_touches(const StateTables&);

}  // namespace brunt
// Tested by tests/unit/contact/manager_test.cpp.
