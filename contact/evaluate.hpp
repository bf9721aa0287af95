#pragma once
#include "contact/candidates.hpp"
#include "contact/record.hpp"

namespace brunt {

/// The step that led here [s], and the longest that may follow: no speed vote need be longer.
struct EvaluationStep {
  Real dt = 0;
  Real longest = 0;
  TouchStep touches;
};

/// Evaluates the candidates and appends a record for each that carries force, in their order.
/// F = k volume + c area closing speed at the centre of pressure, not below 0 (contact.md 2.5);
/// friction goes on from its past, or from what both faces carried (2.6). No past: no friction.
/// What is left of first touches goes to part.face_touches.
template <int Dim>
void evaluate_faces(const Entities<Dim>& entities, std::span<const FaceCandidate> candidates,
                    const Section& section, const EvaluationStep& step,
                    FrictionHistory<Dim>* history, typename Records<Dim>::Part& part);

/// The same for the candidates of particles starts[i] .. starts[i+1]; F = k(d) + c closing speed,
/// not below 0 (contact.md 2.8). Takes into part.vote the bounds of what touches, 2/sqrt(sum k/m),
/// and of what closes in: (gap + r/2) over the closing speed, so r/2 over it where there is
/// contact. Friction as on faces.
template <int Dim>
void evaluate_particles(const Entities<Dim>& entities,
                        std::span<const ParticleCandidate> candidates,
                        std::span<const std::size_t> starts, const Section& section,
                        const EvaluationStep& step, FrictionHistory<Dim>* history,
                        typename Records<Dim>::Part& part);

}  // namespace brunt
