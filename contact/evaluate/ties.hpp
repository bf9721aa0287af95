#pragma once
/// What is held from time 0 on, by springs between places of both sides (docs/theory/contact.md,
/// section 9).
#include "contact/evaluate/evaluate.hpp"

namespace brunt {

/// Notes the places of two faces that touch at time 0, in part.face_ties: of each polygon of their
/// overlap those of a rule that integrates products of both sides' weights with a constant exactly.
template <int Dim>
void begin_face_ties(const Entities<Dim>& entities, const FaceCandidate& candidate,
                     const Section& section, typename Records<Dim>::Part& part);

/// What held two faces, or a particle and a face of `body`, and breaks in this evaluation: those
/// that touch go on from it.
template <int Dim>
struct BrokenTies {
  bool any = false;
  Label body = 0;
  Vec<Dim> traction = Vec<Dim>::Zero();  ///< on the upper side [Pa]; on a particle [N]
  Real closed = 0;                       ///< [m] of two faces: largest closure
  Real stiffness = 0;                    ///< [N/m] per breadth, of what touches a particle then
  Real energy = 0;                       ///< [J] that they held
  std::size_t loss = 0;                  ///< place of theirs among the losses of the part
};

/// Appends the record of two faces that are held, and keeps their ties. False where nothing holds
/// them, or they break now: then they touch as others do, and go on from what `broken` says.
template <int Dim>
bool hold_faces(const Entities<Dim>& entities, const FaceCandidate& candidate,
                const Section& section, const EvaluationStep& step, BrokenTies<Dim>& broken,
                typename Records<Dim>::Part& part);

/// Of the energy that broken ties held, what the contacts that took over do not hold is lost.
/// records  of the part, with that body on the lower side those that took over;  losses  of the
/// part
template <int Dim>
void settle_broken(const Entities<Dim>& entities, const BrokenTies<Dim>& broken,
                   std::span<const ContactRecord<Dim>> records, Real dt,
                   const typename Records<Dim>::Part& part, std::vector<JointLoss>& losses);

/// Notes the nearest of part.hits of each body to which the particle is tied, at time 0.
/// area  [m^2] of the particle
template <int Dim>
void begin_particle_ties(const Entities<Dim>& entities, const ContactParticle& particle,
                         PairFinder& pairs, Real area, typename Records<Dim>::Part& part);

/// True where something may hold the particle.
inline bool is_tied(const TouchStep& step, GlobalId particle) {
  return !step.ties
              ->range({ContactKind::particle_face, 0, particle, 0},
                      {ContactKind::particle_face, 0, particle + 1, 0})
              .empty();
}
/// Appends the records of what holds a particle, keeps its ties and leaves hits of the same bodies
/// out. What breaks stands in `broken`, the last body where several do. Returns the sum of k/m
/// [1/s^2] of their springs. area  [m^2] of the particle
template <int Dim>
Real hold_particle(const Entities<Dim>& entities, LocalIndex place, PairFinder& pairs, Real area,
                   const Section& section, const EvaluationStep& step, BrokenTies<Dim>& broken,
                   typename Records<Dim>::Part& part);

/// Makes the last record of two faces, on linear springs, that of their joint: it has been closed
/// as far as `step` remembers, or `broken` where it was held until now. Returns what its forces are
/// of the linear ones.
template <int Dim>
Real close_joint(const Entities<Dim>& entities, const FaceCandidate& candidate,
                 const CommonPlane<Dim>& plane, const EvaluationStep& step,
                 const BrokenTies<Dim>& broken, typename Records<Dim>::Part& part);

/// The spring between two faces that are tied or a joint.
template <int Dim>
HoldingSpring spring_between(const ContactFace<Dim>& a, const ContactFace<Dim>& b,
                             const PairOptions& options);
template <int Dim>
HoldingSpring spring_between(const ContactParticle& particle, const ContactFace<Dim>& face,
                             const PairOptions& options);

}  // namespace brunt
