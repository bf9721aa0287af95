/// Where heat passes between what touches, and what friction heats.
#include <algorithm>
#include <cmath>

#include "contact/evaluate/evaluate.hpp"
#include "contact/evaluate/particle_law.hpp"

namespace brunt {

template <int Dim>
void add_face_heat(const Entities<Dim>& entities, const FaceCandidate& candidate,
                   const Section& section, const PartEnds& ends,
                   typename Records<Dim>::Part& part) {
  const auto l = slot_of(candidate.lower);
  const auto u = slot_of(candidate.upper);
  const Real meets = meeting_distance(entities.planes[l], entities.planes[u]);
  // Faces that are held together touch, however their springs give.
  const bool bonded = part.face_on_face.size() > ends.record && part.face_on_face.back().bonded;
  const Real least = bonded && candidate.laws.holds != nullptr ? candidate.normal.limit : meets;
  const PlaneNeeds needs{
      .middle = true, .opening = std::max(least, gap_of(*candidate.laws.heat)), .pushes = false};
  Planes<Dim> planes;
  const int n = common_planes<Dim>(entities.planes[l], entities.planes[u], section, planes, needs);
  const auto middle = static_cast<std::ptrdiff_t>(part.face_heat.size());
  for (int i = 0; i < n; ++i) {
    const auto& plane = planes[slot_of(i)];
    if (plane.penetration - needs.opening > candidate.normal.limit) continue;
    Real pressed = 0, pressure = 0;
    for (std::size_t r = ends.record; r < part.face_on_face.size(); ++r) {
      const auto& record = part.face_on_face[r];
      if (record.ordinal != plane.ordinal) continue;
      pressed = std::min(record.area, plane.area);
      pressure = std::max((record.spring + record.damping) / record.area, 0.0);
    }
    part.face_heat.push_back(heat_path<Dim>(entities.faces[l], entities.faces[u], plane,
                                            *candidate.laws.heat, pressed, pressure));
  }
  // What passes has smaller ordinals than the heat of friction.
  std::rotate(part.face_heat.begin() + static_cast<std::ptrdiff_t>(ends.flow),
              part.face_heat.begin() + middle, part.face_heat.end());
}

namespace {
/// Faces that are near enough to the particle for heat, by the gaps of their pairs, and what of
/// them it is nearest to: a function of the state, whatever else the lists hold.
template <int Dim>
void find_near_faces(const Entities<Dim>& entities, const ParticleRows& rows, std::size_t row,
                     PairFinder& pairs, const Section& section,
                     std::vector<ParticleHit<Dim>>& hits) {
  hits.clear();
  const auto& particle = entities.particles[slot_of(rows.row_clearances[row].entity)];
  const Vec<Dim>& x = entities.nodes.x[slot_of(particle.node)];
  const Real meets = kMeets * particle.radius;
  Real widest = 0;
  const auto [first, last] = rows.range(row);
  for (std::size_t i = first; i < last; ++i) {
    const std::size_t f = rows.clearances.entity(i);
    const auto& face = entities.faces[f];
    const auto* heat = heat_between(particle, face, pairs.of(particle.body, face.body));
    if (heat == nullptr) continue;
    widest = std::max(widest, gap_of(*heat));
    if (entities.planes[f].area == 0) continue;
    const Real reach = particle.radius + std::max(gap_of(*heat), meets);
    const Real limit = held_behind(particle, face);
    const Real farthest = std::max(reach, limit);
    if (!entities.boxes[f].meets(SearchBox<Dim>::about(x, farthest))) continue;
    ParticleHit<Dim> hit(entities.planes[f], x);
    hit.node = face.node;
    hit.body = face.body, hit.piece = face.piece;
    hit.open = face.open;
    hit.limit = limit;
    hit.face = static_cast<LocalIndex>(f);
    const bool behind = hit.nearest.normal.dot(x - hit.nearest.point) < 0;
    if (hit.nearest.distance <= (behind ? farthest : reach)) hits.push_back(hit);
  }
  if (section.geometry == Geometry::axisymmetric) join_at_axis(particle.radius, hits);
  if (!hits.empty()) choose_hits<Dim>(x, particle.radius + std::max(widest, meets), hits);
}
}  // namespace

template <int Dim>
int add_particle_heat(const Entities<Dim>& entities, const ParticleRows& rows, std::size_t row,
                      PairFinder& pairs, const Section& section, const PartEnds& ends,
                      typename Records<Dim>::Part& part) {
  const auto& particle = entities.particles[slot_of(rows.row_clearances[row].entity)];
  const auto& hits = part.near_hits;
  if (!(particle.matter->conductivity > 0)) return 0;
  find_near_faces<Dim>(entities, rows, row, pairs, section, part.near_hits);
  if (hits.empty()) return 0;
  const Real r = entities.nodes.x[slot_of(particle.node)][0];
  const Real area = section_of<Dim>(particle) * section.breadth_of_particle(r, particle.radius);
  const auto contacts =
      std::count_if(hits.begin(), hits.end(), [](const auto& hit) { return hit.kept; });
  for (const auto& hit : hits) {
    if (!hit.kept) continue;
    const auto& face = entities.faces[slot_of(hit.face)];
    const auto& heat = pairs.of(particle.body, face.body).heat;
    ParticleTouch<Dim> touch{particle, face, hit, area, 0, static_cast<int>(contacts)};
    for (std::size_t r = ends.record; r < part.particle_on_face.size(); ++r) {
      const auto& record = part.particle_on_face[r];
      if (record.second != face.id) continue;
      touch.pressure = (record.spring + record.damping) / (hit.share * area);
    }
    part.particle_heat.push_back(heat_path<Dim>(entities.nodes, touch, heat));
  }
  std::sort(part.particle_heat.begin() + static_cast<std::ptrdiff_t>(ends.flow),
            part.particle_heat.end(), [](const auto& a, const auto& b) { return a.key < b.key; });
  return static_cast<int>(contacts);
}

namespace {
template <int Dim>
void add_friction_heat(const ContactRecord<Dim>& record, const FrictionStep<Dim>& step,
                       const FrictionShares& shares, Friction<Dim>& friction,
                       std::vector<HeatFlow<Dim>>& flows) {
  if (!(step.dt > 0)) return;
  share_heat(step, shares, friction);
  if (friction.heat_share > 0) flows.push_back(heat_of_friction(record, friction, step.dt));
}

template <int Dim>
HeatedSide side_of(const ContactFace<Dim>& face) {
  return {face.body, face.capacity > 0, face.effusivity};
}
}  // namespace

template <int Dim>
void heat_faces(const Entities<Dim>& entities, const FaceCandidate& candidate,
                const FrictionStep<Dim>& step, typename Records<Dim>::Part& part) {
  const auto& lower = entities.faces[slot_of(candidate.lower)];
  const auto& upper = entities.faces[slot_of(candidate.upper)];
  add_friction_heat(part.face_on_face.back(), step,
                    friction_shares(*step.laws->friction_heat, side_of(lower), side_of(upper)),
                    part.frictions.back(), part.face_heat);
}

template <int Dim>
void heat_particle(const ContactParticle& particle, const ContactFace<Dim>& face,
                   const FrictionStep<Dim>& step, typename Records<Dim>::Part& part) {
  const HeatedSide upper{particle.body, particle.matter->conductivity > 0,
                         particle.matter->effusivity};
  add_friction_heat(part.particle_on_face.back(), step,
                    friction_shares(*step.laws->friction_heat, side_of(face), upper),
                    part.frictions.back(), part.particle_heat);
}

template <int Dim>
void heat_pair(const ContactParticle& first, const ContactParticle& second,
               const FrictionStep<Dim>& step, typename Records<Dim>::Part& part) {
  const HeatedSide lower{first.body, first.matter->conductivity > 0, first.matter->effusivity};
  const HeatedSide upper{second.body, second.matter->conductivity > 0, second.matter->effusivity};
  std::vector<HeatFlow<Dim>> flows;
  add_friction_heat(part.two_particles.back(), step,
                    friction_shares(*step.laws->friction_heat, lower, upper), part.frictions.back(),
                    flows);
  for (const auto& flow : flows) part.pair_heat.push_back({flow, 0, 0});
}

template void heat_pair<2>(const ContactParticle&, const ContactParticle&, const FrictionStep<2>&,
                           Records<2>::Part&);
template void heat_pair<3>(const ContactParticle&, const ContactParticle&, const FrictionStep<3>&,
                           Records<3>::Part&);
template void add_face_heat<2>(const Entities<2>&, const FaceCandidate&, const Section&,
                               const PartEnds&, Records<2>::Part&);
template int add_particle_heat<2>(const Entities<2>&, const ParticleRows&, std::size_t, PairFinder&,
                                  const Section&, const PartEnds&, Records<2>::Part&);
template void heat_faces<2>(const Entities<2>&, const FaceCandidate&, const FrictionStep<2>&,
                            Records<2>::Part&);
template void heat_particle<2>(const ContactParticle&, const ContactFace<2>&,
                               const FrictionStep<2>&, Records<2>::Part&);
template void add_face_heat<3>(const Entities<3>&, const FaceCandidate&, const Section&,
                               const PartEnds&, Records<3>::Part&);
template int add_particle_heat<3>(const Entities<3>&, const ParticleRows&, std::size_t, PairFinder&,
                                  const Section&, const PartEnds&, Records<3>::Part&);
template void heat_faces<3>(const Entities<3>&, const FaceCandidate&, const FrictionStep<3>&,
                            Records<3>::Part&);
template void heat_particle<3>(const ContactParticle&, const ContactFace<3>&,
                               const FrictionStep<3>&, Records<3>::Part&);

}  // namespace brunt
