#pragma once
/// Which of the listed faces may hold a particle.
#include <algorithm>
#include <cmath>

#include "contact/evaluate/evaluate.hpp"
#include "contact/geometry/box_query.hpp"
#include "contact/geometry/place.hpp"
#include "core/transpose.hpp"

namespace brunt {

/// A particle with what its contacts need.
template <int Dim>
struct Present {
  Present(const Entities<Dim>& entities, const Section& section, LocalIndex at)
      : particle(entities.particles[slot_of(at)]),
        place(at),
        x(entities.nodes.x[slot_of(particle.node)]),
        v(entities.nodes.v[slot_of(particle.node)]),
        about(x),
        mass(entities.nodes.mass[slot_of(particle.node)]),
        breadth(section.breadth_of_particle(x[0], particle.radius)) {}
  const ContactParticle& particle;
  LocalIndex place;  ///< of the particle
  Vec<Dim> x, v;
  BoxQuery<Dim> about;
  Real mass;
  Real breadth;
};

/// Whether a particle may overlap a face, and whether it does so from before it.
struct Reach {
  bool any, before;
};

/// Of the particle, `before` [m] the mean plane: its centre is at most r before the face or a few r
/// behind. Without branches: which faces are near changes from one to the next.
template <int Dim>
Reach reach_of(const FacePlane<Dim>& plane, const SearchBox<Dim>& box, const Present<Dim>& now,
               Real before) {
  const Real r = now.particle.radius;
  const bool clear = before > plane.warp;
  const bool none =
      (plane.area == 0) | (before > r + plane.warp) | (before < -kDepthRadii * r - plane.warp);
  const bool any = !none & now.about.in(box, clear ? r : kDepthRadii * r);
  return {any, clear};
}

/// The same of an open surface, which holds what belongs to one of its `side`s deep on the other.
template <int Dim>
Reach reach_of_open(const FacePlane<Dim>& plane, const SearchBox<Dim>& box, const Present<Dim>& now,
                    Real before, int side) {
  const Real reach = (side != 0 ? kOpenDepthRadii : 1) * now.particle.radius;
  const bool none = plane.area == 0 || std::fabs(before) > reach + plane.warp;
  return {!none && now.about.in(box, reach), side == 0 || side * before > plane.warp};
}

/// Where the particle belongs at an open surface, as it was at the last evaluation; 0: not known.
template <int Dim>
int side_of(const TouchStep& step, const ContactParticle& particle, const ContactFace<Dim>& face) {
  const auto* before = step.before->find(touch_key(particle.id, face.body, face.piece));
  return before == nullptr ? 0 : before->side;
}

/// A product that is larger by this factor is larger however it was rounded.
constexpr Real kSurelyMore = 1 + 1e-9;

/// The bound of a particle, `before` [m] the mean plane of face f, that closes on it: to half a
/// radius of overlap, or half a radius more, of faces that hold less than a radius half of that.
/// What would allow more than `longest` need not be near, nor listed. On an open surface it closes
/// from both sides, and where it touches either way.
template <int Dim>
void limit_by_speed(const Entities<Dim>& entities, std::size_t f, const Present<Dim>& now,
                    Real before, Real longest, StepLimit& step_limit) {
  const auto& plane = entities.planes[f];
  const Vec<Dim> relative = now.v - entities.face_velocity(f);
  const Real r = now.particle.radius;
  Real closing = -relative.dot(plane.normal);
  if (entities.any_open && entities.faces[f].open) {
    if (std::fabs(before) <= r) closing = std::fabs(closing);
    if (before < -r) closing = -closing;
    before = std::fabs(before);
  }
  const Real way =
      std::max(before - r - plane.warp, 0.0) + 0.5 * std::min(r, entities.faces[f].half_thickness);
  const Real least = std::min(longest, step_limit.step);
  // Most take longer, which spares the division; one branch for all that bounds no step.
  const bool none =
      !(closing > 0) | (before < -kDepthRadii * r) | (way > closing * least * kSurelyMore);
  if (none) return;
  const Real step = way / closing;
  if (step > least) return;
  if (!now.about.in(entities.boxes[f], r + relative.norm() * longest)) return;
  step_limit.take({step, "contact speed", now.particle.body, now.particle.id});
}

/// Faces that hold a particle behind some, and those before which it is as far as others hold it:
/// beside the edge of a wedge that is thin for it, it is behind the far side, and outside.
/// first, last  of the candidates of its row;  near  out, of room for all;  returns how many
template <int Dim>
std::size_t find_around(const Entities<Dim>& entities, const ParticleRows& rows, std::size_t first,
                        std::size_t last, const Present<Dim>& now, const EvaluationStep& step,
                        LocalIndex* near) {
  const Real farthest = kDepthRadii * now.particle.radius;
  std::size_t n = 0;
  for (std::size_t i = first; i < last; ++i) {
    const std::size_t f = rows.clearances.entity(i);
    const auto& plane = entities.planes[f];
    const auto& box = entities.boxes[f];
    const Real before = plane.normal.dot(now.x - plane.center);
    const bool open = entities.any_open && entities.faces[f].open;
    const bool holds =
        open ? reach_of_open<Dim>(plane, box, now, before,
                                  side_of(step.touches, now.particle, entities.faces[f]))
                   .any
             : plane.area > 0 && std::fabs(before) <= farthest + plane.warp &&
                   now.about.in(box, farthest);
    near[n] = static_cast<LocalIndex>(f);
    n += holds ? 1 : 0;
  }
  return n;
}

/// What find_near asks of faces, a bit for each of four: whether the particle may overlap it, and
/// if so from before it, and whether it is near enough to touch.
struct FourReaches {
  unsigned any, before, touches;
  Pack in_front;  ///< [m] of the particle before the mean plane
};

/// Of four faces of closed surfaces, as reach_of and BoxQuery have it of each. farthest  [m]
inline FourReaches reaches_of(const Entities<3>& entities, const LocalIndex* f,
                              const Present<3>& now, Real farthest) {
  Pack first[4], last[4], low[4], high[4];
  const auto plane = [&](int i) { return entities.planes[slot_of(f[i])].center.data(); };
  const auto box = [&](int i) { return entities.boxes[slot_of(f[i])].lo.data(); };
  // Numbers in a row: centre, normal, area and warp of a plane, both corners of a box.
  transpose(load(plane(0)), load(plane(1)), load(plane(2)), load(plane(3)), first);
  const auto behind = [&](int i) { return load(plane(i) + kLanes); };
  transpose(behind(0), behind(1), behind(2), behind(3), last);
  transpose(load(box(0)), load(box(1)), load(box(2)), load(box(3)), low);
  const auto upper = [&](int i) { return load(box(i) + 2); };
  transpose(upper(0), upper(1), upper(2), upper(3), high);
  const Place<Pack> x = everywhere(now.x), lo = {low[0], low[1], low[2]},
                    hi = {high[1], high[2], high[3]};
  const Place<Pack> normal = {first[3], last[0], last[1]};
  const Pack area = last[2], warp = last[3];
  const Pack before = dot(normal, x - Place<Pack>{first[0], first[1], first[2]});
  const Pack r = broadcast<Pack>(now.particle.radius);
  const Pack deep = broadcast<Pack>(kDepthRadii * now.particle.radius);
  const auto clear = before > warp;
  const auto none = (area == 0) | (before > r + warp) | (before < -deep - warp);
  const Pack by = select(clear, r, deep);
  const auto outside = (x.x < lo.x - by) | (x.x > hi.x + by) | (x.y < lo.y - by) |
                       (x.y > hi.y + by) | (x.z < lo.z - by) | (x.z > hi.z + by);
  const auto out = [](Pack below, Pack above) {
    const Pack zero = broadcast<Pack>(0.0), way = select(below < above, above, below);
    return select(way < zero, zero, way);
  };
  const Place<Pack> way = {out(lo.x - x.x, x.x - hi.x), out(lo.y - x.y, x.y - hi.y),
                           out(lo.z - x.z, x.z - hi.z)};
  const unsigned too_far = mask_bits(dot(way, way) > broadcast<Pack>(farthest * farthest));
  return {~mask_bits(none | outside), mask_bits(clear), ~too_far, before};
}

/// Faces near a particle as they are found: those that may touch it, and whether it is before all
/// that it may overlap.
struct TouchingFaces {
  LocalIndex* face;
  std::size_t n = 0;
  bool before_all = true;
};

/// Looks at `listed` faces of closed surfaces. near  has room for four more
template <int Dim>
void look_at_closed(const Entities<Dim>& entities, LocalIndex* near, std::size_t listed,
                    const Present<Dim>& now, Real farthest, Real longest, StepLimit* step_limit,
                    TouchingFaces& touching) {
  if constexpr (Dim == 3) {
    if (listed == 0) return;
    std::fill_n(near + listed, kLanes - 1, near[listed - 1]);
    for (std::size_t i = 0; i < listed; i += kLanes) {
      const FourReaches reach = reaches_of(entities, near + i, now, farthest);
      const unsigned there = listed - i < kLanes ? (1U << (listed - i)) - 1 : 0b1111U;
      if (step_limit != nullptr) {
        for (std::size_t k = 0; k < kLanes && i + k < listed; ++k) {
          limit_by_speed(entities, slot_of(near[i + k]), now, reach.in_front[static_cast<int>(k)],
                         longest, *step_limit);
        }
      }
      touching.before_all &= (reach.any & ~reach.before & there) == 0;
      const unsigned kept = reach.any & reach.touches & there;
      store_permuted(touching.face + touching.n, near + i, kCompression.lane[kept]);
      touching.n += slot_of(kCompression.count[kept]);
    }
  }
}

/// The same one by one, of surfaces that may be open.
template <int Dim>
void look_at_each(const Entities<Dim>& entities, const LocalIndex* near, std::size_t listed,
                  const Present<Dim>& now, Real farthest, const EvaluationStep& step,
                  StepLimit* step_limit, TouchingFaces& touching) {
  for (std::size_t i = 0; i < listed; ++i) {
    const LocalIndex face = near[i];
    const auto f = slot_of(face);
    const auto& plane = entities.planes[f];
    const Real before = plane.normal.dot(now.x - plane.center);
    if (step_limit != nullptr) {
      limit_by_speed(entities, f, now, before, step.longest, *step_limit);
    }
    const auto& box = entities.boxes[f];
    const bool open = entities.any_open && entities.faces[f].open;
    const Reach reach =
        open ? reach_of_open<Dim>(plane, box, now, before,
                                  side_of(step.touches, now.particle, entities.faces[f]))
             : reach_of<Dim>(plane, box, now, before);
    touching.before_all &= !reach.any | reach.before;
    touching.face[touching.n] = face;
    const bool touches = !(now.about.squared_distance(box) > farthest * farthest);
    touching.n += reach.any & touches;
  }
}

/// Faces that may hold the particle of a row. Where it is before all of them, those farther from it
/// than what still touches are left out: none is a contact, nor nearer than one. Behind some, they
/// tell where the surface is nearest.
template <int Dim>
std::span<const LocalIndex> find_near(const Entities<Dim>& entities, const ParticleRows& rows,
                                      std::size_t row, const Present<Dim>& now,
                                      const EvaluationStep& step,
                                      typename Records<Dim>::Part& part) {
  const auto [first, last] = rows.range(row);
  const std::size_t room = last - first + kLanes;
  if (part.near.size() < 2 * room) part.near.resize(2 * room);
  LocalIndex* near = part.near.data();
  TouchingFaces touching{near + room};
  const std::size_t listed = rows.clearances.find_near(first, last, rows.loss, near);
  const Real farthest = (1 + 10 * kTouchingGap) * now.particle.radius;
  // Where nothing is fast enough for the least way no face bounds the step.
  const Real least = 0.5 * std::min(now.particle.radius, entities.shallowest);
  const bool step_limits = !(least > rows.fastest * step.longest * kSurelyMore);
  StepLimit* const step_limit = step_limits ? &part.step_limit : nullptr;
  if (Dim == 3 && !entities.any_open) {
    look_at_closed(entities, near, listed, now, farthest, step.longest, step_limit, touching);
  } else {
    look_at_each(entities, near, listed, now, farthest, step, step_limit, touching);
  }
  if (touching.before_all) return {touching.face, touching.n};
  return {near, find_around(entities, rows, first, last, now, step, near)};
}

}  // namespace brunt
