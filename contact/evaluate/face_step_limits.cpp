#include "contact/evaluate/face_step_limits.hpp"

#include <algorithm>
#include <cmath>

#include "contact/law/springs.hpp"

namespace brunt {

namespace {
/// How far one step may bring faces that overlap by g [m].
Real way_of(const FaceBarrier& barrier, Real g) {
  return std::max(barrier.onset - g, barrier.least_way());
}

/// Slope of the pressure over k, 1 or more, that bounds the step of one side, faces a way `coming`
/// [m] deeper in each other than they are. A rigid body feels the whole overlap, and so its mean. A
/// node of elements has half (2D) or a quarter (3D) of its faces' mass, and all of the slope may
/// lie beside it: there the mean excess counts as often, but no more than the largest.
template <int Dim>
Real slope_of(const ContactFace<Dim>& face, const FaceBarrier& barrier,
              const CommonPlane<Dim>& plane, Real coming) {
  const Real mean = plane.mean_slope - 1 + 2 * barrier.steepness() * coming;
  const Real share = face.deforms() ? 1 << (Dim - 1) : 1;
  return std::min(barrier.tangent(plane.deepest + coming), 1 + share * mean);
}

/// Of the corners of a face along n, from a place: the largest height [m] and speed [m/s].
struct Front {
  Real height = -kInfinity, speed = -kInfinity;
};
template <int Dim>
Front front_of(const Entities<Dim>& entities, LocalIndex place, const Vec<Dim>& n,
               const Vec<Dim>& from) {
  const auto& face = entities.faces[slot_of(place)];
  Front front;
  for (std::size_t c = 0; c < slot_of(face.n_nodes); ++c) {
    const auto node = slot_of(face.node[c]);
    front.height = std::max(front.height, n.dot(entities.nodes.x[node] - from));
    front.speed = std::max(front.speed, n.dot(entities.nodes.v[node]));
  }
  return front;
}

template <int Dim>
SearchBox<Dim> widened(SearchBox<Dim> box, Real by) {
  for (std::size_t c = 0; c < slot_of(Dim); ++c) box.lo[c] -= by, box.hi[c] += by;
  return box;
}
}  // namespace

template <int Dim>
void limit_by_approach(const Entities<Dim>& entities, const FaceCandidate& candidate,
                       const EvaluationStep& step, StepLimit& step_limit) {
  const auto l = slot_of(candidate.lower);
  const auto u = slot_of(candidate.upper);
  const auto &lower = entities.planes[l], &upper = entities.planes[u];
  if (!(-lower.normal.dot(upper.normal) > FacingRamp<Dim>(lower, upper).none)) return;
  const Vec<Dim> n = (lower.normal - upper.normal).normalized();
  if (n.dot(lower.center - upper.center) > candidate.normal.limit) return;
  const Front below = front_of<Dim>(entities, candidate.lower, n, lower.center);
  const Front above = front_of<Dim>(entities, candidate.upper, -n, lower.center);
  const Real closing = below.speed + above.speed;
  if (!(closing > 0)) return;
  const Real least = std::min(step.longest_of_faces, step_limit.step);
  const Real way = way_of(candidate.normal.barrier(), below.height + above.height);
  if (way > closing * least) return;
  const Real relative = (entities.face_velocity(u) - entities.face_velocity(l)).norm();
  // No farther than the lists see, whatever their skin.
  const Real sweep = candidate.normal.limit + std::max(closing, relative) * step.longest_of_faces;
  if (!widened<Dim>(entities.boxes[l], sweep).meets(entities.boxes[u])) return;
  step_limit.take({way / closing, "contact speed", entities.faces[l].body, entities.faces[l].id});
}

namespace {
constexpr int kPasses = 2;
/// What is pushed from rest moves twice as far in its second step as it would by its speed.
constexpr Real kFaster = 2;

/// The step [s] that faces allow which press `area` [m^2] of each other by a pair's spring, and
/// the face that bounds it. What presses a part of a face may all lie beside one of its nodes,
/// which has half (2D) or a quarter (3D) of the face: it counts as often. A smaller face has others
/// beside it, which press as much of themselves: its part counts for both.
template <int Dim>
StepLimit limit_of_area(const Entities<Dim>& entities, const FaceCandidate& candidate, Real area) {
  const Real smaller = std::min(entities.planes[slot_of(candidate.lower)].area,
                                entities.planes[slot_of(candidate.upper)].area);
  const Real pressed = std::min((1 << (Dim - 1)) * area / smaller, 1.0);
  // Edges come onto their springs bit by bit; what lands flat swings across them in one step at the
  // limit, and makes energy.
  const Real lands = std::max(2 * pressed - 1, 0.0);
  StepLimit limit;
  for (const LocalIndex place : {candidate.lower, candidate.upper}) {
    const auto& face = entities.faces[slot_of(place)];
    if (!face.deforms() || face.held || !(face.area_start > 0)) continue;
    const Real whole = entities.planes[slot_of(place)].area / face.area_start;
    const Real phi = candidate.watched * recoil_factor(face.recoil) * pressed * whole;
    const Real zeta = recoil_damping(face.zeta, face.recoil);
    const Real exact = 1 - 0.5 * (1 - 1 / std::sqrt(std::max(phi, 1.0))) * lands;
    limit.take({exact * face.element_step * surface_step_ratio(phi, zeta), "contact stiffness",
                face.body, face.id});
  }
  return limit;
}

/// [m^2] that two faces press once they have come nearer by `coming` and slid by `sliding` [m].
template <int Dim>
Real pressed_area(const Entities<Dim>& entities, const FaceCandidate& candidate, Real coming,
                  Real sliding) {
  const auto &lower = entities.planes[slot_of(candidate.lower)],
             &upper = entities.planes[slot_of(candidate.upper)];
  Planes<Dim> planes;
  const int n = common_planes<Dim>(
      lower, upper, Section{}, planes,
      {.opening = coming, .pushes = false, .at_point = candidate.normal.at_point, .turned = true});
  Real area = 0;
  for (int i = 0; i < n; ++i) area += planes[slot_of(i)].area;
  if constexpr (Dim == 2) {
    return area + 2 * sliding;
  } else {
    return area + 4 * sliding * std::sqrt(std::min(lower.area, upper.area));
  }
}
}  // namespace

template <int Dim>
void limit_by_pressed_area(const Entities<Dim>& entities, const FaceCandidate& candidate,
                           const EvaluationStep& step, StepLimit& step_limit) {
  if (candidate.watched == 0) return;
  Real ahead = step.longest_of_faces;
  // As far behind each other as they may press, and no farther than the lists see.
  const auto in_reach = [&] {
    const Real sweep = candidate.normal.limit + step.speed * ahead;
    return widened<Dim>(entities.boxes[slot_of(candidate.lower)], sweep)
        .meets(entities.boxes[slot_of(candidate.upper)]);
  };
  if (!in_reach()) return;
  const auto l = slot_of(candidate.lower), u = slot_of(candidate.upper);
  const auto &lower = entities.planes[l], &upper = entities.planes[u];
  if (!(-lower.normal.dot(upper.normal) > FacingRamp<Dim>(lower, upper).none)) return;
  const Vec<Dim> n = (lower.normal - upper.normal).normalized();
  const Front below = front_of<Dim>(entities, candidate.lower, n, lower.center);
  const Front above = front_of<Dim>(entities, candidate.upper, -n, lower.center);
  const Real closing = below.speed + above.speed;
  const Real relative = (entities.face_velocity(u) - entities.face_velocity(l)).norm();
  // What is behind a face turns it round within h/c, by no more than all speeds that there are: one
  // that opens now may close again within the step.
  const auto back = [&](LocalIndex place) {
    const auto& face = entities.faces[slot_of(place)];
    return face.deforms() && !face.held ? step.speed / face.element_step : 0.0;
  };
  const Real turns = 2 * std::max(back(candidate.lower), back(candidate.upper));
  // A bound that looks ahead by a time holds up to that time: first by the longest step, which may
  // show more of them than they press in the step that it allows, and then by twice that one.
  StepLimit found;
  found.step = 0;
  for (int pass = 0; pass < kPasses; ++pass) {
    StepLimit bound;
    // At time 0 nobody knows what will push them: an eighth of their depth.
    const Real coming =
        step.dt > 0 ? std::clamp(closing + turns * ahead, 0.0, kFaster * step.speed) * ahead +
                          step.gravity * ahead * ahead
                    : candidate.normal.barrier().onset;
    if (below.height + above.height + coming > 0 && in_reach()) {
      bound = limit_of_area<Dim>(entities, candidate,
                                 pressed_area<Dim>(entities, candidate, coming, relative * ahead));
    }
    if (bound.step >= ahead && pass == 0) return;
    if (bound.step > ahead) bound = {ahead, "contact stiffness", found.body, found.entity};
    if (bound.step > found.step) found = bound;
    ahead = std::min(ahead, 2 * found.step);
  }
  step_limit.take(found);
}

template <int Dim>
void limit_by_barrier(const Entities<Dim>& entities, const FaceCandidate& candidate,
                      const CommonPlane<Dim>& plane, Real closing, const EvaluationStep& step,
                      StepLimit& step_limit) {
  const FaceBarrier barrier = candidate.normal.barrier();
  const Real coming =
      std::min(std::max(closing, 0.0) * step.longest_of_faces, way_of(barrier, plane.deepest));
  if (!(barrier.tangent(plane.deepest + coming) > 1)) return;
  const Real opening = -closing, back = plane.deepest - barrier.onset;
  if (opening > 0 && back > 0) {
    const Real way = 0.5 * std::max(back, barrier.least_way());
    const auto& face = entities.faces[slot_of(candidate.lower)];
    step_limit.take({way / opening, "contact speed", face.body, face.id});
  }
  for (const LocalIndex place : {candidate.lower, candidate.upper}) {
    const auto& face = entities.faces[slot_of(place)];
    if (face.rigid() || face.held || !(face.area_start > 0)) continue;
    const Real steeper = slope_of(face, barrier, plane, coming), root = std::sqrt(steeper);
    Real longest = step.longest_of_rigid / root;
    if (face.deforms()) {
      const Real area = std::max(entities.planes[slot_of(place)].area, face.footprint);
      // The damper stays as it is: its part of critical falls.
      const Real recoil = face.recoil * steeper;
      const Real phi = face.phi * steeper * recoil_factor(recoil) * area / face.area_start;
      const Real zeta = recoil_damping(face.zeta / root, recoil);
      longest = face.element_step * surface_step_ratio(phi, zeta);
    }
    // A step at the limit of stability swings across the slope: what the mean of both forces does
    // is not what the spring holds. Half of it errs a quarter as much.
    const Real exact = 0.5 * (1 + 1 / root);
    step_limit.take({exact * longest, "contact stiffness", face.body, face.id});
  }
}

namespace {
/// Sum over the corners of a face of the square of how far its normal turns as one of them moves
/// out of it, over their mass [1/(m^2 kg)].
template <int Dim>
Real turn_compliance(const Entities<Dim>& entities, LocalIndex place) {
  const auto& face = entities.faces[slot_of(place)];
  const auto& plane = entities.planes[slot_of(place)];
  const auto n = slot_of(face.n_nodes);
  Real sum = 0, most = 0;
  for (std::size_t c = 0; c < n; ++c) {
    // A diagonal, or an edge, that turns about the other one; in the plane the face itself.
    const Vec<Dim> other = plane.corner[(c + (n == 4 ? 3 : 2)) % n] - plane.corner[(c + 1) % n];
    const Real turn = Dim == 2 ? 1 / plane.area : other.norm() / (2 * plane.area);
    most = std::max(most, turn * turn);
    const Real mass = entities.nodes.mass[slot_of(face.node[c])];
    if (mass > 0) sum += turn * turn / mass;
  }
  return face.deforms() ? sum : face.compliance * most;
}

/// The bounds of both faces of a pair whose pressure fades between two cosines.
/// energy  [m^3] that it would hold with the whole ramp, per k
/// until   [s] from when on it fades
template <int Dim>
void limit_on_ramp(const Entities<Dim>& entities, const FaceCandidate& candidate,
                   const FacingRamp<Dim>& ramp, Real energy, Real until, StepLimit& step_limit) {
  const Real width = ramp.whole - ramp.none;
  // 6: the largest curvature of a smooth step.
  const Real bends = 24 / (width * width) * candidate.normal.stiffness * energy;
  Real squared = 0;
  for (const LocalIndex place : {candidate.lower, candidate.upper}) {
    const auto& face = entities.faces[slot_of(place)];
    if (face.rigid() || face.held) continue;
    squared += bends * turn_compliance<Dim>(entities, place);
  }
  for (const LocalIndex place : {candidate.lower, candidate.upper}) {
    const auto& face = entities.faces[slot_of(place)];
    if (face.rigid() || face.held) continue;
    const Real own = face.deforms() ? 1 / (face.element_step * face.element_step) : 0.0;
    if (squared + own > 0) {
      const Real longest = std::max(1 / std::sqrt(squared + own), until);
      step_limit.take({longest, "contact stiffness", face.body, face.id});
    }
  }
}

/// How fast the normal of a face turns [1/s].
Vec<2> turn_of(const Entities<2>& entities, LocalIndex place) {
  const auto& face = entities.faces[slot_of(place)];
  const auto& plane = entities.planes[slot_of(place)];
  const auto v = [&](std::size_t c) { return entities.nodes.v[slot_of(face.node[c])]; };
  const Vec<2> along = plane.corner[1] - plane.corner[0];
  return -plane.normal.dot(v(1) - v(0)) / along.squaredNorm() * along;
}
Vec3 turn_of(const Entities<3>& entities, LocalIndex place) {
  const auto& face = entities.faces[slot_of(place)];
  const auto& plane = entities.planes[slot_of(place)];
  const auto v = [&](std::size_t c) { return entities.nodes.v[slot_of(face.node[c])]; };
  const auto& x = plane.corner;
  const bool quad = face.n_nodes == 4;
  const Vec3 a = x[quad ? 2 : 1] - x[0], b = quad ? x[3] - x[1] : x[2] - x[0];
  const Vec3 by_a = v(quad ? 2 : 1) - v(0), by_b = quad ? v(3) - v(1) : v(2) - v(0);
  const Vec3 rate = (by_a.cross(b) + a.cross(by_b)) / (2 * plane.area);
  return rate - plane.normal.dot(rate) * plane.normal;
}
}  // namespace

template <int Dim>
void limit_by_turn(const Entities<Dim>& entities, const FaceCandidate& candidate,
                   const CommonPlane<Dim>& plane, StepLimit& step_limit) {
  if (!(plane.ramp > 0 && plane.ramp < 1)) return;
  const FacingRamp<Dim> ramp(entities.planes[slot_of(candidate.lower)],
                             entities.planes[slot_of(candidate.upper)]);
  limit_on_ramp(entities, candidate, ramp, plane.energy / plane.ramp, 0, step_limit);
}

template <int Dim>
void limit_by_turning(const Entities<Dim>& entities, const FaceCandidate& candidate,
                      const Section& section, Real overlap, const EvaluationStep& step,
                      StepLimit& step_limit) {
  const auto l = slot_of(candidate.lower), u = slot_of(candidate.upper);
  const auto &lower = entities.planes[l], &upper = entities.planes[u];
  const Real facing = -lower.normal.dot(upper.normal);
  if (!(facing > kMayTurn)) return;
  const FacingRamp<Dim> ramp(lower, upper);
  if (facing > ramp.none) return;
  const Real rate = -turn_of(entities, candidate.lower).dot(upper.normal) -
                    turn_of(entities, candidate.upper).dot(lower.normal);
  if (!(facing + rate * step.longest_of_faces > ramp.none)) return;
  Planes<Dim> planes;
  const int n = common_planes<Dim>(lower, upper, section, planes,
                                   {.opening = -overlap,
                                    .barrier = candidate.normal.barrier(),
                                    .limit = candidate.normal.limit,
                                    .at_point = candidate.normal.at_point,
                                    .turned = true});
  for (int i = 0; i < n; ++i) {
    const auto& plane = planes[slot_of(i)];
    if (plane.penetration > candidate.normal.limit_at(plane.facing)) continue;
    limit_on_ramp(entities, candidate, ramp, plane.energy, (ramp.none - facing) / rate, step_limit);
  }
}

template void limit_by_turning<2>(const Entities<2>&, const FaceCandidate&, const Section&, Real,
                                  const EvaluationStep&, StepLimit&);
template void limit_by_turning<3>(const Entities<3>&, const FaceCandidate&, const Section&, Real,
                                  const EvaluationStep&, StepLimit&);
template void limit_by_turn<2>(const Entities<2>&, const FaceCandidate&, const CommonPlane<2>&,
                               StepLimit&);
template void limit_by_turn<3>(const Entities<3>&, const FaceCandidate&, const CommonPlane<3>&,
                               StepLimit&);
template void limit_by_approach<2>(const Entities<2>&, const FaceCandidate&, const EvaluationStep&,
                                   StepLimit&);
template void limit_by_approach<3>(const Entities<3>&, const FaceCandidate&, const EvaluationStep&,
                                   StepLimit&);
template void limit_by_pressed_area<2>(const Entities<2>&, const FaceCandidate&,
                                       const EvaluationStep&, StepLimit&);
template void limit_by_pressed_area<3>(const Entities<3>&, const FaceCandidate&,
                                       const EvaluationStep&, StepLimit&);
template void limit_by_barrier<2>(const Entities<2>&, const FaceCandidate&, const CommonPlane<2>&,
                                  Real, const EvaluationStep&, StepLimit&);
template void limit_by_barrier<3>(const Entities<3>&, const FaceCandidate&, const CommonPlane<3>&,
                                  Real, const EvaluationStep&, StepLimit&);

}  // namespace brunt
// Tested by tests/unit/contact/stability_test.cpp.
