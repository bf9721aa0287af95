#include "contact/evaluate/particle_touches.hpp"

#include <algorithm>

#include "contact/evaluate/particle_law.hpp"

namespace brunt {

namespace {
/// What the particle keeps of a surface; those from `first` on are its own, in the order of
/// surfaces.
FirstTouch& touch_of(GlobalId particle, GlobalId surface, std::size_t first,
                     std::vector<FirstTouch>& touches) {
  const ContactKey key{ContactKind::particle_face, 0, particle, surface};
  auto at = touches.begin() + static_cast<std::ptrdiff_t>(first);
  while (at != touches.end() && at->key < key) ++at;
  if (at == touches.end() || !(at->key == key)) {
    at = touches.insert(at, FirstTouch{key});
  }
  return *at;
}
}  // namespace

std::size_t first_touch_of(GlobalId particle, const std::vector<FirstTouch>& touches) {
  std::size_t first = touches.size();
  const auto own = [&](const ContactKey& key) {
    return key.kind == ContactKind::particle_face && key.first == particle;
  };
  while (first > 0 && own(touches[first - 1].key)) --first;
  return first;
}

template <int Dim>
void keep_touch(const ContactParticle& particle, const ContactFace<Dim>& face,
                const TouchStep& step, typename Records<Dim>::Part& part) {
  const auto key = touch_key(particle.id, face.body, face.piece);
  const auto* before = step.before->find(key);
  if (before == nullptr) return;
  auto& touches = part.particle_touches;
  touch_of(particle.id, key.second, first_touch_of(particle.id, touches), touches) = *before;
}

template <int Dim>
void begin_where_held(const ContactParticle& particle, Label body, const Vec<Dim>& force,
                      Real stiffness, std::size_t first, typename Records<Dim>::Part& part) {
  for (auto& hit : part.hits) {
    if (!hit.kept || hit.body != body) continue;
    const Real held = std::max(force.dot(hit.direction), 0.0) / stiffness;
    const Real deeper = hit.overlap - held;
    if (!(deeper > 0)) continue;
    touch_of(particle.id, surface_of(hit.body, hit.piece), first, part.particle_touches).overlap +=
        deeper;
    hit.overlap = held;
    hit.pushes = held > 0;
  }
}

template <int Dim>
void recall_entries(const Entities<Dim>& entities, const ContactParticle& particle,
                    const TouchStep& step, std::vector<ParticleHit<Dim>>& hits) {
  constexpr Real kOtherSide = -0.5;  // cosine between normals
  for (const auto& own : hits) {
    const auto* before = step.before->find(touch_key(particle.id, own.body, own.piece));
    const GlobalId id = entities.faces[slot_of(own.face)].id;
    if (step.entry_of(before) != id) continue;
    for (auto& hit : hits) {
      if (hit.body != own.body || hit.piece != own.piece) continue;
      const bool other = hit.plane->normal.dot(own.plane->normal) < kOtherSide;
      hit.entry = other ? -1 : 1;
    }
  }
}

template <int Dim>
void remember_entries(const Entities<Dim>& entities, const ContactParticle& particle,
                      const TouchStep& step, std::size_t first, typename Records<Dim>::Part& part) {
  for (const auto& hit : part.hits) {
    const auto& face = entities.faces[slot_of(hit.face)];
    if (!hit.kept || !thin_for(particle, face)) continue;
    const bool nearest = std::none_of(part.hits.begin(), part.hits.end(), [&](const auto& other) {
      const bool same = other.kept && other.body == hit.body && other.piece == hit.piece;
      return same && other.nearest.distance < hit.nearest.distance;
    });
    if (!nearest) continue;
    FirstTouch& touch =
        touch_of(particle.id, surface_of(hit.body, hit.piece), first, part.particle_touches);
    touch.entry = face.id;
    touch.entry_before =
        step.entry_of(step.before->find(touch_key(particle.id, hit.body, hit.piece)));
  }
}

template <int Dim>
void remember_sides(const ContactParticle& particle, std::size_t first,
                    typename Records<Dim>::Part& part) {
  for (const auto& hit : part.hits) {
    if (!hit.kept || hit.side == 0) continue;
    auto& touch =
        touch_of(particle.id, surface_of(hit.body, hit.piece), first, part.particle_touches);
    if (touch.side == 0) touch.side = hit.side;
  }
}

namespace {
/// Whether a particle and what a hit touches meet for the first time: at time 0, as one of them is
/// born, or where it comes back from where nothing held it.
template <int Dim>
bool is_first(const Entities<Dim>& entities, const ContactParticle& particle, const TouchStep& step,
              const ParticleHit<Dim>& hit) {
  if (step.time_zero || hit.returns) return true;
  if (!entities.any_born) return false;
  return particle.born || entities.faces[slot_of(hit.face)].born;
}

/// [m] of a hit's overlap of which contact takes no notice, before it has opened.
template <int Dim>
Real overlap_ignored(const Entities<Dim>& entities, const ContactParticle& particle,
                     PairFinder& pairs, const TouchStep& step, const ParticleHit<Dim>& hit) {
  // What is born later is never pressed out.
  const auto law =
      step.time_zero ? pairs.of(particle.body, hit.body).initial_overlap : InitialOverlap::track;
  const bool first = is_first(entities, particle, step, hit);
  const Real overlap = ignored_overlap(law, hit.overlap, first ? kMeets * particle.radius : 0.0);
  if (overlap == 0 || first) return overlap;
  return step.before->find(touch_key(particle.id, hit.body, hit.piece)) != nullptr ? overlap : 0.0;
}
}  // namespace

template <int Dim>
void track_overlaps(const Entities<Dim>& entities, const ContactParticle& particle,
                    PairFinder& pairs, const TouchStep& step, typename Records<Dim>::Part& part) {
  const auto returns = [](const auto& hit) { return hit.returns; };
  const bool any_returns = std::any_of(part.hits.begin(), part.hits.end(), returns);
  const bool any_meets = step.time_zero || entities.any_born || any_returns;
  if (!any_meets && step.before->empty()) return;  // nearly always
  const auto meets = [&](const auto& hit) { return is_first(entities, particle, step, hit); };
  const bool any_first = std::any_of(part.hits.begin(), part.hits.end(), meets);
  if (!any_first && step.before->empty()) return;
  auto& touches = part.particle_touches;
  const std::size_t first = first_touch_of(particle.id, touches);
  for (const auto& hit : part.hits) {
    if (!hit.kept) continue;
    const Real overlap = overlap_ignored(entities, particle, pairs, step, hit);
    if (overlap == 0) continue;
    auto& touch = touch_of(particle.id, surface_of(hit.body, hit.piece), first, touches);
    touch.overlap = std::max(touch.overlap, overlap);
  }
  for (std::size_t i = first; i < touches.size(); ++i) {
    auto& touch = touches[i];
    const auto own = [&](const auto& hit) {
      return surface_of(hit.body, hit.piece) == touch.key.second;
    };
    const auto begins = [&](const auto& hit) { return hit.kept && own(hit) && meets(hit); };
    if (std::none_of(part.hits.begin(), part.hits.end(), begins)) {
      const auto* before = step.before->find(touch.key);
      touch.overlap = std::min(touch.overlap, before->overlap);
    }
    for (auto& hit : part.hits) {
      if (!own(hit)) continue;
      hit.overlap -= touch.overlap;
      hit.pushes = hit.overlap > 0;
    }
  }
}

template void keep_touch<2>(const ContactParticle&, const ContactFace<2>&, const TouchStep&,
                            Records<2>::Part&);
template void begin_where_held<2>(const ContactParticle&, Label, const Vec<2>&, Real, std::size_t,
                                  Records<2>::Part&);
template void recall_entries<2>(const Entities<2>&, const ContactParticle&, const TouchStep&,
                                std::vector<ParticleHit<2>>&);
template void keep_touch<3>(const ContactParticle&, const ContactFace<3>&, const TouchStep&,
                            Records<3>::Part&);
template void begin_where_held<3>(const ContactParticle&, Label, const Vec<3>&, Real, std::size_t,
                                  Records<3>::Part&);
template void recall_entries<3>(const Entities<3>&, const ContactParticle&, const TouchStep&,
                                std::vector<ParticleHit<3>>&);
template void remember_entries<2>(const Entities<2>&, const ContactParticle&, const TouchStep&,
                                  std::size_t, Records<2>::Part&);
template void remember_entries<3>(const Entities<3>&, const ContactParticle&, const TouchStep&,
                                  std::size_t, Records<3>::Part&);
template void remember_sides<2>(const ContactParticle&, std::size_t, Records<2>::Part&);
template void remember_sides<3>(const ContactParticle&, std::size_t, Records<3>::Part&);
template void track_overlaps<2>(const Entities<2>&, const ContactParticle&, PairFinder&,
                                const TouchStep&, Records<2>::Part&);
template void track_overlaps<3>(const Entities<3>&, const ContactParticle&, PairFinder&,
                                const TouchStep&, Records<3>::Part&);

}  // namespace brunt
