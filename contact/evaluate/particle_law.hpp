#pragma once
/// By what law a particle and a face touch: found anew for each contact, as most of what is listed
/// never touches, and reading what was kept of it would be waited for.
#include <algorithm>

#include "contact/geometry/particle_face.hpp"
#include "contact/law/pair_laws.hpp"
#include "contact/law/springs.hpp"
#include "contact/surfaces/entities.hpp"

namespace brunt {

struct ParticleLaw {
  Real stiffness = 0;  ///< [N/m] per breadth
  Real own = 0;        ///< [N/m] phi times the particle's own spring, per breadth
  Real zeta = 0;
  PairLaws laws{};
  SoftLayer layer{};  ///< over the spring, where one body rests on the other
  Real layer_zeta = 0;
};

/// (2 r)^(Dim - 1): the section of a particle per breadth.
template <int Dim>
Real section_of(const ContactParticle& particle) {
  const Real diameter = 2 * particle.radius;
  return Dim == 3 ? diameter * diameter : diameter;
}

template <int Dim>
ParticleLaw law_of(const ContactParticle& particle, const ContactFace<Dim>& face,
                   const PairOptions& options, const RestingLayer& rests) {
  const Real own = particle.matter->modulus * (Dim == 3 ? 2 * particle.radius : 1.0);
  const Real of_face = face.stiffness * section_of<Dim>(particle);
  ParticleLaw law{options.stiffness * contact_spring(own, true, of_face, face.deforms()),
                  options.stiffness * own, options.damping,
                  PairLaws(options, particle.matter->conductivity > 0 && face.capacity > 0)};
  if (rests.acts()) {
    law.layer = rests.over(law.stiffness / section_of<Dim>(particle), 2 * particle.radius);
    law.layer_zeta = RestingLayer::damping_of(options.damping);
  }
  return law;
}

/// Laws of contacts one after another, mostly alike: kept while nothing changes that they are found
/// from, and their factor of the step.
template <int Dim>
class ParticleLaws {
 public:
  explicit ParticleLaws(const PairTable& pairs) : pairs_(pairs) {}
  const ParticleLaw& of(const ContactParticle& particle, const ContactFace<Dim>& face) {
    const Inputs now{
        particle.body,     face.body,       particle.matter->conductivity > 0, face.deforms(),
        face.capacity > 0, particle.radius, particle.matter->modulus,          face.stiffness};
    if (known_ && now == inputs_) return law_;
    law_ =
        law_of(particle, face, pairs_.of(now.body, now.other), pairs_.resting(now.body, now.other));
    inputs_ = now, known_ = true;
    return law_;
  }
  /// lag_factor(zeta).
  Real lag(Real zeta) {
    if (zeta != zeta_) zeta_ = zeta, lag_ = lag_factor(zeta);
    return lag_;
  }

 private:
  struct Inputs {
    Label body = 0, other = 0;
    bool conducts = false, deforms = false, takes_heat = false;
    Real radius = 0, modulus = 0, stiffness = 0;
    bool operator==(const Inputs&) const = default;
  };
  PairFinder pairs_;
  bool known_ = false;
  Inputs inputs_;
  ParticleLaw law_;
  Real zeta_ = 0, lag_ = lag_factor(0.0);
};

/// How far behind the face the particle is held [m]. In front of a thin rigid body it no longer
/// overlaps it stands so far behind the other side; nearer it may be where that is thin only
/// elsewhere.
template <int Dim>
Real held_behind(const ContactParticle& particle, const ContactFace<Dim>& face) {
  const Real held = (face.open ? kOpenDepthRadii : kDepthRadii) * particle.radius;
  // What touches the other side from outside is as deep, to rounding, and must not be held.
  const Real other_side = (1 - kTouchingGap) * (2 * face.half_thickness + particle.radius);
  return std::min(held, face.deforms() ? face.depth : other_side);
}

/// Whether the face is that of a plate of elements which, squeezed, may be passed in a step.
template <int Dim>
bool thin_for(const ContactParticle& particle, const ContactFace<Dim>& face) {
  return face.deforms() && face.half_thickness < particle.radius;
}

/// b of the barrier of a face, per breadth: a particle at five times its speed of sound comes to
/// rest a half thickness d of the plate behind it, 25/2 m c^2 = b d^4/(4 r^2), from where it would
/// be nearer to the other side, and pushed out there.
template <int Dim>
Real barrier_of(const ParticleLaw& law, const ContactParticle& particle,
                const ContactFace<Dim>& face) {
  const Real radii = face.half_thickness / particle.radius;
  return kBarrier * law.own * std::max(1.0, 25 / (radii * radii * radii * radii));
}

/// How heat passes between them; null where a side takes none.
template <int Dim>
const ContactHeat* heat_between(const ContactParticle& particle, const ContactFace<Dim>& face,
                                const PairOptions& options) {
  const bool passes =
      particle.matter->conductivity > 0 && face.capacity > 0 && options.passes_heat();
  return passes ? &options.heat : nullptr;
}

}  // namespace brunt
