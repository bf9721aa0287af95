#include <algorithm>
#include <cmath>
#include <optional>

#include "contact/evaluate/near_faces.hpp"
#include "contact/evaluate/particle_law.hpp"
#include "contact/evaluate/particle_returns.hpp"
#include "contact/evaluate/particle_touches.hpp"
#include "contact/evaluate/ties.hpp"

namespace brunt {

namespace {
/// Adds what of a face is nearest to the particle to part.hits.
template <int Dim>
void add_hit(const Entities<Dim>& entities, const Present<Dim>& now, const NearestPoint<Dim>& found,
             const FacePlane<Dim>& plane, const EvaluationStep& step,
             typename Records<Dim>::Part& part) {
  const auto f = static_cast<std::size_t>(&plane - entities.planes.data());
  const auto& face = entities.faces[f];
  auto& hit = part.hits.emplace_back(plane, found, face.node, face.body, face.piece, face.open,
                                     static_cast<LocalIndex>(f));
  if (face.open) hit.side = side_of(step.touches, now.particle, face);
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

/// [1/kg] of the face's mass where the particle is.
template <int Dim>
Real compliance_of(const std::vector<Real>& mass, const ContactFace<Dim>& face,
                   const ParticleHit<Dim>& hit) {
  const auto& w = hit.nearest.weight;
  const auto at = [&](std::size_t k) { return mass[slot_of(face.node[k])]; };
  if constexpr (Dim == 3) {
    if (face.n_nodes == 4) {
      const Pack weight = load(w.data());
      const Pack of = weight * weight / Pack{at(0), at(1), at(2), at(3)};
      return of[0] + of[1] + of[2] + of[3];
    }
  }
  Real compliance = 0;
  for (std::size_t k = 0; k < slot_of(face.n_nodes); ++k) compliance += w[k] * w[k] / at(k);
  return compliance;
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
  record.node[0] = now.particle.node, record.weight[0] = 1;
  record.n_nodes = 1 + face.n_nodes;

  Vec<Dim> velocity = Vec<Dim>::Zero();
  for (std::size_t k = 0; k < slot_of(face.n_nodes); ++k) {
    const Real w = hit.nearest.weight[k];
    record.node[k + 1] = face.node[k], record.weight[k + 1] = -w;
    velocity += w * nodes.v[slot_of(face.node[k])];
  }
  Real compliance = face.deforms() ? compliance_of<Dim>(nodes.mass, face, hit) : 0.0;
  if (face.compliance > 0) compliance = face.compliance;
  const Real closing = (velocity - now.v).dot(hit.direction);
  const Real mass = in_series(now.mass, compliance > 0 ? 1 / compliance : 0.0);
  const Real coming = hit.overlap + std::max(closing, 0.0) * dt;
  // The barrier acts behind the face alone, where few are.
  const bool behind = hit.overlap > now.particle.radius || coming > now.particle.radius;
  const Real barrier = behind ? barrier_of(law, now.particle, face) * now.breadth : 0.0;
  const ParticleSpring spring{law.stiffness * now.breadth, barrier, now.particle.radius, law.layer};
  hit.damping = damping_coefficient(law.zeta, spring.linear, mass);
  record.spring = hit.share * spring.force(hit.overlap);
  record.stored = hit.share * spring.energy(hit.overlap);
  record.damping =
      std::max(hit.share * damping_of(law, spring, hit, mass, closing), -record.spring);
  if (mass > 0) {
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
                 ParticleLaws<Dim>& laws, const Section& section, const EvaluationStep& step,
                 const BrokenTies<Dim>& broken, FrictionHistory<Dim>* history, ParticleLoad& load,
                 typename Records<Dim>::Part& part) {
  const Real dt = step.dt;
  const std::size_t first_touch = first_touch_of(now.particle.id, part.particle_touches);
  const bool thin = entities.shallowest < now.particle.radius;
  if (thin) recall_entries(entities, now.particle, step.touches, part.hits);
  if (section.geometry == Geometry::axisymmetric) join_at_axis(now.particle.radius, part.hits);
  choose_hits<Dim>(now.x, now.particle.radius, part.hits);
  mark_returns<Dim>(entities, now, section, step, part.hits);
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
    const auto& law = laws.of(now.particle, entities.faces[slot_of(hit.face)]);
    fill_record(entities, now, law, dt, hit, squared_frequency,
                part.particle_on_face.emplace_back());
    if (hit.inside) note_deep(entities, hit, step.longest, part);
    if (law.laws.friction != nullptr && history != nullptr) {
      add_friction(entities, now, law, hit, section, dt, broken, *history, part);
    }
    load.zeta = std::max(std::max(load.zeta, law.zeta), law.layer_zeta);
  }
  const Real lag = laws.lag(load.zeta), least = part.step_limit.step;
  // Most steps are longer than one that is known, which spares a root and a division.
  const bool longer = 4 * lag * lag > least * least * squared_frequency * kSurelyMore;
  if (squared_frequency > 0 && !longer && !now.particle.held) {
    const Real step = 2 / std::sqrt(squared_frequency) * lag;
    part.step_limit.take({step, "contact stiffness", now.particle.body, now.particle.id});
  }
}

/// A row whose particle may touch faces, or is tied.
template <int Dim>
struct PresentRow {
  PresentRow(const Entities<Dim>& entities, const Section& section, LocalIndex place)
      : now(entities, section, place) {}
  Present<Dim> now;
  std::size_t row = 0;
  bool tied = false;
  std::size_t n_faces = 0;  // of the queries of all rows
};

/// What evaluates the particles of a part.
template <int Dim>
class ParticleWork {
 public:
  ParticleWork(const Entities<Dim>& entities, const ParticleRows& rows, const Section& section,
               const EvaluationStep& step, FrictionHistory<Dim>* history,
               std::span<ParticleLoad> loads, typename Records<Dim>::Part& part)
      : entities_(entities),
        rows_(rows),
        section_(section),
        step_(step),
        history_(history),
        loads_(loads),
        part_(part),
        pairs_(rows.pairs),
        laws_(rows.pairs) {}
  /// Finds near faces row by row, then what is nearest of all of them at once.
  void run() {
    const bool any_ties = !step_.touches.ties->empty(), conduct = entities_.nodes.conduct;
    for (std::size_t row = 0; row < rows_.row_clearances.size(); ++row) {
      const auto& clearance = rows_.row_clearances[row];
      const bool out_of_touch = rows_.loss.leaves(clearance);
      if (out_of_touch && !conduct && !any_ties) continue;
      const auto& particle = entities_.particles[slot_of(clearance.entity)];
      const bool tied = any_ties && is_tied(step_.touches, particle.id);
      if (out_of_touch && !conduct && !tied) continue;
      PresentRow<Dim>& one = present_[n_present_++].emplace(entities_, section_, clearance.entity);
      one.row = row, one.tied = tied;
      const auto near = find_near<Dim>(entities_, rows_, row, one.now, step_, part_);
      one.n_faces = near.size();
      for (const LocalIndex f : near) {
        part_.queries.push_back({&entities_.planes[slot_of(f)], one.now.x});
      }
      if (n_present_ == kAtOnce) evaluate();
    }
    evaluate();
  }

 private:
  /// So many that few are left alone at the end, and what is found of them stays in the cache.
  static constexpr std::size_t kAtOnce = 16;

  void evaluate() {
    auto& queries = part_.queries;
    auto& nearest = part_.nearest;
    if (nearest.size() < queries.size()) nearest.resize(2 * queries.size());
    nearest_points<Dim>(queries, nearest.data());
    std::size_t first = 0;
    for (std::size_t k = 0; k < n_present_; ++k) {
      const PresentRow<Dim>& one = *present_[k];
      part_.hits.clear();
      for (std::size_t i = first; i < first + one.n_faces; ++i) {
        add_hit(entities_, one.now, nearest[i], *queries[i].face, step_, part_);
      }
      first += one.n_faces;
      evaluate(one);
    }
    n_present_ = 0, queries.clear();
  }

  void evaluate(const PresentRow<Dim>& one) {
    const auto& now = one.now;
    const Real section = section_of<Dim>(now.particle) * now.breadth;
    const PartEnds ends{part_.particle_on_face.size(), part_.particle_heat.size()};
    ParticleLoad load;
    BrokenTies<Dim> broken;
    if (one.tied) {
      load.squared_frequency =
          hold_particle<Dim>(entities_, now.place, pairs_, section, section_, step_, broken, part_);
    }
    if (!part_.hits.empty()) {
      record_hits(entities_, now, pairs_, laws_, section_, step_, broken, history_, load, part_);
    }
    if (broken.any) {
      settle_broken<Dim>(entities_, broken, std::span(part_.particle_on_face).subspan(ends.record),
                         step_.dt, part_, part_.particle_losses);
    }
    if (step_.touches.time_zero && rows_.pairs.holds()) {
      begin_particle_ties<Dim>(entities_, now.particle, pairs_, section, part_);
    }
    if (one.tied) {
      std::sort(part_.particle_on_face.begin() + static_cast<std::ptrdiff_t>(ends.record),
                part_.particle_on_face.end(),
                [](const auto& a, const auto& b) { return key_of(a) < key_of(b); });
    }
    if (entities_.nodes.conduct) {
      load.on_faces = load.heat_contacts =
          add_particle_heat<Dim>(entities_, rows_, one.row, pairs_, section_, ends, part_);
    }
    if (!loads_.empty()) loads_[slot_of(now.place)] = load;
  }

  const Entities<Dim>& entities_;
  const ParticleRows& rows_;
  const Section& section_;
  const EvaluationStep& step_;
  FrictionHistory<Dim>* history_;
  std::span<ParticleLoad> loads_;
  typename Records<Dim>::Part& part_;
  PairFinder pairs_;
  ParticleLaws<Dim> laws_;
  std::array<std::optional<PresentRow<Dim>>, kAtOnce> present_;
  std::size_t n_present_ = 0;
};
}  // namespace

template <int Dim>
void evaluate_particles(const Entities<Dim>& entities, const ParticleRows& rows,
                        const Section& section, const EvaluationStep& step,
                        FrictionHistory<Dim>* history, std::span<ParticleLoad> loads,
                        typename Records<Dim>::Part& part) {
  ParticleWork<Dim>(entities, rows, section, step, history, loads, part).run();
}

template void evaluate_particles<2>(const Entities<2>&, const ParticleRows&, const Section&,
                                    const EvaluationStep&, FrictionHistory<2>*,
                                    std::span<ParticleLoad>, Records<2>::Part&);
template void evaluate_particles<3>(const Entities<3>&, const ParticleRows&, const Section&,
                                    const EvaluationStep&, FrictionHistory<3>*,
                                    std::span<ParticleLoad>, Records<3>::Part&);

}  // namespace brunt
