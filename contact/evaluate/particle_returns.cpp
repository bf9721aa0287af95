#include "contact/evaluate/particle_returns.hpp"

#include "contact/evaluate/before_step.hpp"
#include "contact/evaluate/particle_law.hpp"

namespace brunt {

namespace {
template <int Dim>
bool same_surface(const ParticleHit<Dim>& a, const ParticleHit<Dim>& b) {
  return a.body == b.body && a.piece == b.piece;
}

/// Whether the step can have brought the particle from beyond the limit of a face: the distance
/// from a surface changes by no more than the way of what is fastest of it against the particle.
/// Most are not as deep.
template <int Dim>
bool may_return(const Entities<Dim>& entities, const Present<Dim>& now, Real dt,
                const std::vector<ParticleHit<Dim>>& hits, const ParticleHit<Dim>& hit) {
  Real squared = 0, limit = kInfinity;
  for (const auto& other : hits) {
    if (!same_surface(other, hit)) continue;
    limit = std::min(limit, other.limit);
    const auto& face = entities.faces[slot_of(other.face)];
    for (std::size_t c = 0; c < slot_of(face.n_nodes); ++c) {
      const Vec<Dim>& v = entities.nodes.v[slot_of(face.node[c])];
      squared = std::max(squared, (v - now.v).squaredNorm());
    }
  }
  return hit.nearest.distance + dt * std::sqrt(squared) > limit;
}

/// Whether the particle was behind the surface of a hit at the last evaluation, and farther than
/// the nearest of its faces holds.
template <int Dim>
bool was_beyond(const Entities<Dim>& entities, const Present<Dim>& now, const Section& section,
                Real dt, const std::vector<ParticleHit<Dim>>& hits, const ParticleHit<Dim>& hit) {
  const Vec<Dim> x = now.x - dt * now.v;
  std::vector<FacePlane<Dim>> planes;
  std::vector<ParticleHit<Dim>> before;
  planes.reserve(hits.size()), before.reserve(hits.size());
  for (const auto& other : hits) {
    if (!same_surface(other, hit)) continue;
    auto& one = before.emplace_back(planes.emplace_back(before_step(entities, other.face, dt)), x);
    one.node = other.node, one.body = other.body, one.piece = other.piece, one.face = other.face;
    one.limit = kInfinity;  // whatever is nearest shall hold it here
  }
  if (section.geometry == Geometry::axisymmetric) join_at_axis(now.particle.radius, before);
  choose_hits<Dim>(x, now.particle.radius, before);
  return std::any_of(before.begin(), before.end(), [&](const auto& one) {
    const Real limit = held_behind(now.particle, entities.faces[slot_of(one.face)]);
    return one.kept && one.inside && one.nearest.distance > limit;
  });
}
}  // namespace

template <int Dim>
void mark_returns(const Entities<Dim>& entities, const Present<Dim>& now, const Section& section,
                  const EvaluationStep& step, std::vector<ParticleHit<Dim>>& hits) {
  if (step.touches.time_zero) return;
  for (auto& hit : hits) {
    if (!hit.kept || !hit.inside || hit.open) continue;
    if (!may_return(entities, now, step.dt, hits, hit)) continue;
    const auto key = touch_key(now.particle.id, hit.body, hit.piece);
    if (step.touches.before->find(key) != nullptr) continue;
    hit.returns = was_beyond(entities, now, section, step.dt, hits, hit);
  }
}

template void mark_returns<2>(const Entities<2>&, const Present<2>&, const Section&,
                              const EvaluationStep&, std::vector<ParticleHit<2>>&);
template void mark_returns<3>(const Entities<3>&, const Present<3>&, const Section&,
                              const EvaluationStep&, std::vector<ParticleHit<3>>&);

}  // namespace brunt
// Tested by tests/unit/contact/particle_returns_test.cpp.
