/// Rows of particles beside particles of other bodies.
#include <algorithm>

#include "contact/contacts/particle_pair.hpp"
#include "contact/law/springs.hpp"
#include "contact/search/candidates.hpp"
#include "contact/search/near_pieces.hpp"

namespace brunt {

namespace {
template <int Dim>
PairCandidate candidate_of(const Entities<Dim>& entities, const PairTable& pairs, LocalIndex i,
                           LocalIndex j) {
  const auto& a = entities.particles[slot_of(i)];
  const auto& b = entities.particles[slot_of(j)];
  const PairOptions& options = *pairs.of_particles(a.body, b.body);
  const auto own = [](const ContactParticle& one) {
    return one.matter->modulus * (Dim == 3 ? 2 * one.radius : 1.0);
  };
  PairCandidate candidate;
  candidate.particle = i, candidate.other = j;
  candidate.stiffness = options.stiffness * in_series(own(a), own(b));
  candidate.barrier = kPairBarrier * options.stiffness * std::max(own(a), own(b));
  candidate.zeta = options.damping;
  candidate.laws = PairLaws(options, a.matter->conductivity > 0 && b.matter->conductivity > 0);
  return candidate;
}
}  // namespace

template <int Dim>
SearchBox<Dim> Candidates<Dim>::box_beside_particles(const Entities<Dim>& entities,
                                                     std::size_t particle) const {
  const auto& one = entities.particles[particle];
  if (!entities.is_near(one.body)) return SearchBox<Dim>::empty();
  const Vec<Dim>& x = entities.nodes.x[slot_of(one.node)];
  return finite_box<Dim>(SearchBox<Dim>::about(
      x,
      (1 + 2 * kTouchingGap) * one.radius + 0.5 * (speed_reach_ + skin_ + entities.gap(one.body))));
}

template <int Dim>
void Candidates<Dim>::find_pairs(const Entities<Dim>& entities, const PairTable& pairs) {
  const auto& particles = entities.particles;
  pairs_.clear();
  pair_starts_.clear();
  if (!pairs.particles_meet() || particles.empty()) return;
  std::vector<SearchBox<Dim>> boxes(particles.size()), nearby;
  for (std::size_t p = 0; p < boxes.size(); ++p) boxes[p] = box_beside_particles(entities, p);
  const auto piece_of = [&](std::size_t p) {
    return PieceKey{particles[p].body, particles[p].piece};
  };
  const auto may_meet = [&](const PieceKey& a, const PieceKey& b) {
    return a != b && pairs.of_particles(a.first, b.first) != nullptr;
  };
  const auto places = near_pieces<Dim>(boxes, piece_of, may_meet, mode_);
  nearby.reserve(places.size());
  for (const LocalIndex p : places) nearby.push_back(boxes[slot_of(p)]);
  const auto particle = [&](LocalIndex near) -> const ContactParticle& {
    return particles[slot_of(places[slot_of(near)])];
  };
  const auto admits = [&](LocalIndex i, LocalIndex j) {
    const auto &a = particle(i), &b = particle(j);
    if (a.body == b.body && a.piece == b.piece) return false;
    return (a.owned || b.owned) && pairs.of_particles(a.body, b.body) != nullptr;
  };
  const auto found = overlapping_pairs<Dim>(nearby, admits, mode_);
  // Rows of owned particles: those with smaller ids first, as they come, then the others.
  std::vector<std::size_t> lower(places.size() + 1, 0), upper(places.size() + 1, 0);
  for (const auto& [i, j] : found) {
    if (particle(i).owned) ++upper[slot_of(i)];
    if (particle(j).owned) ++lower[slot_of(j)];
  }
  std::size_t end = 0;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const std::size_t begin = end, n_lower = lower[k], n_upper = upper[k];
    lower[k] = begin, upper[k] = begin + n_lower;
    end += n_lower + n_upper;
    if (end > begin) pair_starts_.push_back(begin);
  }
  if (end > 0) pair_starts_.push_back(end);
  pairs_.resize(end);
  for (const auto& [i, j] : found) {
    const LocalIndex a = places[slot_of(i)], b = places[slot_of(j)];
    auto forward = candidate_of(entities, pairs, a, b), backward = forward;
    std::swap(backward.particle, backward.other);
    const bool both = particle(i).owned && particle(j).owned;
    const auto at_i = upper[slot_of(i)], at_j = lower[slot_of(j)];
    if (both) {
      forward.mirror = static_cast<LocalIndex>(at_j);
      backward.mirror = static_cast<LocalIndex>(at_i);
    }
    if (particle(i).owned) pairs_[upper[slot_of(i)]++] = forward;
    if (particle(j).owned) pairs_[lower[slot_of(j)]++] = backward;
  }
}

template SearchBox<2> Candidates<2>::box_beside_particles(const Entities<2>&, std::size_t) const;
template SearchBox<3> Candidates<3>::box_beside_particles(const Entities<3>&, std::size_t) const;
template void Candidates<2>::find_pairs(const Entities<2>&, const PairTable&);
template void Candidates<3>::find_pairs(const Entities<3>&, const PairTable&);

}  // namespace brunt
// Tested by tests/unit/contact/box_query_test.cpp.
