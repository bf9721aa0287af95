#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/evaluate/before_step.hpp"
#include "contact/evaluate/edges.hpp"
#include "contact/evaluate/face_notes.hpp"
#include "contact/evaluate/face_planes.hpp"
#include "contact/evaluate/face_step_limits.hpp"
#include "contact/evaluate/pairs_ahead.hpp"
#include "contact/evaluate/ties.hpp"

namespace brunt {

namespace {
/// Names the corners that share the force and returns their mean velocity [m/s].
template <int Dim>
BRUNT_INLINE Vec<Dim> add_corners(const ContactNodes<Dim>& nodes, const ContactFace<Dim>& face,
                                  const std::array<Real, Facet<Dim>::kNodes>& weight, Real sign,
                                  ContactRecord<Dim>& record) {
  const auto n = slot_of(face.n_nodes), first = slot_of(record.n_nodes);
  for (std::size_t k = 0; k < n; ++k) {
    record.node[first + k] = face.node[k];
    record.weight[first + k] = sign * weight[k];
  }
  record.n_nodes += face.n_nodes;
  Vec<Dim> velocity = Vec<Dim>::Zero();
  for (std::size_t k = 0; k < n; ++k) velocity += weight[k] * nodes.v[slot_of(face.node[k])];
  return velocity;
}

/// How fast two faces close at the centre of their pressure [m/s].
template <int Dim>
Real closing_speed(const Entities<Dim>& entities, const FaceCandidate& candidate,
                   const CommonPlane<Dim>& plane) {
  const auto velocity = [&](LocalIndex place, const auto& weight) {
    const auto& face = entities.faces[slot_of(place)];
    Vec<Dim> sum = Vec<Dim>::Zero();
    for (std::size_t c = 0; c < slot_of(face.n_nodes); ++c) {
      sum += weight[c] * entities.nodes.v[slot_of(face.node[c])];
    }
    return sum;
  };
  return (velocity(candidate.lower, plane.lower_weight) -
          velocity(candidate.upper, plane.upper_weight))
      .dot(plane.normal);
}

/// The fastest of the corners of two faces against one of them [m/s].
template <int Dim>
Real fastest_corner(const Entities<Dim>& entities, const FaceCandidate& candidate) {
  const auto& lower = entities.faces[slot_of(candidate.lower)];
  const Vec<Dim>& from = entities.nodes.v[slot_of(lower.node[0])];
  Real squared = 0;
  for (const LocalIndex place : {candidate.lower, candidate.upper}) {
    const auto& face = entities.faces[slot_of(place)];
    for (std::size_t c = 0; c < slot_of(face.n_nodes); ++c) {
      const Vec<Dim>& v = entities.nodes.v[slot_of(face.node[c])];
      squared = std::max(squared, (v - from).squaredNorm());
    }
  }
  return std::sqrt(squared);
}

/// True where the faces were beyond their limit at the last evaluation, at the centre of pressure
/// that they had then, as those that let go are: they have gone through each other elsewhere, or
/// where they did not face each other, and would begin at the top of their barrier. Those that meet
/// from before push first where they touch, those that turn to each other or come over each other
/// where their pressure fades in. What has come out as far as the barrier's onset has nothing left
/// to be spared.
template <int Dim>
bool comes_from_behind(const Entities<Dim>& entities, const FaceCandidate& candidate,
                       const CommonPlane<Dim>& plane, const Section& section, Real dt) {
  if (plane.deepest <= plane.barrier.onset) return false;
  // Both faces may have moved: most pairs cannot have been as deep.
  const auto& law = candidate.normal;
  if (plane.deepest + 2 * fastest_corner(entities, candidate) * dt <= law.limit) return false;
  Planes<Dim> planes;
  const int n = common_planes<Dim>(
      before_step(entities, candidate.lower, dt), before_step(entities, candidate.upper, dt),
      section, planes, {.barrier = law.barrier(), .limit = law.limit, .at_point = law.at_point});
  // Deeper than the thinner body only what has dug in may push: not what turns there (C9).
  if (n == 0 && plane.penetration > law.limit) return true;
  for (const auto& one : std::span(planes.data(), slot_of(n))) {
    if (one.penetration > law.limit_at(one.facing)) return true;
  }
  return false;
}

/// Appends the record of a plane, filled where it stands.
template <int Dim>
void add_record(const Entities<Dim>& entities, const FaceCandidate& candidate,
                const CommonPlane<Dim>& plane, const FirstTouch& touch, const EvaluationStep& step,
                typename Records<Dim>::Part& part) {
  const auto& lower = entities.faces[slot_of(candidate.lower)];
  const auto& upper = entities.faces[slot_of(candidate.upper)];
  ContactRecord<Dim>& record = part.face_on_face.emplace_back();
  record.ordinal = plane.ordinal;
  record.first = lower.id, record.second = upper.id;
  record.first_place = candidate.lower, record.second_place = candidate.upper;
  record.lower_body = lower.body, record.upper_body = upper.body;
  record.normal = plane.normal;
  record.point = plane.point;
  record.area = plane.area;
  record.penetration = plane.fade * plane.penetration;
  const Vec<Dim> v_lower = add_corners(entities.nodes, lower, plane.lower_weight, -1, record);
  const Vec<Dim> v_upper = add_corners(entities.nodes, upper, plane.upper_weight, 1, record);
  const Real closing = (v_lower - v_upper).dot(plane.normal);
  record.spring = candidate.normal.stiffness * plane.volume;
  record.stored = candidate.normal.stiffness * plane.energy;
  limit_by_barrier<Dim>(entities, candidate, plane, closing, step, part.step_limit);
  limit_by_turn<Dim>(entities, candidate, plane, part.step_limit);
  record.damping = candidate.normal.damping_force(
      {.area = plane.ramp * plane.area, .penetration = plane.layered, .closing = closing});
  record.opening = -touch.overlap;
  record.bonded = touch.bonded;
  if (!touch.bonded) record.damping = std::max(record.damping, -record.spring);
}

/// Keeps what the last record of the part gets beside its push along the normal.
template <int Dim>
void add_push(Real stiffness, const CommonPlane<Dim>& plane, int n_lower,
              typename Records<Dim>::Part& part) {
  auto& record = part.face_on_face.back();
  record.push = static_cast<std::int32_t>(part.pushes.size());
  auto& pushes = part.pushes.emplace_back();
  pushes.n_lower = n_lower;
  for (int i = 0; i < record.n_nodes; ++i) {
    const auto& push =
        i < n_lower ? plane.lower_push[slot_of(i)] : plane.upper_push[slot_of(i - n_lower)];
    pushes.force[slot_of(i)] = stiffness * push;
  }
}

/// What a new contact takes over from those that its faces had, on the upper side [Pa].
template <int Dim>
Vec<Dim> inherited(const FaceTraction<Dim>& lower, const FaceTraction<Dim>& upper) {
  const Real area = lower.area + upper.area;
  if (!(area > 0)) return Vec<Dim>::Zero();
  return (upper.force - lower.force) / area;
}

/// What two faces say of the growth of the area between them, 0 where one does not know: areas that
/// pass from pair to pair of one face are no change.
Real common_growth(Real a, Real b) {
  if (a == 0 || b == 0) return a + b;
  if ((a - 1) * (b - 1) < 0) return 1;
  return std::fabs(a - 1) < std::fabs(b - 1) ? a : b;
}

/// Part of a traction that is left where the area under pressure changes: t sqrt(A) stays, so that
/// the spring keeps its energy. What comes under pressure carries nothing yet, and what is lifted
/// off takes nothing along. Rigid faces that stand on every rank know nothing of their contacts.
template <int Dim>
Real kept_traction(const Entities<Dim>& entities, const FaceCandidate& candidate) {
  const auto growth_of = [&](LocalIndex f) {
    const auto k = slot_of(f);
    return entities.faces[k].rigid() ? 0.0 : entities.tractions[k].growth;
  };
  const Real growth = common_growth(growth_of(candidate.lower), growth_of(candidate.upper));
  return growth > 0 ? 1 / std::sqrt(growth) : 1.0;
}

template <int Dim>
void add_friction(const Entities<Dim>& entities, const FaceCandidate& candidate,
                  const CommonPlane<Dim>& plane, const Section& section, Real dt,
                  const BrokenTies<Dim>& broken, FrictionHistory<Dim>& history, FirstTouch& touch,
                  typename Records<Dim>::Part& part) {
  const auto l = slot_of(candidate.lower);
  const auto u = slot_of(candidate.upper);
  auto& record = part.face_on_face.back();
  const int n_lower = entities.faces[l].n_nodes;
  const bool torques = section.geometry != Geometry::axisymmetric;
  FrictionStep<Dim> step;
  step.laws = &candidate.laws;
  step.lower = {0, n_lower, torques && !entities.faces[l].rigid()};
  step.upper = {n_lower, record.n_nodes, torques && !entities.faces[u].rigid()};
  step.lower_face = entities.side_of(l), step.upper_face = entities.side_of(u);
  // All there is room for: what is copied by number is moved in one go.
  std::copy(plane.lower_at_middle.begin(), plane.lower_at_middle.end(), step.weight.begin());
  std::copy(plane.upper_at_middle.begin(), plane.upper_at_middle.end(),
            step.weight.begin() + n_lower);
  step.area = plane.ramp * plane.area;
  step.pressed = plane.area;
  step.bonded = touch.bonded;
  step.stiffness = candidate.normal.stiffness;
  if (candidate.laws.holds != nullptr && candidate.laws.holds->joint) {
    step.stiffness =
        spring_between(entities.faces[l], entities.faces[u], *candidate.laws.holds).shear;
  }
  step.damping = candidate.normal.damping;
  step.dt = dt;
  set_face_material(entities, candidate, record, step);
  step.before = history.of_faces(key_of(record), part.past);
  step.kept = kept_traction(entities, candidate);
  if (step.before == nullptr) {
    step.inherited =
        broken.any ? broken.traction : inherited(entities.tractions[l], entities.tractions[u]);
  }
  record.friction = static_cast<std::int32_t>(part.frictions.size());
  auto& friction = part.frictions.emplace_back();
  find_friction(entities.nodes, record, step, friction);
  const bool slid = friction.slips && candidate.laws.bond.breaks_by_slip();
  touch.slips = touch.slips || slid;
  heat_faces(entities, candidate, step, part);
}

/// The first of some planes that comes from behind; nullptr where none does.
template <int Dim>
const CommonPlane<Dim>* from_behind(const Entities<Dim>& entities, const FaceCandidate& candidate,
                                    std::span<const CommonPlane<Dim>> planes,
                                    const Section& section, Real dt) {
  for (const auto& plane : planes) {
    if (plane.penetration > candidate.normal.limit_at(plane.facing)) continue;
    if (comes_from_behind(entities, candidate, plane, section, dt)) return &plane;
  }
  return nullptr;
}

/// True where two faces come from behind: they are left alone until they have opened.
template <int Dim>
bool leave_alone(const Entities<Dim>& entities, const FaceCandidate& candidate,
                 std::span<const CommonPlane<Dim>> planes, const Section& section, Real dt,
                 FirstTouch& touch, typename Records<Dim>::Part& part) {
  const auto* plane = from_behind(entities, candidate, planes, section, dt);
  if (plane == nullptr) return false;
  touch.overlap = deepest_of<Dim>(planes);
  // An overlap that came in over borders is held by the faces beside it.
  if (plane->fade > 0.5)
    note_lost(entities, candidate, *plane, kFromBehind, plane->penetration, part);
  return true;
}

/// [Pa/m] of the last record's spring: a joint has its own.
template <int Dim>
Real spring_of(const Entities<Dim>& entities, const FaceCandidate& candidate,
               const CommonPlane<Dim>& plane, const EvaluationStep& step,
               const BrokenTies<Dim>& broken, typename Records<Dim>::Part& part) {
  const Real linear = candidate.normal.stiffness;
  if (candidate.laws.holds == nullptr || !candidate.laws.holds->joint) return linear;
  return linear * close_joint(entities, candidate, plane, step, broken, part);
}

/// Holds two faces of a pair that is tied or a joint, where they are; begins it at time 0. What
/// they keep of an overlap of time 0 waits until they are held no more.
template <int Dim>
bool held(const Entities<Dim>& entities, const FaceCandidate& candidate, const Section& section,
          const EvaluationStep& step, BrokenTies<Dim>& broken, typename Records<Dim>::Part& part) {
  if (candidate.laws.holds == nullptr) return false;
  if (step.touches.time_zero) {
    const std::size_t before = part.face_ties.size();
    begin_face_ties(entities, candidate, section, part);
    // What is held where it is presses no more than it did.
    return candidate.laws.presses_at_once() && part.face_ties.size() > before;
  }
  const PartEnds ends{part.face_on_face.size(), part.face_heat.size()};
  if (!hold_faces(entities, candidate, section, step, broken, part)) return false;
  const auto& record = part.face_on_face.back();
  const auto key = touch_key(ContactKind::face_face, record.first, record.second);
  const FirstTouch touch = touch_before(entities, candidate, key, section, step.touches);
  if (touch.matters()) part.face_touches.push_back(touch);
  if (candidate.laws.heat != nullptr) add_face_heat<Dim>(entities, candidate, section, ends, part);
  return true;
}

/// Adds what planes push.
template <int Dim>
void add_planes(const Entities<Dim>& entities, const FaceCandidate& candidate,
                std::span<const CommonPlane<Dim>> planes, bool held, const Section& section,
                const EvaluationStep& step, const BrokenTies<Dim>& broken,
                FrictionHistory<Dim>* history, FirstTouch& touch,
                typename Records<Dim>::Part& part) {
  for (const auto& plane : planes) {
    if (plane.penetration > candidate.normal.limit_at(plane.facing) &&
        !(held && is_sliver(entities, candidate, plane))) {
      const Real way = closing_speed(entities, candidate, plane) * step.dt;
      if (!any_born(entities, candidate)) note_let_go(entities, candidate, plane, way, held, part);
      continue;
    }
    add_record(entities, candidate, plane, touch, step, part);
    note_deep_faces(entities, candidate, plane, touch, part);
    const Real stiffness = spring_of(entities, candidate, plane, step, broken, part);
    if (plane.share > 0) {
      add_push(stiffness, plane, entities.faces[slot_of(candidate.lower)].n_nodes, part);
    }
    if (candidate.laws.friction == nullptr || history == nullptr) continue;
    add_friction(entities, candidate, plane, section, step.dt, broken, *history, touch, part);
  }
}

/// room  for planes that have not been found ahead
template <int Dim>
void evaluate_pair(const Entities<Dim>& entities, PairAhead<Dim>& pair, const Section& section,
                   const EvaluationStep& step, FrictionHistory<Dim>* history, Planes<Dim>& room,
                   typename Records<Dim>::Part& part) {
  const FaceCandidate& candidate = pair.candidate;
  if (step.fast) limit_by_approach<Dim>(entities, candidate, step, part.step_limit);
  limit_by_pressed_area<Dim>(entities, candidate, step, part.step_limit);
  BrokenTies<Dim> broken;
  if (held<Dim>(entities, candidate, section, step, broken, part)) return;
  if (!pair.in_reach) return;
  std::span<const CommonPlane<Dim>> planes = pair.find_planes(entities, section, step, room);
  FirstTouch& touch = pair.touch;
  const bool held = std::exchange(touch.held, false);
  const bool new_here = !touch.matters() && !held;
  if (new_here && leave_alone(entities, candidate, planes, section, step.dt, touch, part)) {
    planes = {};  // all of them, or a repeated evaluation would find others than this one
  }
  if (planes.empty() && !step.touches.time_zero) {
    limit_by_turning<Dim>(entities, candidate, section, touch.overlap, step, part.step_limit);
  }
  const PartEnds ends{part.face_on_face.size(), part.face_heat.size()};
  add_planes(entities, candidate, planes, held, section, step, broken, history, touch, part);
  if (touch.matters() || touch.held) {
    touch.key = key_between(entities, candidate);
    part.face_touches.push_back(touch);
  }
  add_blades(entities, candidate, step, any_born(entities, candidate), part);
  if (broken.any) {
    settle_broken<Dim>(entities, broken, std::span(part.face_on_face).subspan(ends.record), step.dt,
                       part, part.losses);
  }
  const bool free = part.face_on_face.size() == ends.record && !touch.matters();
  if (free) note_crossing<Dim>(entities, candidate, part);
  if (candidate.laws.heat != nullptr) add_face_heat<Dim>(entities, candidate, section, ends, part);
}
}  // namespace

template <int Dim>
void evaluate_faces(const Entities<Dim>& entities, const FacePairs<Dim>& pairs,
                    const Section& section, const EvaluationStep& step,
                    FrictionHistory<Dim>* history, typename Records<Dim>::Part& part) {
  PairsAhead<Dim> ahead(entities, pairs, step);
  Planes<Dim> room;
  for (auto block = ahead.next(); !block.empty(); block = ahead.next()) {
    for (auto& pair : block) {
      evaluate_pair<Dim>(entities, pair, section, step, history, room, part);
    }
  }
}

template void evaluate_faces<2>(const Entities<2>&, const FacePairs<2>&, const Section&,
                                const EvaluationStep&, FrictionHistory<2>*, Records<2>::Part&);
template void evaluate_faces<3>(const Entities<3>&, const FacePairs<3>&, const Section&,
                                const EvaluationStep&, FrictionHistory<3>*, Records<3>::Part&);

}  // namespace brunt
// Tested by tests/unit/contact/manager_test.cpp.
