#pragma once
/// What the ranks of a run would have and send, counted from a whole scene and a partition of its
/// points by the rules of FiniteElements, SphParticles and ContactImports; no rank is needed.
#include <vector>

#include "app/scene/scene.hpp"

namespace brunt {

struct Sent {
  Real messages = 0;
  Real bytes = 0;
};

/// One rank of a run.
struct RankLoad {
  std::size_t points = 0;      ///< owned
  std::size_t ghosts = 0;      ///< copies of points of others
  std::size_t elements = 0;    ///< counted here
  std::size_t computed = 0;    ///< elements that touch an owned point
  std::size_t particles = 0;   ///< owned
  std::size_t surface = 0;     ///< faces and particles that contact looks at, owned
  std::size_t candidates = 0;  ///< of contact, evaluated here
  Real weight = 0;             ///< by which points were partitioned
  Sent step;                   ///< in every step
  Sent particle_lists;         ///< whenever neighbour lists of particles are made
  Sent contact_lists;          ///< whenever lists of contact are made
};

/// The loads of `parts` ranks among which the points of a whole scene are partitioned. Positions
/// are those of now: a partition from time 0 may be looked at later. weight  of each point, by id
template <int Dim>
std::vector<RankLoad> rank_loads(Scene<Dim>& scene, const Partition& partition,
                                 std::span<const Real> weight, int parts);

}  // namespace brunt
