#pragma once
#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "contact/contacts/record.hpp"
#include "contact/search/candidates.hpp"

namespace brunt {

/// The step that led here [s], and the longest that may follow: no speed limit need be longer.
struct EvaluationStep {
  Real dt = 0;
  Real longest = 0;
  TouchStep touches;
  Real longest_of_faces = kInfinity;  ///< [s] the same of faces, which look ahead by it
  Real longest_of_rigid = kInfinity;  ///< [s] bound of free rigid bodies on linear springs
  Real speed = 0;                     ///< [m/s] largest between any two points of surfaces
  Real gravity = 0;                   ///< [m/s^2]
  bool fast = false;                  ///< faces may be fast enough to bound the step by their speed
};

/// What the contacts of a particle with faces leave to those with other particles.
struct ParticleLoad {
  Real squared_frequency = 0;  ///< [1/s^2] sum of k/m
  Real zeta = 0;
  int heat_contacts = 0;  ///< through which heat passes, with particles too
  int on_faces = 0;       ///< of them
};

/// Evaluates the pairs and appends a record for each that carries force, in their order.
/// F = k volume + c area closing speed at the centre of pressure, not below 0
/// (docs/theory/contact.md (C11), (C16)); friction goes on from its past, or from what both faces
/// carried (docs/theory/contact.md (C31)). No past: no friction. What is left of first touches goes
/// to part.face_touches, the bounds of what closes in or is deep to part.step_limit.
template <int Dim>
void evaluate_faces(const Entities<Dim>& entities, const FacePairs<Dim>& pairs,
                    const Section& section, const EvaluationStep& step,
                    FrictionHistory<Dim>* history, typename Records<Dim>::Part& part);

/// The same for the candidates of particles, row by row; F = k(d) + c closing speed,
/// not below 0 (docs/theory/contact.md (C20), (C24)). Takes into part.step_limit the bounds of what
/// touches, 2/sqrt(sum k/m), and of what closes in: (gap + r/2) over the closing speed, so r/2 over
/// it where there is contact. Friction as on faces. loads  by particle, out; empty: not wanted
template <int Dim>
void evaluate_particles(const Entities<Dim>& entities, const ParticleRows& rows,
                        const Section& section, const EvaluationStep& step,
                        FrictionHistory<Dim>* history, std::span<ParticleLoad> loads,
                        typename Records<Dim>::Part& part);

/// What the rows of owned particles beside particles of other bodies need and leave.
struct PairRows {
  std::span<const PairCandidate> candidates;
  std::span<const std::size_t> starts;
  std::span<ParticleLoad> loads;  ///< by particle; in: of their faces
  std::span<PairSide> sides;      ///< by candidate; empty where nothing conducts
};

/// The same for the rows starts[i] .. starts[i+1] of pairs of particles: F = k(d) + c closing
/// speed, not below 0, along the line of their centres, which keeps angular momentum; the row of
/// the smaller id makes the record. Friction acts at the centres, with slips less what the turn of
/// the material about them makes of their distance. Step limits as above, from all contacts of a
/// particle.
template <int Dim>
void evaluate_pairs(const Entities<Dim>& entities, const PairRows& rows, const Section& section,
                    const EvaluationStep& step, FrictionHistory<Dim>* history,
                    typename Records<Dim>::Part& part);

/// Sets what the friction of two faces, of a particle and a face, or of two particles needs to know
/// of the materials of both sides, where its options need it; sides and weights of the step are
/// there.
template <int Dim>
void set_face_material(const Entities<Dim>& entities, const FaceCandidate& candidate,
                       const ContactRecord<Dim>& record, FrictionStep<Dim>& step);
template <int Dim>
void set_particle_material(const Entities<Dim>& entities, const ContactParticle& particle,
                           LocalIndex face, const ContactRecord<Dim>& record,
                           FrictionStep<Dim>& step);
template <int Dim>
void set_pair_material(const Entities<Dim>& entities, const ContactParticle& first,
                       const ContactParticle& second, const ContactRecord<Dim>& record,
                       FrictionStep<Dim>& step);

/// Faces that are nearer than this [m] meet; of particles a distance of this part of their radius.
inline constexpr Real kMeets = 1e-6;
template <int Dim>
Real meeting_distance(const FacePlane<Dim>& lower, const FacePlane<Dim>& upper) {
  const Real area = std::min(lower.area, upper.area);
  return kMeets * (Dim == 3 ? std::sqrt(area) : area);
}

/// How many records and flows of heat a part had before the contacts of a pair or a particle.
struct PartEnds {
  std::size_t record = 0, flow = 0;
};

/// Appends what passes between two faces that touch, or nearly do, before the heat of friction of
/// the same faces. Faces that just meet touch; up to the gap of their pair heat passes without
/// pressure.
template <int Dim>
void add_face_heat(const Entities<Dim>& entities, const FaceCandidate& candidate,
                   const Section& section, const PartEnds& ends, typename Records<Dim>::Part& part);

/// The same for the particle of a row, whose contacts part.hits are. Returns how many contacts
/// share its capacity.
template <int Dim>
int add_particle_heat(const Entities<Dim>& entities, const ParticleRows& rows, std::size_t row,
                      PairFinder& pairs, const Section& section, const PartEnds& ends,
                      typename Records<Dim>::Part& part);

/// Appends the heat that the last friction of the part gives to two faces, to a particle and a
/// face, or to two particles, and notes how much of it they take.
template <int Dim>
void heat_faces(const Entities<Dim>& entities, const FaceCandidate& candidate,
                const FrictionStep<Dim>& step, typename Records<Dim>::Part& part);
template <int Dim>
void heat_particle(const ContactParticle& particle, const ContactFace<Dim>& face,
                   const FrictionStep<Dim>& step, typename Records<Dim>::Part& part);
template <int Dim>
void heat_pair(const ContactParticle& first, const ContactParticle& second,
               const FrictionStep<Dim>& step, typename Records<Dim>::Part& part);

}  // namespace brunt
// Tested by tests/unit/contact/manager_test.cpp.
