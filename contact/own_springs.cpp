#include "contact/own_springs.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "contact/law.hpp"

namespace brunt {

template <int Dim>
StepVote vote_of_particles(const PairTable& pairs, const Section& section,
                           const Entities<Dim>& entities) {
  StepVote vote;
  std::map<Label, PairOptions> options;
  for (const auto& particle : entities.particles) {
    const auto node = static_cast<std::size_t>(particle.node);
    const Real mass = entities.nodes.mass[node];
    if (!(mass > 0) || particle.held) continue;
    auto it = options.find(particle.body);
    if (it == options.end()) {
      it = options.emplace(particle.body, pairs.strongest(particle.body)).first;
    }
    const Real k = it->second.stiffness * particle.modulus *
                   section.breadth(entities.nodes.x[node][0]) *
                   (Dim == 3 ? 2 * particle.radius : 1.0);
    if (!(k > 0)) continue;
    const Real step = 2 * std::sqrt(mass / k) * lag_factor(it->second.damping);
    vote.take({step, "contact stiffness", particle.body, particle.id});
  }
  return vote;
}

template <int Dim>
StepVote vote_of_rigid(const Section& section, const Entities<Dim>& entities) {
  struct Springs {
    Label body = 0;
    Real squared_frequency = 0, damping = 0;  // [1/s^2], [1/s] c/m
  };
  std::map<Label, Springs> pieces;
  for (const auto& face : entities.faces) {
    if (!(face.compliance > 0)) continue;
    Real middle = 0;  // [m] x of the face
    for (int c = 0; c < face.n_nodes; ++c) {
      const auto node = static_cast<std::size_t>(face.node[static_cast<std::size_t>(c)]);
      middle += entities.nodes.x[node][0] / face.n_nodes;
    }
    const Real area =
        std::max(face.area_start, face.footprint) * section.breadth(std::fabs(middle));
    const Real k = face.phi * face.stiffness;
    auto& piece = pieces[face.piece];
    piece.body = face.body;
    piece.squared_frequency += k * area * face.compliance;
    piece.damping += damping_coefficient(face.zeta, k, face.areal_mass) * area * face.compliance;
  }
  StepVote vote;
  for (const auto& [piece, springs] : pieces) {
    const Real frequency = std::sqrt(springs.squared_frequency);
    if (!(frequency > 0)) continue;
    const Real zeta = springs.damping / (2 * frequency);
    vote.take({2 / frequency * lag_factor(zeta), "contact stiffness", springs.body, piece});
  }
  return vote;
}

template StepVote vote_of_particles<2>(const PairTable&, const Section&, const Entities<2>&);
template StepVote vote_of_particles<3>(const PairTable&, const Section&, const Entities<3>&);
template StepVote vote_of_rigid<2>(const Section&, const Entities<2>&);
template StepVote vote_of_rigid<3>(const Section&, const Entities<3>&);

}  // namespace brunt
