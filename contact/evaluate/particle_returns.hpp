#pragma once
#include "contact/evaluate/near_faces.hpp"

namespace brunt {

/// Marks hits that hold a particle which no face held at the last evaluation, since it was behind
/// the nearest of that surface by more than this holds: it has been given up, or was never held,
/// and would begin at the top of the barrier of another face, or of this one. Surfaces that it
/// touched then have no such hit, nor have open ones, which remember sides.
template <int Dim>
void mark_returns(const Entities<Dim>& entities, const Present<Dim>& now, const Section& section,
                  const EvaluationStep& step, std::vector<ParticleHit<Dim>>& hits);

}  // namespace brunt
