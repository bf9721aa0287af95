#include "contact/evaluate/face_step_limits.hpp"

#include <algorithm>
#include <cmath>

#include "contact/evaluate/face_planes.hpp"
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

/// Sum of the weights of corners by their masses [1/kg].
template <int Dim>
Real inverse_mass(const Entities<Dim>& entities, const ContactFace<Dim>& face,
                  const std::array<Real, Facet<Dim>::kNodes>& weight) {
  Real sum = 0;
  for (std::size_t c = 0; c < slot_of(face.n_nodes); ++c) {
    const Real mass = entities.nodes.mass[slot_of(face.node[c])];
    if (mass > 0) sum += weight[c] / mass;
  }
  return sum;
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

/// How the cosine between two faces gives way to what turns one of them, sum |grad|^2/m over its
/// corners [1/(kg m^2)]. Rigid bodies turn slowly. A half of a split face turns as fast by half of
/// its width.
/// other  normal of the other face
Real turns(const Entities<3>& entities, LocalIndex place, const Vec3& other) {
  const auto& face = entities.faces[slot_of(place)];
  if (!face.deforms()) return 0;
  const auto& plane = entities.planes[slot_of(place)];
  const auto& x = plane.corner;
  const Vec3 w = (other - plane.normal.dot(other) * plane.normal) / (2 * plane.area);
  std::array<Real, 4> squared{};
  if (plane.n_corners == 3) {
    const Vec3 of_1 = (x[2] - x[0]).cross(w), of_2 = w.cross(x[1] - x[0]);
    squared = {(of_1 + of_2).squaredNorm(), of_1.squaredNorm(), of_2.squaredNorm(), 0};
  } else {
    const Real of_02 = (x[3] - x[1]).cross(w).squaredNorm();
    const Real of_13 = w.cross(x[2] - x[0]).squaredNorm();
    squared = {of_02, of_13, of_02, of_13};
  }
  constexpr Real kHalves = 2;
  return (plane.simple ? 1 : kHalves) * inverse_mass<3>(entities, face, squared);
}
Real turns(const Entities<2>& entities, LocalIndex place, const Vec<2>& other) {
  const auto& face = entities.faces[slot_of(place)];
  if (!face.deforms()) return 0;
  const auto& plane = entities.planes[slot_of(place)];
  const Vec<2> w = (other - plane.normal.dot(other) * plane.normal) / plane.area;
  return inverse_mass<2>(entities, face, {w.squaredNorm(), w.squaredNorm()});
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

template <int Dim>
void limit_by_turning(const Entities<Dim>& entities, const FaceCandidate& candidate,
                      const Section& section, StepLimit& step_limit) {
  // Needles have many such sides: their steps would be a sixth and less, for energies that end with
  // so short a range.
  constexpr Real kNeedle = 0.01;
  constexpr Real kShallow = 0.25;  // of the depth at which they let go
  const auto &lower = entities.planes[slot_of(candidate.lower)],
             &upper = entities.planes[slot_of(candidate.upper)];
  const auto deforms = [&](LocalIndex place) { return entities.faces[slot_of(place)].deforms(); };
  if (!deforms(candidate.lower) && !deforms(candidate.upper)) return;
  const FacingRamp<Dim> ramp(lower, upper);
  const Real facing = -lower.normal.dot(upper.normal), width = ramp.whole - ramp.none;
  // The whole between none and whole, nothing as far again on both sides: the step changes before
  // the moment comes.
  const Real beside = std::max(ramp.none - facing, facing - ramp.whole) / width;
  const Real blunt = std::clamp(width / kNeedle - 1, 0.0, 1.0);
  if (!(beside < 1 && blunt > 0)) return;
  FacePlane<Dim> facing_lower = lower;  // of a body so sharp that they push with all they have
  facing_lower.sharpness =
      (1 - 1e-9) * facing / ramp.whole * std::min(lower.sharpness, upper.sharpness);
  Planes<Dim> planes;
  const int n = common_planes<Dim>(facing_lower, upper, section, planes,
                                   {.barrier = candidate.normal.barrier()});
  Real energy = 0;
  for (int i = 0; i < n; ++i) {
    const auto& plane = planes[slot_of(i)];
    // What is shallow has next to nothing to give.
    const Real deep = plane.deepest / candidate.normal.limit / kShallow - 1;
    energy += std::clamp(deep, 0.0, 1.0) * plane.energy;
  }
  if (!(energy > 0)) return;
  const Real steepest =
      blunt * std::min(1 - beside, 1.0) * 6 * candidate.normal.stiffness * energy / (width * width);
  const Real turning = steepest * (turns(entities, candidate.lower, upper.normal) +
                                   turns(entities, candidate.upper, lower.normal));
  Real squared = 0;  // of the elements
  for (const LocalIndex place : {candidate.lower, candidate.upper}) {
    const auto& face = entities.faces[slot_of(place)];
    if (face.deforms() && face.element_step > 0) squared += 1 / std::pow(face.element_step, 2);
  }
  // No step is more than halved for it: needles of elements would take thrice the work.
  constexpr Real kMost = 3;
  squared += squared > 0 ? std::min(turning, kMost * squared) : turning;
  const auto& face = entities.faces[slot_of(candidate.lower)];
  if (squared > 0)
    step_limit.take({1 / std::sqrt(squared), "contact stiffness", face.body, face.id});
}

template void limit_by_turning<2>(const Entities<2>&, const FaceCandidate&, const Section&,
                                  StepLimit&);
template void limit_by_turning<3>(const Entities<3>&, const FaceCandidate&, const Section&,
                                  StepLimit&);
template void limit_by_approach<2>(const Entities<2>&, const FaceCandidate&, const EvaluationStep&,
                                   StepLimit&);
template void limit_by_approach<3>(const Entities<3>&, const FaceCandidate&, const EvaluationStep&,
                                   StepLimit&);
template void limit_by_barrier<2>(const Entities<2>&, const FaceCandidate&, const CommonPlane<2>&,
                                  Real, const EvaluationStep&, StepLimit&);
template void limit_by_barrier<3>(const Entities<3>&, const FaceCandidate&, const CommonPlane<3>&,
                                  Real, const EvaluationStep&, StepLimit&);

}  // namespace brunt
// Tested by tests/unit/contact/stability_test.cpp.
