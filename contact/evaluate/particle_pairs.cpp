#include <algorithm>
#include <cmath>

#include "contact/evaluate/evaluate.hpp"
#include "contact/law/springs.hpp"

namespace brunt {

namespace {
/// Two particles that touch or near each other, seen from the first.
template <int Dim>
struct PresentPair {
  const PairCandidate& candidate;
  const ContactParticle &first, &second;
  const ParticleMeeting<Dim>& meeting;
  Real mass;     // [kg] of both in series
  Real breadth;  // [m]
  ParticleSpring spring;
};

template <int Dim>
PresentPair<Dim> present(const Entities<Dim>& entities, const PairCandidate& candidate,
                         const ParticleMeeting<Dim>& meeting, const Section& section) {
  const auto& nodes = entities.nodes;
  const auto& first = entities.particles[slot_of(candidate.particle)];
  const auto& second = entities.particles[slot_of(candidate.other)];
  const auto a = slot_of(first.node), b = slot_of(second.node);
  const Real breadth = section.breadth_of_particle(nodes.x[a][0], first.radius);
  return {candidate,
          first,
          second,
          meeting,
          in_series(nodes.mass[a], nodes.mass[b]),
          breadth,
          {candidate.stiffness * breadth, candidate.barrier * breadth,
           0.5 * (first.radius + second.radius)}};
}

template <int Dim>
Real section_of(const ContactParticle& particle, Real breadth) {
  return std::pow(2 * particle.radius, Dim - 1) * breadth;
}

bool touches_for_heat(const PairCandidate& candidate, Real overlap, Real radius) {
  if (candidate.laws.heat == nullptr) return false;
  return overlap >= -std::max(kTouchingGap * 2 * radius, gap_of(*candidate.laws.heat));
}

/// The record of a pair, and the coefficient of its damper [N s/m].
template <int Dim>
ContactRecord<Dim> record_of(const Entities<Dim>& entities, const PresentPair<Dim>& pair,
                             Real& damper) {
  const auto& [candidate, first, second, meeting, mass, breadth, spring] = pair;
  ContactRecord<Dim> record;
  record.kind = ContactKind::particle_particle;
  record.first = first.id, record.second = second.id;
  record.first_place = candidate.particle, record.second_place = candidate.other;
  record.lower_body = first.body, record.upper_body = second.body;
  record.normal = meeting.normal;
  const Real share = first.radius / (first.radius + second.radius);
  record.point = entities.nodes.x[slot_of(first.node)] + share * meeting.distance * meeting.normal;
  record.penetration = meeting.overlap;
  record.area = std::min(section_of<Dim>(first, breadth), section_of<Dim>(second, breadth));
  record.add(first.node, -1);
  record.add(second.node, 1);
  damper = damping_coefficient(candidate.zeta, spring.linear, mass);
  record.spring = spring.force(meeting.overlap);
  record.stored = spring.energy(meeting.overlap);
  record.damping = std::max(damper * meeting.closing, -record.spring);
  return record;
}

/// Spin of the material between two particles, of each by its radius.
template <int Dim>
Vec3 spin_between(const ContactNodes<Dim>& nodes, const ContactParticle& a,
                  const ContactParticle& b) {
  const Vec3 &of_a = nodes.spin[slot_of(a.node)], &of_b = nodes.spin[slot_of(b.node)];
  return (a.radius * of_a + b.radius * of_b) / (a.radius + b.radius);
}

template <int Dim>
void add_friction(const Entities<Dim>& entities, const PresentPair<Dim>& pair, Real damper, Real dt,
                  FrictionHistory<Dim>& history, typename Records<Dim>::Part& part) {
  const auto& [candidate, first, second, meeting, mass, breadth, spring] = pair;
  auto& record = part.two_particles.back();
  const BodyTurn<Dim> turn(spin_between(entities.nodes, first, second), dt);
  FrictionStep<Dim> step;
  step.laws = &candidate.laws;
  step.lower = {0, 1, false};
  step.upper = {1, 2, false};
  step.weight[0] = step.weight[1] = 1;
  // Torques are reported on the pair's first body, and it feels the force at its particle.
  const auto& reported = first.body <= second.body ? first : second;
  step.point = entities.nodes.x[slot_of(reported.node)];
  step.area = 1;
  step.pressed = record.area;
  step.stiffness = spring.linear;
  step.damping = damper;
  step.dt = dt;
  step.turn = &turn;
  set_pair_material(entities, first, second, record, step);
  step.before = history.of_faces(key_of(record), part.past);
  record.friction = static_cast<std::int32_t>(part.frictions.size());
  find_friction(entities.nodes, record, step, part.frictions.emplace_back());
  heat_pair(first, second, step, part);
}

/// The way of heat from the first to the second; its sides are not known yet.
template <int Dim>
PairHeatPath<Dim> heat_path(const PresentPair<Dim>& pair, std::size_t candidate, Real pressure) {
  const auto &first = pair.first, &second = pair.second;
  PairHeatPath<Dim> heat;
  heat.flow.key = {ContactKind::particle_particle, 0, first.id, second.id};
  heat.flow.lower_body = first.body, heat.flow.upper_body = second.body;
  heat.flow.lower = {0, first.surface, first.specific_heat};
  heat.flow.upper = {0, second.surface, second.specific_heat};
  heat.flow.n_nodes = 2;
  heat.flow.node[0] = first.node, heat.flow.node[1] = second.node;
  heat.flow.weight[0] = -1, heat.flow.weight[1] = 1;
  const Real conductance = conductance_of(*pair.candidate.laws.heat, pressure);
  heat.per_area = 1 / (1 / conductance + first.radius / first.matter->conductivity +
                       second.radius / second.matter->conductivity);
  heat.candidate = candidate;
  return heat;
}

/// [m] of an overlap of which contact takes no notice since time 0, or since one was born; what is
/// left of it goes to `touches`.
template <int Dim>
Real overlap_kept(const TouchStep& step, const PresentPair<Dim>& pair,
                  std::vector<FirstTouch>& touches) {
  const ContactKey key = touch_key(ContactKind::particle_particle, pair.first.id, pair.second.id);
  const Real overlap = std::max(pair.meeting.overlap, 0.0);
  Real kept = 0;
  const bool born = pair.first.born || pair.second.born;
  if (step.time_zero || born) {
    const Real rounding = kTouchingGap * 2 * pair.spring.radius;
    const auto law = born ? InitialOverlap::track : pair.candidate.laws.initial_overlap;
    kept = ignored_overlap(law, overlap, rounding);
  } else if (const auto* before = step.before->find(key)) {
    kept = std::min(before->overlap, overlap);
  }
  if (kept > 0) touches.push_back({key, kept});
  return kept;
}

/// Bound of the step by a pair that closes in.
template <int Dim>
void limit_by_speed(const PresentPair<Dim>& pair, StepLimit& step_limit) {
  const auto& meeting = pair.meeting;
  if (!(meeting.closing > 0)) return;
  const Real gap = std::max(-meeting.overlap, 0.0);
  const Real room = gap + 0.5 * std::min(pair.first.radius, pair.second.radius);
  step_limit.take({room / meeting.closing, "contact speed", pair.first.body, pair.first.id});
}

/// What stands behind each contact of a particle for heat: its section belongs to the contacts
/// with one body together, its capacity to all.
template <int Dim>
void share_sides(const Entities<Dim>& entities, std::size_t begin,
                 std::span<const PairCandidate> row, const PairRows& rows, Real breadth,
                 std::span<const ParticleMeeting<Dim>> meetings, ParticleLoad& load) {
  const auto& own = entities.particles[slot_of(row[0].particle)];
  const Real capacity = entities.nodes.capacity[slot_of(own.node)];
  const auto other = [&](std::size_t c) -> const ContactParticle& {
    return entities.particles[slot_of(row[c].other)];
  };
  const auto touches = [&](std::size_t c) {
    return touches_for_heat(row[c], meetings[c].overlap, 0.5 * (own.radius + other(c).radius));
  };
  for (std::size_t c = 0; c < row.size(); ++c) load.heat_contacts += touches(c) ? 1 : 0;
  for (std::size_t c = 0; c < row.size(); ++c) {
    int with_body = 0;
    for (std::size_t k = 0; k < row.size(); ++k) {
      const bool same = other(k).body == other(c).body && other(k).piece == other(c).piece;
      with_body += same && touches(k) ? 1 : 0;
    }
    const bool touching = touches(c);
    rows.sides[begin + c] = {touching ? section_of<Dim>(own, breadth) / with_body : 0.0,
                             touching ? capacity / load.heat_contacts : 0.0};
  }
}
}  // namespace

template <int Dim>
void evaluate_pairs(const Entities<Dim>& entities, const PairRows& rows, const Section& section,
                    const EvaluationStep& step, FrictionHistory<Dim>* history,
                    typename Records<Dim>::Part& part) {
  const auto& nodes = entities.nodes;
  const auto& starts = rows.starts;
  for (std::size_t s = 0; s + 1 < starts.size(); ++s) {
    const auto row = rows.candidates.subspan(starts[s], starts[s + 1] - starts[s]);
    const auto own = slot_of(row[0].particle);
    const auto& particle = entities.particles[own];
    const auto at = slot_of(particle.node);
    ParticleLoad& load = rows.loads[own];
    bool any = false;
    part.meetings.clear();
    for (std::size_t c = 0; c < row.size(); ++c) {
      const auto& other = entities.particles[slot_of(row[c].other)];
      const auto to = slot_of(other.node);
      auto& meeting = part.meetings.emplace_back(Vec<Dim>(nodes.x[to] - nodes.x[at]),
                                                 Vec<Dim>(nodes.v[to] - nodes.v[at]),
                                                 particle.radius + other.radius);
      const bool is_lower = row[c].particle < row[c].other;
      const Real coming = meeting.overlap + std::max(meeting.closing, 0.0) * step.dt;
      const bool conducts =
          touches_for_heat(row[c], meeting.overlap, 0.5 * (particle.radius + other.radius));
      any = any || conducts;
      const bool near = -meeting.overlap <= meeting.closing * step.longest;
      if (!(coming > 0) && !conducts && !near) continue;
      const auto pair = present<Dim>(entities, row[c], meeting, section);
      if (coming > 0 && pair.mass > 0 && !particle.held) {
        load.squared_frequency += pair.spring.tangent(coming) / pair.mass;
        load.zeta = std::max(load.zeta, row[c].zeta);
      }
      if (!is_lower) continue;
      meeting.overlap -= overlap_kept(step.touches, pair, part.pair_touches);
      if (near) limit_by_speed(pair, part.step_limit);
      Real damper = 0, pressure = 0;
      if (meeting.overlap > 0) {
        const auto& record = part.two_particles.emplace_back(record_of(entities, pair, damper));
        pressure = (record.spring + record.damping) / record.area;
      }
      if (conducts) part.pair_heat.push_back(heat_path(pair, starts[s] + c, pressure));
      if (!(meeting.overlap > 0)) continue;
      if (row[c].laws.friction != nullptr && history != nullptr) {
        add_friction(entities, pair, damper, step.dt, *history, part);
      }
    }
    if (any) {
      const Real breadth = section.breadth_of_particle(nodes.x[at][0], particle.radius);
      share_sides<Dim>(entities, starts[s], row, rows, breadth, part.meetings, load);
    }
    if (load.squared_frequency > 0) {
      const Real longest = 2 / std::sqrt(load.squared_frequency) * lag_factor(load.zeta);
      part.step_limit.take({longest, "contact stiffness", particle.body, particle.id});
    }
  }
}

template void evaluate_pairs<2>(const Entities<2>&, const PairRows&, const Section&,
                                const EvaluationStep&, FrictionHistory<2>*, Records<2>::Part&);
template void evaluate_pairs<3>(const Entities<3>&, const PairRows&, const Section&,
                                const EvaluationStep&, FrictionHistory<3>*, Records<3>::Part&);

}  // namespace brunt
// Tested by tests/unit/contact/particle_pair_test.cpp.
