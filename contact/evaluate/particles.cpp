#include <algorithm>
#include <cmath>

#include "contact/evaluate/evaluate.hpp"
#include "contact/evaluate/particle_law.hpp"
#include "contact/evaluate/particle_touches.hpp"
#include "contact/evaluate/ties.hpp"
#include "contact/geometry/box_query.hpp"

namespace brunt {

namespace {
/// A particle with what its contacts need.
template <int Dim>
struct Present {
  const ContactParticle& particle;
  LocalIndex place;  // of the particle
  Vec<Dim> x, v;
  BoxQuery<Dim> about;
  Real mass;
  Real breadth;
};

/// Whether a particle may overlap a face, and whether it does so from before it.
struct Reach {
  bool any, before;
};

/// Of the particle, `before` [m] the mean plane: its centre is at most r before the face or a few r
/// behind. Without branches: which faces are near changes from one to the next.
template <int Dim>
Reach reach_of(const FacePlane<Dim>& plane, const SearchBox<Dim>& box, const Present<Dim>& now,
               Real before) {
  const Real r = now.particle.radius;
  const bool clear = before > plane.warp;
  const bool none =
      (plane.area == 0) | (before > r + plane.warp) | (before < -kDepthRadii * r - plane.warp);
  const bool any = !none & now.about.in(box, clear ? r : kDepthRadii * r);
  return {any, clear};
}

/// The same of an open surface, which holds what belongs to one of its `side`s deep on the other.
template <int Dim>
Reach reach_of_open(const FacePlane<Dim>& plane, const SearchBox<Dim>& box, const Present<Dim>& now,
                    Real before, int side) {
  const Real reach = (side != 0 ? kOpenDepthRadii : 1) * now.particle.radius;
  const bool none = plane.area == 0 || std::fabs(before) > reach + plane.warp;
  return {!none && now.about.in(box, reach), side == 0 || side * before > plane.warp};
}

/// Where the particle belongs at an open surface, as it was at the last evaluation; 0: not known.
template <int Dim>
int side_of(const TouchStep& step, const ContactParticle& particle, const ContactFace<Dim>& face) {
  const auto* before = step.before->find(touch_key(particle.id, face.body, face.piece));
  return before == nullptr ? 0 : before->side;
}

/// A product that is larger by this factor is larger however it was rounded.
constexpr Real kSurelyMore = 1 + 1e-9;

/// The bound of a particle, `before` [m] the mean plane of face f, that closes on it: to half a
/// radius of overlap, or half a radius more, of faces that hold less than a radius half of that.
/// What would allow more than `longest` need not be near, nor listed. On an open surface it closes
/// from both sides, and where it touches either way.
template <int Dim>
void limit_by_speed(const Entities<Dim>& entities, std::size_t f, const Present<Dim>& now,
                    Real before, Real longest, StepLimit& step_limit) {
  const auto& plane = entities.planes[f];
  const Vec<Dim> relative = now.v - entities.face_velocity(f);
  const Real r = now.particle.radius;
  Real closing = -relative.dot(plane.normal);
  if (entities.any_open && entities.faces[f].open) {
    if (std::fabs(before) <= r) closing = std::fabs(closing);
    if (before < -r) closing = -closing;
    before = std::fabs(before);
  }
  const Real way =
      std::max(before - r - plane.warp, 0.0) + 0.5 * std::min(r, entities.faces[f].half_thickness);
  const Real least = std::min(longest, step_limit.step);
  // Most take longer, which spares the division; one branch for all that bounds no step.
  const bool none =
      !(closing > 0) | (before < -kDepthRadii * r) | (way > closing * least * kSurelyMore);
  if (none) return;
  const Real step = way / closing;
  if (step > least) return;
  if (!now.about.in(entities.boxes[f], r + relative.norm() * longest)) return;
  step_limit.take({step, "contact speed", now.particle.body, now.particle.id});
}

/// Faces that hold a particle behind some, and those before which it is as far as others hold it:
/// beside the edge of a wedge that is thin for it, it is behind the far side, and outside.
/// first, last  of the candidates of its row;  near  out, of room for all;  returns how many
template <int Dim>
std::size_t find_around(const Entities<Dim>& entities, const ParticleRows& rows, std::size_t first,
                        std::size_t last, const Present<Dim>& now, const EvaluationStep& step,
                        LocalIndex* near) {
  const Real farthest = kDepthRadii * now.particle.radius;
  std::size_t n = 0;
  for (std::size_t i = first; i < last; ++i) {
    const std::size_t f = rows.clearances.entity(i);
    const auto& plane = entities.planes[f];
    const auto& box = entities.boxes[f];
    const Real before = plane.normal.dot(now.x - plane.center);
    const bool open = entities.any_open && entities.faces[f].open;
    const bool holds =
        open ? reach_of_open<Dim>(plane, box, now, before,
                                  side_of(step.touches, now.particle, entities.faces[f]))
                   .any
             : plane.area > 0 && std::fabs(before) <= farthest + plane.warp &&
                   now.about.in(box, farthest);
    near[n] = static_cast<LocalIndex>(f);
    n += holds ? 1 : 0;
  }
  return n;
}

/// Faces that may hold the particle of a row. Where it is before all of them, those farther from it
/// than what still touches are left out: none is a contact, nor nearer than one. Behind some, they
/// tell where the surface is nearest.
template <int Dim>
std::span<const LocalIndex> find_near(const Entities<Dim>& entities, const ParticleRows& rows,
                                      std::size_t row, const Present<Dim>& now,
                                      const EvaluationStep& step,
                                      typename Records<Dim>::Part& part) {
  const auto [first, last] = rows.range(row);
  const std::size_t room = last - first + kLanes;
  if (part.near.size() < 2 * room) part.near.resize(2 * room);
  LocalIndex *near = part.near.data(), *touching = near + room;
  const std::size_t listed = rows.clearances.find_near(first, last, rows.loss, near);
  const Real farthest = (1 + 10 * kTouchingGap) * now.particle.radius;
  // Where nothing is fast enough for the least way no face bounds the step.
  const Real least = 0.5 * std::min(now.particle.radius, entities.shallowest);
  const bool step_limits = !(least > rows.fastest * step.longest * kSurelyMore);
  bool before_all = true;
  std::size_t n_touching = 0;
  for (std::size_t i = 0; i < listed; ++i) {
    const LocalIndex face = near[i];
    const auto f = slot_of(face);
    const auto& plane = entities.planes[f];
    const Real before = plane.normal.dot(now.x - plane.center);
    if (step_limits) limit_by_speed(entities, f, now, before, step.longest, part.step_limit);
    const auto& box = entities.boxes[f];
    const bool open = entities.any_open && entities.faces[f].open;
    const Reach reach =
        open ? reach_of_open<Dim>(plane, box, now, before,
                                  side_of(step.touches, now.particle, entities.faces[f]))
             : reach_of<Dim>(plane, box, now, before);
    before_all &= !reach.any | reach.before;
    touching[n_touching] = face;
    const bool touches = !(now.about.squared_distance(box) > farthest * farthest);
    n_touching += reach.any & touches;
  }
  if (before_all) return {touching, n_touching};
  return {near, find_around(entities, rows, first, last, now, step, near)};
}

/// Adds what of a face is nearest to the particle to part.hits.
template <int Dim>
void add_hit(const Entities<Dim>& entities, std::size_t f, const Present<Dim>& now,
             const EvaluationStep& step, typename Records<Dim>::Part& part) {
  const auto& face = entities.faces[f];
  auto& hit = part.hits.emplace_back(entities.planes[f], now.x);
  hit.node = face.node;
  hit.body = face.body, hit.piece = face.piece;
  hit.open = face.open;
  if (face.open) hit.side = side_of(step.touches, now.particle, face);
  hit.face = static_cast<LocalIndex>(f);
  hit.limit = held_behind(now.particle, face);
}

/// [N/m] what bounds the step of a particle on a face, as if both moved with their mass in series.
/// On a free rigid body others may be as deep in the barrier, as many as its faces have room for:
/// each has its section's part of the body's mass, m''. Springs of all faces at once have a bound
/// of their own, step_limit_of_rigid.
template <int Dim>
Real stiffness_of(const ParticleSpring& spring, Real overlap, const Present<Dim>& now,
                  const ContactFace<Dim>& face, Real mass) {
  const Real tangent = spring.tangent(overlap);
  if (face.compliance == 0) return tangent;
  const Real part = face.areal_mass * section_of<Dim>(now.particle) * now.breadth;
  const Real shared = std::min(mass, in_series(now.mass, part));
  return spring.linear + (tangent - spring.linear) * mass / shared;
}

/// [N] of the dampers: that of a soft layer acts in the layer alone.
template <int Dim>
Real damping_of(const ParticleLaw& law, const ParticleSpring& spring, const ParticleHit<Dim>& hit,
                Real mass, Real closing) {
  if (!law.layer.acts()) return hit.damping * closing;
  const Real part = law.layer.damped(hit.overlap);
  const Real most = spring.linear * law.layer.most_damped(hit.overlap);
  const Real of_layer = damping_coefficient(law.layer_zeta, spring.linear, mass) * closing;
  return std::clamp(part * of_layer, -most, most) + (1 - part) * hit.damping * closing;
}

/// Fills the record of one chosen hit; adds its k/m to the sum that bounds the particle's step.
template <int Dim>
void fill_record(const Entities<Dim>& entities, const Present<Dim>& now, const ParticleLaw& law,
                 Real dt, ParticleHit<Dim>& hit, Real& squared_frequency,
                 ContactRecord<Dim>& record) {
  const auto& nodes = entities.nodes;
  const auto& face = entities.faces[slot_of(hit.face)];
  record.kind = ContactKind::particle_face;
  record.first = now.particle.id, record.second = face.id;
  record.first_place = now.place, record.second_place = hit.face;
  record.lower_body = face.body, record.upper_body = now.particle.body;
  record.normal = hit.direction;
  record.point = hit.nearest.point;
  record.penetration = hit.overlap;
  record.area = section_of<Dim>(now.particle) * now.breadth;
  record.add(now.particle.node, 1);

  Real compliance = 0;  // of the face's mass, [1/kg]
  Vec<Dim> velocity = Vec<Dim>::Zero();
  const bool deforms = face.deforms();
  for (int c = 0; c < face.n_nodes; ++c) {
    const auto k = slot_of(c);
    const auto node = slot_of(face.node[k]);
    const Real w = hit.nearest.weight[k];
    record.add(face.node[k], -w);
    velocity += w * nodes.v[node];
    if (deforms) compliance += w * w / nodes.mass[node];
  }
  if (face.compliance > 0) compliance = face.compliance;
  const Real closing = (velocity - now.v).dot(hit.direction);
  const Real mass = in_series(now.mass, compliance > 0 ? 1 / compliance : 0.0);
  const ParticleSpring spring{law.stiffness * now.breadth,
                              barrier_of(law, now.particle, face) * now.breadth,
                              now.particle.radius, law.layer};
  hit.damping = damping_coefficient(law.zeta, spring.linear, mass);
  record.spring = hit.share * spring.force(hit.overlap);
  record.stored = hit.share * spring.energy(hit.overlap);
  record.damping =
      std::max(hit.share * damping_of(law, spring, hit, mass, closing), -record.spring);
  if (mass > 0) {
    const Real coming = hit.overlap + std::max(closing, 0.0) * dt;
    squared_frequency += hit.share * stiffness_of(spring, coming, now, face, mass) / mass;
  }
}

/// Keeps a contact that pushes a centre behind its face, if the next step may bring that farther
/// than it is held. The next evaluation reports where it was then (contact/contacts/lost.hpp).
/// longest  [s] that the next step may be
template <int Dim>
void note_deep(const Entities<Dim>& entities, const ParticleHit<Dim>& hit, Real longest,
               typename Records<Dim>::Part& part) {
  const auto& record = part.particle_on_face.back();
  const auto& v = entities.nodes.v;
  Vec<Dim> velocity = Vec<Dim>::Zero();  // of the face
  for (std::size_t k = 1; k < slot_of(record.n_nodes); ++k) {
    velocity -= record.weight[k] * v[slot_of(record.node[k])];
  }
  const Vec<Dim> relative = velocity - v[slot_of(record.node[0])];
  const Real closing = relative.dot(hit.direction);
  if (!(closing > 0) || hit.nearest.distance + closing * longest <= hit.limit) return;
  part.deep.push_back({key_of(record), record.lower_body, record.upper_body, hit.direction,
                       hit.nearest.point, velocity, hit.limit});
}

template <int Dim>
void add_friction(const Entities<Dim>& entities, const Present<Dim>& now, const ParticleLaw& law,
                  const ParticleHit<Dim>& hit, const Section& section, Real dt,
                  const BrokenTies<Dim>& broken, FrictionHistory<Dim>& history,
                  typename Records<Dim>::Part& part) {
  const auto& face = entities.faces[slot_of(hit.face)];
  auto& record = part.particle_on_face.back();
  FrictionStep<Dim> step;
  step.laws = &law.laws;
  step.upper = {0, 1, false};
  step.lower = {1, record.n_nodes, section.geometry != Geometry::axisymmetric && !face.rigid()};
  step.point = now.x;
  for (std::size_t i = 0; i < step.weight.size(); ++i) step.weight[i] = std::fabs(record.weight[i]);
  step.area = hit.share;
  step.pressed = hit.share * record.area;
  step.stiffness = law.stiffness * now.breadth;
  step.damping = hit.damping;
  step.dt = dt;
  set_particle_material(entities, now.particle, hit.face, record, step);
  step.before =
      history.of_particle(key_of(record), face.body, face.piece, record.normal, part.past);
  if (broken.any && broken.body == face.body) step.inherited = broken.traction;
  record.friction = static_cast<std::int32_t>(part.frictions.size());
  auto& friction = part.frictions.emplace_back();
  find_friction(entities.nodes, record, step, friction);
  friction.body = face.body, friction.piece = face.piece;
  heat_particle(now.particle, face, step, part);
}

template <int Dim>
void record_hits(const Entities<Dim>& entities, const Present<Dim>& now, PairFinder& pairs,
                 const Section& section, const EvaluationStep& step, const BrokenTies<Dim>& broken,
                 FrictionHistory<Dim>* history, ParticleLoad& load,
                 typename Records<Dim>::Part& part) {
  const Real dt = step.dt;
  const std::size_t first_touch = first_touch_of(now.particle.id, part.particle_touches);
  const bool thin = entities.shallowest < now.particle.radius;
  if (thin) recall_entries(entities, now.particle, step.touches, part.hits);
  choose_hits<Dim>(now.x, now.particle.radius, part.hits);
  track_overlaps<Dim>(entities, now.particle, pairs, step.touches, part);
  if (broken.any) {
    const Real stiffness = broken.stiffness * now.breadth;
    begin_where_held<Dim>(now.particle, broken.body, broken.traction, stiffness, first_touch, part);
  }
  if (thin) remember_entries<Dim>(entities, now.particle, step.touches, first_touch, part);
  if (entities.any_open) remember_sides<Dim>(now.particle, first_touch, part);
  Real& squared_frequency = load.squared_frequency;
  for (auto& hit : part.hits) {
    if (!hit.kept || !hit.pushes || hit.share == 0) continue;
    const auto law =
        law_of(now.particle, entities.faces[slot_of(hit.face)],
               pairs.of(now.particle.body, hit.body), pairs.resting(now.particle.body, hit.body));
    fill_record(entities, now, law, dt, hit, squared_frequency,
                part.particle_on_face.emplace_back());
    if (hit.inside) note_deep(entities, hit, step.longest, part);
    if (law.laws.friction != nullptr && history != nullptr) {
      add_friction(entities, now, law, hit, section, dt, broken, *history, part);
    }
    load.zeta = std::max({load.zeta, law.zeta, law.layer_zeta});
  }
  const Real lag = lag_factor(load.zeta), least = part.step_limit.step;
  // Most steps are longer than one that is known, which spares a root and a division.
  const bool longer = 4 * lag * lag > least * least * squared_frequency * kSurelyMore;
  if (squared_frequency > 0 && !longer && !now.particle.held) {
    const Real step = 2 / std::sqrt(squared_frequency) * lag;
    part.step_limit.take({step, "contact stiffness", now.particle.body, now.particle.id});
  }
}
}  // namespace

template <int Dim>
void evaluate_particles(const Entities<Dim>& entities, const ParticleRows& rows,
                        const Section& section, const EvaluationStep& step,
                        FrictionHistory<Dim>* history, std::span<ParticleLoad> loads,
                        typename Records<Dim>::Part& part) {
  PairFinder pairs(rows.pairs);
  const bool any_ties = !step.touches.ties->empty();
  for (std::size_t row = 0; row < rows.row_clearances.size(); ++row) {
    const bool out_of_touch = rows.loss.leaves(rows.row_clearances[row]);
    if (out_of_touch && !entities.nodes.conduct && !any_ties) continue;
    const LocalIndex place = rows.row_clearances[row].entity;
    const auto& particle = entities.particles[slot_of(place)];
    const bool tied = any_ties && is_tied(step.touches, particle.id);
    if (out_of_touch && !entities.nodes.conduct && !tied) continue;
    const auto node = slot_of(particle.node);
    const Vec<Dim> x = entities.nodes.x[node];
    const Present<Dim> now{particle,
                           place,
                           x,
                           entities.nodes.v[node],
                           BoxQuery<Dim>(x),
                           entities.nodes.mass[node],
                           section.breadth(x[0])};
    part.hits.clear();
    const PartEnds ends{part.particle_on_face.size(), part.particle_heat.size()};
    for (const LocalIndex f : find_near<Dim>(entities, rows, row, now, step, part)) {
      add_hit(entities, slot_of(f), now, step, part);
    }
    ParticleLoad load;
    BrokenTies<Dim> broken;
    if (tied) {
      load.squared_frequency =
          hold_particle<Dim>(entities, place, pairs, section_of<Dim>(particle) * now.breadth,
                             section, step, broken, part);
    }
    if (!part.hits.empty()) {
      record_hits(entities, now, pairs, section, step, broken, history, load, part);
    }
    if (broken.any) {
      settle_broken<Dim>(entities, broken, std::span(part.particle_on_face).subspan(ends.record),
                         step.dt, part, part.particle_losses);
    }
    if (step.touches.time_zero && rows.pairs.holds()) {
      begin_particle_ties<Dim>(entities, particle, pairs, section_of<Dim>(particle) * now.breadth,
                               part);
    }
    if (tied) {
      std::sort(part.particle_on_face.begin() + static_cast<std::ptrdiff_t>(ends.record),
                part.particle_on_face.end(),
                [](const auto& a, const auto& b) { return key_of(a) < key_of(b); });
    }
    if (entities.nodes.conduct) {
      load.on_faces = load.heat_contacts = add_particle_heat<Dim>(
          entities, rows, row, pairs, section_of<Dim>(particle) * now.breadth, ends, part);
    }
    if (!loads.empty()) loads[slot_of(place)] = load;
  }
}

template void evaluate_particles<2>(const Entities<2>&, const ParticleRows&, const Section&,
                                    const EvaluationStep&, FrictionHistory<2>*,
                                    std::span<ParticleLoad>, Records<2>::Part&);
template void evaluate_particles<3>(const Entities<3>&, const ParticleRows&, const Section&,
                                    const EvaluationStep&, FrictionHistory<3>*,
                                    std::span<ParticleLoad>, Records<3>::Part&);

}  // namespace brunt
