#include "contact/evaluate/ties.hpp"

#include <algorithm>
#include <cmath>

#include "contact/evaluate/particle_law.hpp"
#include "contact/evaluate/particle_touches.hpp"
#include "contact/geometry/face_couple.hpp"
#include "contact/law/springs.hpp"

namespace brunt {

namespace {
/// A pair in the midst of being held.
template <int Dim>
struct Held {
  static constexpr std::size_t kNodes = slot_of(ContactRecord<Dim>::kNodes);
  HoldingSpring spring;
  Real friction = 0;  // [1] that adds to its shear strength
  Real farthest = 0;  // [m] between its places, as far as lists see
  Vec<Dim> normal;
  // In the order of the record's nodes: one side, then the other.
  std::size_t n_first = 0, n_nodes = 0;
  std::array<Vec<Dim>, kNodes> x, v, force;
  std::array<Real, kNodes> weight{};  // [m^2], sums of areas
  Vec<Dim> sum = Vec<Dim>::Zero();    // [N] on the second side
  Real area = 0, stored = 0, used = 0, closest = -kInfinity;
  Real half_work = 0;  // [J] of the forces now over the step
  bool breaks = false;

  void take(const ContactNodes<Dim>& nodes, LocalIndex node) {
    const auto i = slot_of(node);
    x[n_nodes] = nodes.x[i], v[n_nodes] = nodes.v[i];
    force[n_nodes].setZero();
    ++n_nodes;
  }
};

/// Adds what one place gives. of_first, of_second  [1] weights of both sides' nodes; the normal
/// points from the first to the second
template <int Dim>
void add_place(const Real* of_first, const Real* of_second, TiePoint& tie, Real dt,
               Held<Dim>& held) {
  Vec<Dim> r = Vec<Dim>::Zero(), velocity = Vec<Dim>::Zero();
  const auto visit = [&](const auto& node) {
    for (std::size_t k = 0; k < held.n_first; ++k) node(k, -of_first[k]);
    for (std::size_t k = held.n_first; k < held.n_nodes; ++k) {
      node(k, of_second[k - held.n_first]);
    }
  };
  visit([&](std::size_t k, Real w) { r += w * held.x[k], velocity += w * held.v[k]; });
  const Real along = r.dot(held.normal), closure = tie.gap - along;
  const Vec<Dim> across = r - along * held.normal;
  const auto& spring = held.spring;
  const Real before = tie.closed;
  tie.closed = std::max(tie.closed, closure);
  const Real pressure = spring.pressure(closure, before);
  const Vec<Dim> shear = -spring.shear * across;
  const Real strength = spring.cohesion + held.friction * std::max(pressure, 0.0);
  held.breaks = held.breaks || -pressure > spring.tension || shear.norm() > strength ||
                !(r.norm() - std::fabs(tie.gap) < held.farthest);
  const Vec<Dim> force = tie.area * (pressure * held.normal + shear);
  visit([&](std::size_t k, Real w) {
    held.force[k] += w * force;
    held.weight[k] += tie.area * w;
  });
  held.sum += force;
  held.area += tie.area;
  held.stored +=
      tie.area * (spring.stored(closure, tie.closed) + 0.5 * spring.shear * across.squaredNorm());
  held.used += tie.area * (spring.lost(tie.closed) - spring.lost(before));
  held.closest = std::max(held.closest, closure);
  held.half_work -= 0.5 * dt * force.dot(velocity);
}

/// Takes the moment that is left of all forces from the corners of both sides, half each; where one
/// does not turn, the other has all.
template <int Dim>
void balance(bool first_turns, bool second_turns, Held<Dim>& held) {
  if (!first_turns && !second_turns) return;
  const Vec<Dim> none = Vec<Dim>::Zero();
  auto torque = torque_at(none, none);
  for (std::size_t k = 0; k < held.n_nodes; ++k) {
    torque += torque_at(Vec<Dim>(held.x[k] - held.x[0]), held.force[k]);
  }
  torque *= first_turns && second_turns ? -0.5 : -1.0;
  const auto give = [&](std::size_t begin, std::size_t end) {
    add_couple<Dim>(std::span<const Vec<Dim>>(held.x.data() + begin, end - begin), torque,
                    std::span<Vec<Dim>>(held.force.data() + begin, end - begin));
  };
  if (first_turns) give(0, held.n_first);
  if (second_turns) give(held.n_first, held.n_nodes);
}

/// What the record shares along its normal, and the rest. sign  1: its normal is that from the
/// first side to the second; -1: that of a particle, which is the upper side and comes first
template <int Dim>
void fill(const Held<Dim>& held, Real sign, ContactRecord<Dim>& record,
          typename Records<Dim>::Part& part) {
  record.normal = sign * held.normal;
  record.area = held.area;
  record.penetration = held.closest;
  record.spring = held.sum.dot(held.normal);
  record.stored = held.stored;
  record.bonded = true;
  record.push = static_cast<std::int32_t>(part.pushes.size());
  auto& pushes = part.pushes.emplace_back();
  pushes.n_lower = static_cast<int>(held.n_first);
  record.point.setZero();
  for (std::size_t k = 0; k < held.n_nodes; ++k) {
    record.weight[k] = sign * held.weight[k] / held.area;
    pushes.force[k] = held.force[k] - record.weight[k] * record.spring * record.normal;
    if (record.weight[k] > 0) record.point += record.weight[k] * held.x[k];
  }
}

Real friction_of(const PairLaws& laws) {
  if (laws.friction == nullptr || laws.friction->needs_material()) return 0;
  return laws.friction->coefficient({});
}

/// The place of a face with an id; -1 where it is not here, or far.
template <int Dim>
std::ptrdiff_t face_at(const Entities<Dim>& entities, GlobalId id) {
  const std::size_t f = entities.face_with(id);
  if (f >= entities.faces.size() || entities.faces[f].id != id) return -1;
  return entities.is_near(entities.faces[f].body) ? static_cast<std::ptrdiff_t>(f) : -1;
}

/// Farther than this the lists of particles may not see a face, in radii; it stands one before it.
constexpr Real kFarthestRadii = 1.5;

HoldingSpring with_strength(const PairOptions& options, HoldingSpring spring) {
  const auto& bond = std::get<CohesiveBond>(options.bonds);
  // What is tied breaks by the strengths that are given, a joint has no others.
  const bool endless = options.tied;
  if (!endless || bond.tension > 0) spring.tension = bond.tension;
  if (!endless || bond.cohesion > 0) spring.cohesion = bond.cohesion;
  return spring;
}

/// body  of the lower side;  loss  place where the energy will be booked
template <int Dim>
BrokenTies<Dim> broken_by(const Held<Dim>& held, Label body, std::size_t loss) {
  return {.any = true,
          .body = body,
          .traction = held.sum,
          .energy = held.stored + held.used - held.half_work,
          .loss = loss};
}

/// Keeps what two faces, or a particle and a face, have used up.
void note_loss(const ContactKey& key, Real energy, std::vector<JointLoss>& losses) {
  if (energy != 0) losses.push_back({key, energy});
}

/// both  [Pa/m] the springs of both sides
HoldingSpring holding_spring(Real both, const PairOptions& options) {
  HoldingSpring spring;
  spring.stiffest = options.stiffest() * both;
  spring.normal = spring.shear = spring.stiffest;
  if (options.joint) {
    spring.normal = std::min(options.joint->normal, spring.stiffest);
    spring.shear = std::min(options.joint->across(), spring.stiffest);
    spring.closure = options.joint->closure();
  }
  return with_strength(options, spring);
}
}  // namespace

template <int Dim>
HoldingSpring spring_between(const ContactFace<Dim>& a, const ContactFace<Dim>& b,
                             const PairOptions& options) {
  return holding_spring(contact_spring(a.stiffness, a.deforms(), b.stiffness, b.deforms()),
                        options);
}

template <int Dim>
HoldingSpring spring_between(const ContactParticle& particle, const ContactFace<Dim>& face,
                             const PairOptions& options) {
  const Real own = particle.matter->modulus / (2 * particle.radius);
  return holding_spring(contact_spring(own, true, face.stiffness, face.deforms()), options);
}

template <int Dim>
bool hold_faces(const Entities<Dim>& entities, const FaceCandidate& candidate,
                const Section& section, const EvaluationStep& step, BrokenTies<Dim>& broken,
                typename Records<Dim>::Part& part) {
  const auto l = slot_of(candidate.lower);
  const auto u = slot_of(candidate.upper);
  const auto &lower = entities.faces[l], &upper = entities.faces[u];
  const ContactKey key{ContactKind::face_face, 0, lower.id, upper.id};
  const auto ties = step.touches.ties->range(
      key, {ContactKind::face_face, ~std::uint32_t{0}, lower.id, upper.id});
  if (ties.empty()) return false;
  Held<Dim> held;
  held.spring = spring_between(lower, upper, *candidate.laws.holds);
  held.friction = friction_of(candidate.laws);
  held.farthest = candidate.normal.limit;
  held.normal = (entities.planes[l].normal - entities.planes[u].normal).normalized();
  ContactRecord<Dim> record;
  record.first = lower.id, record.second = upper.id;
  record.first_place = candidate.lower, record.second_place = candidate.upper;
  record.lower_body = lower.body, record.upper_body = upper.body;
  for (const auto* face : {&lower, &upper}) {
    for (int c = 0; c < face->n_nodes; ++c) {
      const LocalIndex node = face->node[slot_of(c)];
      held.take(entities.nodes, node);
      record.add(node, 0);
    }
    if (face == &lower) held.n_first = held.n_nodes;
  }
  const std::size_t first = part.face_ties.size();
  for (const auto& tie : ties) {
    auto& kept = part.face_ties.emplace_back(tie);
    add_place(kept.lower.data(), kept.upper.data(), kept, step.dt, held);
  }
  if (held.breaks) {
    broken = broken_by(held, lower.body, part.losses.size());
    broken.traction /= held.area;
    for (const auto& tie : ties) broken.closed = std::max(broken.closed, tie.closed);
    part.face_ties.resize(first);
    if (broken.closed > 0 && held.spring.remembers()) part.closures.push_back({key, broken.closed});
    part.losses.push_back({key, std::max(broken.energy, 0.0)});
    return false;
  }
  note_loss(key, held.used, part.losses);
  const bool torques = section.geometry != Geometry::axisymmetric;
  balance(torques && !lower.rigid(), torques && !upper.rigid(), held);
  fill(held, 1, record, part);
  part.face_on_face.push_back(record);
  return true;
}

template <int Dim>
void settle_broken(const Entities<Dim>& entities, const BrokenTies<Dim>& broken,
                   std::span<const ContactRecord<Dim>> records, Real dt,
                   const typename Records<Dim>::Part& part, std::vector<JointLoss>& losses) {
  Real lost = broken.energy;
  for (const auto& record : records) {
    if (record.lower_body != broken.body) continue;
    const auto* push = record.push < 0 ? nullptr : &part.pushes[slot_of(record.push)];
    const WholeRecord<Dim> whole{record, nullptr, push};
    lost -= record.stored;
    for (std::size_t n = 0; n < slot_of(record.n_nodes); ++n) {
      lost -= 0.5 * dt * whole.spring_on(n).dot(entities.nodes.v[slot_of(record.node[n])]);
    }
    if (record.friction >= 0) lost += part.frictions[slot_of(record.friction)].pairs;
  }
  losses[broken.loss].energy = std::max(lost, 0.0);
}

template <int Dim>
Real hold_particle(const Entities<Dim>& entities, LocalIndex place, PairFinder& pairs, Real area,
                   const Section& section, const EvaluationStep& step, BrokenTies<Dim>& broken,
                   typename Records<Dim>::Part& part) {
  const auto& particle = entities.particles[slot_of(place)];
  const auto ties = step.touches.ties->range({ContactKind::particle_face, 0, particle.id, 0},
                                             {ContactKind::particle_face, 0, particle.id + 1, 0});
  Real squared_frequency = 0;
  for (const auto& tie : ties) {
    const std::ptrdiff_t f = face_at(entities, tie.key.second);
    if (f < 0) continue;
    const auto& face = entities.faces[slot_of(f)];
    const PairOptions& options = pairs.of(particle.body, face.body);
    Held<Dim> held;
    held.spring = spring_between(particle, face, options);
    held.friction = friction_of(PairLaws(options, false));
    held.farthest = kFarthestRadii * particle.radius;
    held.normal = -entities.planes[slot_of(f)].normal;
    ContactRecord<Dim> record;
    record.kind = ContactKind::particle_face;
    record.first = particle.id, record.second = face.id;
    record.first_place = place, record.second_place = static_cast<LocalIndex>(f);
    record.lower_body = face.body, record.upper_body = particle.body;
    held.take(entities.nodes, particle.node);
    record.add(particle.node, 0);
    held.n_first = held.n_nodes;
    for (int c = 0; c < face.n_nodes; ++c) {
      const LocalIndex node = face.node[slot_of(c)];
      held.take(entities.nodes, node);
      record.add(node, 0);
    }
    TiePoint kept = tie;
    add_place(kept.upper.data(), kept.lower.data(), kept, step.dt, held);
    if (held.breaks) {
      broken = broken_by(held, face.body, part.particle_losses.size());
      broken.traction = -broken.traction;  // the particle comes first, and is the upper side
      broken.stiffness = law_of(particle, face, options, RestingLayer()).stiffness;
      part.particle_losses.push_back({tie.key, std::max(broken.energy, 0.0)});
      continue;
    }
    part.particle_ties.push_back(kept);
    keep_touch(particle, face, step.touches, part);
    note_loss(tie.key, held.used, part.particle_losses);
    balance(false, section.geometry != Geometry::axisymmetric && !face.rigid(), held);
    fill(held, -1, record, part);
    part.particle_on_face.push_back(record);
    std::erase_if(part.hits, [&](const auto& hit) { return hit.body == face.body; });
    const Real mass = entities.nodes.mass[slot_of(particle.node)];
    if (mass > 0) squared_frequency += held.spring.slope(held.closest) * area / mass;
  }
  return squared_frequency;
}

template <int Dim>
Real close_joint(const Entities<Dim>& entities, const FaceCandidate& candidate,
                 const CommonPlane<Dim>& plane, const EvaluationStep& step,
                 const BrokenTies<Dim>& broken, typename Records<Dim>::Part& part) {
  const auto& lower = entities.faces[slot_of(candidate.lower)];
  const auto& upper = entities.faces[slot_of(candidate.upper)];
  const HoldingSpring spring = spring_between(lower, upper, *candidate.laws.holds);
  if (!spring.remembers()) return 1;
  auto& record = part.face_on_face.back();
  const Real area = plane.ramp * plane.area, closure = plane.volume / area;
  const ContactKey key{ContactKind::face_face, plane.ordinal, lower.id, upper.id};
  const auto* known = step.touches.closures->find(key);
  Real before = known == nullptr ? broken.closed : known->closed;
  if (known == nullptr && !broken.any) {
    // What slides on takes over how far its lower face has been closed.
    for (const auto& beside :
         step.touches.closures->range({ContactKind::face_face, 0, lower.id, 0},
                                      {ContactKind::face_face, 0, lower.id + 1, 0})) {
      before = std::max(before, beside.closed);
    }
  }
  const Real closed = std::max(before, closure);
  part.closures.push_back({key, closed});
  note_loss(key, area * (spring.lost(closed) - spring.lost(before)), part.losses);
  const Real of_linear = spring.pressure(closure, before) / (candidate.normal.stiffness * closure);
  record.spring *= of_linear;
  record.stored *= of_linear * of_linear * candidate.normal.stiffness / spring.slope(closed);
  return of_linear;
}

template bool hold_faces<2>(const Entities<2>&, const FaceCandidate&, const Section&,
                            const EvaluationStep&, BrokenTies<2>&, Records<2>::Part&);
template void settle_broken<2>(const Entities<2>&, const BrokenTies<2>&,
                               std::span<const ContactRecord<2>>, Real, const Records<2>::Part&,
                               std::vector<JointLoss>&);
template bool hold_faces<3>(const Entities<3>&, const FaceCandidate&, const Section&,
                            const EvaluationStep&, BrokenTies<3>&, Records<3>::Part&);
template void settle_broken<3>(const Entities<3>&, const BrokenTies<3>&,
                               std::span<const ContactRecord<3>>, Real, const Records<3>::Part&,
                               std::vector<JointLoss>&);
template Real hold_particle<2>(const Entities<2>&, LocalIndex, PairFinder&, Real, const Section&,
                               const EvaluationStep&, BrokenTies<2>&, Records<2>::Part&);
template Real hold_particle<3>(const Entities<3>&, LocalIndex, PairFinder&, Real, const Section&,
                               const EvaluationStep&, BrokenTies<3>&, Records<3>::Part&);
template Real close_joint<2>(const Entities<2>&, const FaceCandidate&, const CommonPlane<2>&,
                             const EvaluationStep&, const BrokenTies<2>&, Records<2>::Part&);
template HoldingSpring spring_between<2>(const ContactFace<2>&, const ContactFace<2>&,
                                         const PairOptions&);
template HoldingSpring spring_between<2>(const ContactParticle&, const ContactFace<2>&,
                                         const PairOptions&);
template Real close_joint<3>(const Entities<3>&, const FaceCandidate&, const CommonPlane<3>&,
                             const EvaluationStep&, const BrokenTies<3>&, Records<3>::Part&);
template HoldingSpring spring_between<3>(const ContactFace<3>&, const ContactFace<3>&,
                                         const PairOptions&);
template HoldingSpring spring_between<3>(const ContactParticle&, const ContactFace<3>&,
                                         const PairOptions&);

}  // namespace brunt
// Tested by tests/unit/contact/ties_test.cpp.
