#pragma once
/// What is noted of two faces that do not hold, or hardly.
#include <algorithm>

#include "contact/contacts/deep.hpp"
#include "contact/evaluate/evaluate.hpp"
#include "contact/geometry/crossing.hpp"

namespace brunt {

/// True for planes of less than a hundredth of the smaller face: they come and go deep at the
/// borders of faces, where what they would push is next to nothing, and are all that a corner has,
/// which pushes as much as any other contact.
template <int Dim>
bool is_sliver(const Entities<Dim>& entities, const FaceCandidate& candidate,
               const CommonPlane<Dim>& plane) {
  constexpr Real kSliver = 0.01;
  const Real smaller = std::min(entities.planes[slot_of(candidate.lower)].area,
                                entities.planes[slot_of(candidate.upper)].area);
  // In 2D as a length, as that of faces.
  const Real pressed = Dim == 3 ? plane.area : plane.polygon[1][0] - plane.polygon[0][0];
  return pressed < kSliver * smaller;
}

/// Notes a plane that lets go, one that comes from behind, or one that is deep.
/// depth  [m]
template <int Dim>
void note_lost(const Entities<Dim>& entities, const FaceCandidate& candidate,
               const CommonPlane<Dim>& plane, std::uint32_t how, Real depth,
               typename Records<Dim>::Part& part) {
  const auto& lower = entities.faces[slot_of(candidate.lower)];
  const auto& upper = entities.faces[slot_of(candidate.upper)];
  if (is_sliver(entities, candidate, plane)) return;
  part.lost.push_back({{ContactKind::face_face, how, lower.id, upper.id},
                       lower.body,
                       upper.body,
                       0,
                       depth,
                       plane.point});
}

/// Where the faces of a plane push most of what they hold deep, remembers and reports it. What
/// borders fade is held by the faces beside it; what opens from an overlap of time 0 was as deep
/// without a force.
template <int Dim>
void note_deep_faces(const Entities<Dim>& entities, const FaceCandidate& candidate,
                     const CommonPlane<Dim>& plane, FirstTouch& touch,
                     typename Records<Dim>::Part& part) {
  if (plane.deepest <= FirstTouch::kHeldFrom * candidate.normal.limit_at(plane.facing)) return;
  touch.held = true;
  if (plane.fade <= 0.5 || touch.matters()) return;
  note_lost(entities, candidate, plane, kDeep, plane.deepest, part);
}

/// Notes a plane beyond the limit, whose faces push no more, where they did at the last evaluation:
/// by the way of the step it was within the limit then. What is seen from behind was beyond it then
/// too, and what opens comes nearer. What borders fade is held by the faces beside it.
/// way   [m] how much deeper the plane is for the step
/// held  the faces pushed most of what they hold
template <int Dim>
void note_let_go(const Entities<Dim>& entities, const FaceCandidate& candidate,
                 const CommonPlane<Dim>& plane, Real way, bool held,
                 typename Records<Dim>::Part& part) {
  const Real limit = candidate.normal.limit_at(plane.facing);
  if (plane.fade > 0.5 && (held || plane.penetration - way <= limit)) {
    note_lost(entities, candidate, plane, kLetGo, plane.penetration, part);
  }
}

/// Notes two faces that go through each other deeper than contacts are held, though nothing here
/// pushes them apart.
template <int Dim>
void note_crossing(const Entities<Dim>& entities, const FaceCandidate& candidate,
                   typename Records<Dim>::Part& part) {
  const auto l = slot_of(candidate.lower);
  const auto u = slot_of(candidate.upper);
  Crossing<Dim> found;
  if (!entities.boxes[l].meets(entities.boxes[u])) return;
  if (!find_crossing(entities.planes[l], entities.planes[u], candidate.normal.limit, found)) return;
  const auto &lower = entities.faces[l], &upper = entities.faces[u];
  part.lost.push_back({{ContactKind::face_face, kCrossed, lower.id, upper.id},
                       lower.body,
                       upper.body,
                       0,
                       found.depth,
                       found.point});
}

}  // namespace brunt
// Tested by tests/unit/contact/lost_test.cpp.
