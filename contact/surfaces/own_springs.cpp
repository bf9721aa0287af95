#include "contact/surfaces/own_springs.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "contact/law/springs.hpp"

namespace brunt {

namespace {
/// [1] Stiffness of contact and that of the particle's neighbours, which add up: theirs is 24 of
/// its own springs where the step is 0.41 dp/c, and their bound is another's matter as long as
/// contact is much softer. Between 10 and 20, where both bounds meet, it fades in: without it
/// particles on a held knife made a third of their energy at 20.
Real with_own(Real phi) {
  constexpr Real kOwn = 24, kFrom = 10, kWhole = 20;
  return phi + kOwn * std::clamp((phi - kFrom) / (kWhole - kFrom), 0.0, 1.0);
}
}  // namespace

template <int Dim>
void set_limits_of_particles(const PairTable& pairs, const Section& section,
                             const RigidSprings& rigid, Entities<Dim>& entities) {
  const bool rings = section.geometry == Geometry::axisymmetric;
  std::map<Label, PairOptions> options;
  for (const auto& particle : entities.particles) {
    const Real mass = entities.nodes.mass[slot_of(particle.node)];
    if (!(mass > 0) || particle.held) continue;
    auto it = options.find(particle.body);
    if (it == options.end()) {
      it = options.emplace(particle.body, pairs.strongest(particle.body)).first;
    }
    const Real k = with_own(it->second.stiffness) * particle.matter->modulus *
                   (Dim == 3 ? 2 * particle.radius : 1.0);
    if (!(k > 0)) continue;
    const Real recoil = rigid.recoil_beside(particle.body);
    const Real zeta = recoil_damping(it->second.damping, recoil);
    const Real step = 2 * std::sqrt(mass / (k * recoil_factor(recoil))) * lag_factor(zeta);
    const ParticleLimit limit{
        particle.node, particle.radius, {step, "contact stiffness", particle.body, particle.id}};
    if (rings) {
      entities.rings.push_back(limit);
    } else {
      entities.constant_limit.take(limit.at(section.breadth(0)));
    }
  }
}

template <int Dim>
StepLimit limit_of_rings(const Entities<Dim>& entities) {
  const Section section{Geometry::axisymmetric, 0};
  StepLimit limit;
  for (const auto& ring : entities.rings) {
    const Real r = entities.nodes.x[slot_of(ring.node)][0];
    limit.take(ring.at(section.breadth_of_particle(r, ring.radius)));
  }
  return limit;
}

namespace {
/// What touches a body with free rigid faces.
struct Touching {
  Real soft = 0;  // [Pa/m] stiffest spring of what deforms, times its pair's stiffness
  Real hard = 0;  // [1] stiffness of its pairs with rigid bodies
};

/// [Pa/m] stiffest spring of each body of elements or particles.
template <int Dim>
std::map<Label, Real> stiffest_of(const Entities<Dim>& entities) {
  std::map<Label, Real> stiffest;
  const auto take = [&](Label body, Real k) {
    auto& most = stiffest[body];
    most = std::max(most, k);
  };
  for (const auto& face : entities.faces) {
    if (face.deforms()) take(face.body, face.stiffness);
  }
  for (const auto& one : entities.particles) take(one.body, one.matter->modulus / (2 * one.radius));
  return stiffest;
}

/// By body of free rigid faces, what may touch it; notes its neighbours that deform.
template <int Dim>
std::map<Label, Touching> touching_of(const PairTable& pairs, const Entities<Dim>& entities,
                                      std::set<Label>& neighbours) {
  std::set<Label> stiff;
  std::map<Label, Touching> touching;
  for (const auto& face : entities.faces) {
    if (face.deforms()) continue;
    stiff.insert(face.body);
    if (face.compliance > 0) touching[face.body];
  }
  const auto stiffest = stiffest_of(entities);
  for (const auto& [a, b] : pairs.pairs()) {
    const Real phi = pairs.stiffness(a, b);
    for (const auto& [body, other] : {std::pair(a, b), std::pair(b, a)}) {
      const auto it = touching.find(body);
      if (it == touching.end()) continue;
      if (stiff.count(other) != 0) it->second.hard = std::max(it->second.hard, phi);
      const auto soft = stiffest.find(other);
      if (soft == stiffest.end()) continue;
      it->second.soft = std::max(it->second.soft, phi * soft->second);
      neighbours.insert(other);
    }
  }
  return touching;
}

/// [m^2] of a face, or of the largest particle on it; about the axis the whole ring.
template <int Dim>
Real area_of(const Section& section, const Entities<Dim>& entities, const ContactFace<Dim>& face) {
  Real middle = 0;  // [m] x of the face
  for (int c = 0; c < face.n_nodes; ++c) {
    const auto node = slot_of(face.node[slot_of(c)]);
    middle += entities.nodes.x[node][0] / face.n_nodes;
  }
  return std::max(face.area_start, face.footprint) * section.breadth(std::fabs(middle));
}
}  // namespace

template <int Dim>
RigidSprings springs_of_rigid(const PairTable& pairs, const Section& section,
                              const Entities<Dim>& entities) {
  struct Springs {
    Label body = 0;
    Real squared_frequency = 0, damping = 0;  // [1/s^2], [1/s] c/m
  };
  RigidSprings rigid;
  const auto touching = touching_of(pairs, entities, rigid.neighbours);
  std::map<Label, Springs> pieces;
  for (const auto& face : entities.faces) {
    if (!(face.compliance > 0)) continue;
    const auto& by = touching.at(face.body);
    const Real k = std::max(by.soft, by.hard * face.stiffness);
    const Real area = area_of(section, entities, face);
    // Where a particle is larger than the face its springs may all stand at one place.
    const bool even = face.mean_compliance > 0 && face.footprint <= face.area_start;
    const Real compliance = even ? face.mean_compliance : face.compliance;
    auto& piece = pieces[face.piece];
    piece.body = face.body;
    piece.squared_frequency += k * area * compliance;
    piece.damping += damping_coefficient(face.zeta, k, face.areal_mass) * area * compliance;
  }
  // Those of rings would be others after a restart.
  const Real others = std::min(entities.longest_step, entities.constant_limit.step);
  for (const auto& [piece, springs] : pieces) {
    const Real frequency = std::sqrt(springs.squared_frequency);
    if (!(frequency > 0)) continue;
    const Real zeta = springs.damping / (2 * frequency);
    Real step = 2 / frequency * lag_factor(zeta);
    if (touching.at(springs.body).soft > 0) {
      step *= std::sqrt(kMostRecoil);
      rigid.recoil = std::max(rigid.recoil, 0.25 * springs.squared_frequency * others * others);
    }
    rigid.step_limit.take({step, "contact stiffness", springs.body, piece});
  }
  return rigid;
}

template void set_limits_of_particles(const PairTable&, const Section&, const RigidSprings&,
                                      Entities<2>&);
template void set_limits_of_particles(const PairTable&, const Section&, const RigidSprings&,
                                      Entities<3>&);
template StepLimit limit_of_rings(const Entities<2>&);
template StepLimit limit_of_rings(const Entities<3>&);
template RigidSprings springs_of_rigid<2>(const PairTable&, const Section&, const Entities<2>&);
template RigidSprings springs_of_rigid<3>(const PairTable&, const Section&, const Entities<3>&);

}  // namespace brunt
