/// What presses at time 0 is there from the start.
#include "contact/manager/implementation.hpp"

namespace brunt {

namespace {
/// What springs hold that press at time 0 is there from the start: nobody has done work on them.
template <int Dim>
void press(const ContactSetup<Dim>& setup, const Records<Dim>& records,
           ContactSearch<Dim>& search) {
  const auto& surfaces = setup.surfaces;
  auto& entities = search.entities();
  auto& nodes = entities.nodes;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    nodes.spring_work[i] = 0;
    if (!nodes.owned[i]) continue;
    surfaces[slot_of(nodes.surface[i])]->points->f[slot_of(nodes.point[i])].setZero();
  }
  const auto elsewhere = search.imports().send_home(records, nodes);
  apply<Dim>(records, elsewhere, 0, surfaces, nodes);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!nodes.owned[i] || nodes.mass[i] == 0) continue;
    auto& points = *surfaces[slot_of(nodes.surface[i])]->points;
    const auto p = slot_of(nodes.point[i]);
    points.a[p] = points.f[p] / nodes.mass[i];
  }
  for (const auto* surface : surfaces) {
    for (const LocalIndex p : surface->axis) surface->points->a[slot_of(p)][0] = 0;
  }
  records.visit([&](const ContactRecord<Dim>& record) {
    nodes.spring_work[book_of(entities, key_of(record))] += record.stored;
  });
}
}  // namespace

template <int Dim>
bool ContactManager<Dim>::start() {
  auto& [setup, search, evaluation, memory, friction_check, last] = *implementation_;
  if (last.started || !setup.pairs.presses()) return false;
  const LookAhead ahead{evaluation.step_limit(), last.ahead};
  evaluation.run(setup, search, 0, ahead, memory.step(true), nullptr);
  memory.begin(evaluation.records());
  press(setup, evaluation.records(), search);  // row 0 of a history reads the records that are left
  return true;
}

template bool ContactManager<2>::start();
template bool ContactManager<3>::start();

}  // namespace brunt
// Tested by tests/unit/contact/first_touch_test.cpp.
