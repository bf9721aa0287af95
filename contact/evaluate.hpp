#pragma once
#include "contact/candidates.hpp"
#include "contact/record.hpp"

namespace brunt {

/// The step that led here [s], and the longest that may follow: no speed vote need be longer.
struct EvaluationStep {
  Real dt = 0;
  Real longest = 0;
};

/// What the contacts of a particle with faces leave to those with other particles.
struct ParticleLoad {
  Real squared_frequency = 0;  ///< [1/s^2] sum of k/m
  Real zeta = 0;
  int heat_contacts = 0;  ///< through which heat passes, with particles too
  int on_faces = 0;       ///< of them
};

/// Evaluates the candidates and appends a record for each that carries force, in their order.
/// F = k volume + c area closing speed at the centre of pressure, not below 0 (contact.md 2.5);
/// friction goes on from its past, or from what both faces carried (2.6). No past: no friction.
template <int Dim>
void evaluate_faces(const Entities<Dim>& entities, std::span<const FaceCandidate> candidates,
                    const Section& section, const EvaluationStep& step,
                    FrictionHistory<Dim>* history, typename Records<Dim>::Part& part);

/// The same for the candidates of particles starts[i] .. starts[i+1]; F = k(d) + c closing speed,
/// not below 0 (contact.md 2.8). Takes into part.vote the bounds of what touches, 2/sqrt(sum k/m),
/// and of what closes in: (gap + r/2) over the closing speed, so r/2 over it where there is
/// contact. Friction as on faces. loads  by particle, out; empty: nobody asks
template <int Dim>
void evaluate_particles(const Entities<Dim>& entities,
                        std::span<const ParticleCandidate> candidates,
                        std::span<const std::size_t> starts, const Section& section,
                        const EvaluationStep& step, FrictionHistory<Dim>* history,
                        std::span<ParticleLoad> loads, typename Records<Dim>::Part& part);

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
/// the material about them makes of their distance. Votes as above, from all contacts of a
/// particle.
template <int Dim>
void evaluate_pairs(const Entities<Dim>& entities, const PairRows& rows, const Section& section,
                    const EvaluationStep& step, FrictionHistory<Dim>* history,
                    typename Records<Dim>::Part& part);

}  // namespace brunt
