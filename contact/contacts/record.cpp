#include "contact/contacts/record.hpp"

#include <cstring>

namespace brunt {

namespace {
/// Adds to the nodes first .. last what the records give them.
template <int Dim>
void gather(const Records<Dim>& records, std::span<const Contribution<Dim>> elsewhere,
            LocalIndex first, LocalIndex last, ContactNodes<Dim>& nodes) {
  auto next = elsewhere.begin();
  const auto add_next = [&] {
    if (next->node >= first && next->node < last) {
      const auto at = slot_of(next->node);
      for (int c = 0; c < Dim; ++c) {
        nodes.spring[at][c] += next->spring[c];
        nodes.damping[at][c] += next->damping[c];
        if (nodes.has_friction) nodes.friction[at][c] += next->friction[c];
      }
      nodes.pressed[at] = 1;
    }
    ++next;
  };
  Vec<Dim>*const springs = nodes.spring.data(), *const dampings = nodes.damping.data();
  Vec<Dim>* const frictions = nodes.friction.data();
  char* const pressed = nodes.pressed.data();
  records.visit_whole([&](const WholeRecord<Dim>& whole) {
    const auto& record = whole.record;
    while (next != elsewhere.end() && next->key < key_of(record)) add_next();
    const Vec<Dim> normal = record.normal;
    const Real damping = record.damping;
    const auto n = slot_of(record.n_nodes);
    for (std::size_t k = 0; k < n; ++k) {
      const LocalIndex node = record.node[k];
      if (node < first || node >= last) continue;
      const auto at = slot_of(node);
      springs[at] += whole.spring_on(k);
      dampings[at] += record.weight[k] * damping * normal;
      if (whole.friction != nullptr) frictions[at] += whole.friction->force[k];
      pressed[at] = 1;
    }
  });
  while (next != elsewhere.end()) add_next();
}

/// What apply reads and writes of nodes, by plain pointers: else each byte that is written makes
/// all of them be read again.
template <int Dim>
struct AppliedNodes {
  AppliedNodes(Real step, const std::vector<Vec<Dim>*>& forces, ContactNodes<Dim>& nodes)
      : half_step(0.5 * step),
        v(nodes.v.data()),
        owned(nodes.owned.data()),
        surface(nodes.surface.data()),
        point(nodes.point.data()),
        pressed(nodes.pressed.data()),
        spring(nodes.spring.data()),
        damping(nodes.damping.data()),
        friction(nodes.has_friction ? nodes.friction.data() : nullptr),
        spring_work(nodes.spring_work.data()),
        damping_energy(nodes.damping_energy.data()),
        force(forces.data()) {}
  /// Books half of what the forces of a node take from its motion in a step: first of those of its
  /// begin, then of those of its end.
  void book_half(std::size_t i) const {
    const Vec<Dim> half_way = half_step * v[i];
    spring_work[i] -= spring[i].dot(half_way);
    damping_energy[i] -= damping[i].dot(half_way);
  }
  /// The first pressed node of i .. last - 1, or last: most touch nothing, and are not even read.
  std::size_t next_pressed(std::size_t i, std::size_t last) const {
    for (std::uint64_t eight = 0; i + sizeof eight <= last; i += sizeof eight) {
      std::memcpy(&eight, pressed + i, sizeof eight);
      if (eight != 0) break;
    }
    while (i < last && pressed[i] == 0) ++i;
    return i;
  }
  void clear(std::size_t i) const {
    spring[i].setZero();
    damping[i].setZero();
    if (friction != nullptr) friction[i].setZero();
    pressed[i] = 0;
  }
  void add_to_point(std::size_t i) const {
    auto& f = force[slot_of(surface[i])][point[i]];
    f += spring[i] + damping[i];
    if (friction != nullptr) f += friction[i];
  }

  Real half_step;
  const Vec<Dim>* v;
  const char* owned;
  const LocalIndex *surface, *point;
  char* pressed;
  Vec<Dim>*spring, *damping, *friction;
  Real *spring_work, *damping_energy;
  Vec<Dim>* const* force;  // on the points of each group
};
}  // namespace

template <int Dim>
void Records<Dim>::clear() {
  for (auto& part : parts_) {
    part.face_on_face.clear();
    part.particle_on_face.clear();
    part.two_particles.clear();
    part.pair_heat.clear();
    part.frictions.clear();
    part.pushes.clear();
    part.face_heat.clear();
    part.particle_heat.clear();
    part.face_touches.clear();
    part.particle_touches.clear();
    part.pair_touches.clear();
    part.face_ties.clear();
    part.particle_ties.clear();
    part.closures.clear();
    part.losses.clear();
    part.particle_losses.clear();
    part.lost.clear();
    part.deep.clear();
    part.past = 0;
    part.step_limit = StepLimit{};
  }
}

template <int Dim>
void Records<Dim>::collect_touches(FirstTouches& touches) const {
  touches.clear();
  for (const auto& part : parts_) {
    for (const auto& touch : part.face_touches) touches.add(touch);
  }
  for (const auto& part : parts_) {
    for (const auto& touch : part.particle_touches) touches.add(touch);
  }
  for (const auto& part : parts_) {
    for (const auto& touch : part.pair_touches) touches.add(touch);
  }
}

template <int Dim>
void Records<Dim>::collect_ties(TiePoints& ties) const {
  ties.clear();
  for (const auto& part : parts_) {
    for (const auto& tie : part.face_ties) ties.add(tie);
  }
  for (const auto& part : parts_) {
    for (const auto& tie : part.particle_ties) ties.add(tie);
  }
}

template <int Dim>
void Records<Dim>::collect_closures(JointClosures& closures) const {
  for (const auto& part : parts_) {
    if (!part.closures.empty()) closures.update(part.closures);
  }
}

template <int Dim>
void Records<Dim>::collect_deep(std::vector<DeepParticle<Dim>>& deep) const {
  deep.clear();
  for (const auto& part : parts_) deep.insert(deep.end(), part.deep.begin(), part.deep.end());
}

namespace {
template <int Dim>
void name_nodes_of(const Entities<Dim>& entities, ContactRecord<Dim>& record) {
  std::size_t n = 0;
  const auto add = [&](GlobalId id, bool particle, LocalIndex& place) {
    const std::size_t at = particle ? entities.particle_with(id) : entities.face_with(id);
    place = static_cast<LocalIndex>(at);
    if (particle) {
      record.node[n++] = entities.particles[at].node;
      return;
    }
    const auto& face = entities.faces[at];
    for (std::size_t c = 0; c < slot_of(face.n_nodes); ++c) {
      record.node[n++] = face.node[c];
    }
  };
  add(record.first, record.kind != ContactKind::face_face, record.first_place);
  add(record.second, record.kind == ContactKind::particle_particle, record.second_place);
}
}  // namespace

template <int Dim>
void Records<Dim>::name_nodes(const Entities<Dim>& entities) {
  for (auto& part : parts_) {
    for (auto* records : {&part.face_on_face, &part.particle_on_face, &part.two_particles}) {
      for (auto& record : *records) {
        name_nodes_of(entities, record);
        if (record.friction < 0) continue;
        part.frictions[slot_of(record.friction)].node = record.node;
      }
    }
  }
}

template <int Dim>
std::size_t Records<Dim>::size() const {
  std::size_t n = 0;
  for (const auto& part : parts_) {
    n += part.face_on_face.size() + part.particle_on_face.size() + part.two_particles.size();
  }
  return n;
}

template <int Dim>
StepLimit Records<Dim>::step_limit() const {
  StepLimit step_limit;
  for (const auto& part : parts_) step_limit.take(part.step_limit);
  return step_limit;
}

template <int Dim>
void apply(const Records<Dim>& records, std::span<const Contribution<Dim>> elsewhere, Real dt,
           const std::vector<Surface<Dim>*>& surfaces, ContactNodes<Dim>& nodes) {
  const std::size_t n = nodes.size();
  std::vector<Vec<Dim>*> forces;
  forces.reserve(surfaces.size());
  for (const auto* surface : surfaces) forces.push_back(surface->points->f.data());
  on_threads(n > kWorthThreads, [&] {
    // Each thread owns a range of nodes and reads all records: sums keep the order of keys.
    const auto count = slot_of(omp_get_num_threads());
    const auto k = slot_of(omp_get_thread_num());
    const std::size_t first = n * k / count, last = n * (k + 1) / count;
    const AppliedNodes<Dim> own(dt, forces, nodes);
    for (std::size_t i = first; (i = own.next_pressed(i, last)) < last; ++i) {
      if (own.owned[i] != 0) own.book_half(i);
      own.clear(i);
    }
    gather(records, elsewhere, static_cast<LocalIndex>(first), static_cast<LocalIndex>(last),
           nodes);
    for (std::size_t i = first; (i = own.next_pressed(i, last)) < last; ++i) {
      if (own.owned[i] == 0) continue;
      own.book_half(i);
      own.add_to_point(i);
    }
  });
}

template <int Dim>
void apply_heat(const Records<Dim>& records, std::span<const HeatShare> elsewhere,
                const std::vector<Surface<Dim>*>& surfaces, ContactNodes<Dim>& nodes) {
  std::fill(nodes.heat_rate.begin(), nodes.heat_rate.end(), 0.0);
  auto next = elsewhere.begin();
  const auto add_next = [&] {
    nodes.heat_rate[slot_of(next->node)] += next->rate;
    ++next;
  };
  records.visit_heat([&](const HeatFlow<Dim>& flow) {
    while (next != elsewhere.end() && next->key < flow.key) add_next();
    for (std::size_t k = 0; k < slot_of(flow.n_nodes); ++k) {
      nodes.heat_rate[slot_of(flow.node[k])] += flow.rate[k];
    }
  });
  while (next != elsewhere.end()) add_next();
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!nodes.owned[i]) continue;
    auto& points = *surfaces[slot_of(nodes.surface[i])]->points;
    if (!points.conducts) continue;
    points.heat_rate[slot_of(nodes.point[i])] += nodes.heat_rate[i];
  }
}

template void apply_heat<2>(const Records<2>&, std::span<const HeatShare>,
                            const std::vector<Surface<2>*>&, ContactNodes<2>&);
template void apply_heat<3>(const Records<3>&, std::span<const HeatShare>,
                            const std::vector<Surface<3>*>&, ContactNodes<3>&);
template class Records<2>;
template class Records<3>;
template void apply<2>(const Records<2>&, std::span<const Contribution<2>>, Real,
                       const std::vector<Surface<2>*>&, ContactNodes<2>&);
template void apply<3>(const Records<3>&, std::span<const Contribution<3>>, Real,
                       const std::vector<Surface<3>*>&, ContactNodes<3>&);

}  // namespace brunt
// Tested by tests/unit/contact/manager_test.cpp.
