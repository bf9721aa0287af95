#include "contact/evaluate/face_planes.hpp"

#include <algorithm>

#include "contact/evaluate/evaluate.hpp"

namespace brunt {

PlaneNeeds needs_of(const FaceCandidate& candidate, Real opening) {
  return {.middle = candidate.laws.friction != nullptr,
          .opening = opening,
          .barrier = candidate.normal.barrier(),
          .limit = candidate.normal.limit,
          .at_point = candidate.normal.at_point};
}

namespace {
/// Planes that push, with the layer on which bodies rest.
template <int Dim>
int pressing_planes(const FacePlane<Dim>& lower, const FacePlane<Dim>& upper,
                    const Section& section, const FaceCandidate& candidate, Real opening,
                    Planes<Dim>& planes) {
  const PlaneNeeds needs = needs_of(candidate, opening);
  if (!candidate.normal.layer.acts())
    return common_planes<Dim>(lower, upper, section, planes, needs);
  return layered_planes<Dim>(lower, upper, section, candidate.normal.layer, planes, needs);
}

/// True where a bond opens beyond its strength.
template <int Dim>
bool tears(const Planes<Dim>& planes, int n, const FaceCandidate& candidate) {
  constexpr Real kWidest = 0.25;  // of the depth: farther, the lists may not see both faces
  for (int i = 0; i < n; ++i) {
    const Real opening = std::max(-planes[slot_of(i)].penetration, 0.0);
    if (candidate.laws.bond.tears(candidate.normal.stiffness * opening)) return true;
    if (opening > kWidest * candidate.normal.limit) return true;
  }
  return false;
}

/// True where a plane that pushed would be beyond the limit: its faces are seen from behind. Its
/// deepest corner may be beyond though it pushes: faces that lean into each other.
template <int Dim>
bool beyond_limit(const CommonPlane<Dim>& plane, const Planes<Dim>& pressed, int n,
                  const FaceLaw& law) {
  const auto end = pressed.begin() + n;
  const auto same = std::find_if(pressed.begin(), end, [&](const CommonPlane<Dim>& other) {
    return other.ordinal == plane.ordinal;
  });
  return same != end && same->penetration > law.limit_at(same->facing);
}
}  // namespace

template <int Dim>
FirstTouch first_touch(const FacePlane<Dim>& lower, const FacePlane<Dim>& upper,
                       const Section& section, const FaceCandidate& candidate) {
  FirstTouch touch;
  Planes<Dim> planes;
  const int n = common_planes<Dim>(lower, upper, section, planes, {.whole = true});
  if (n == 0) return touch;
  Planes<Dim> pressed;  // whether they fade or not: what has faded is as deep as it is
  const int n_pressed = common_planes<Dim>(lower, upper, section, pressed,
                                           {.pushes = false,
                                            .barrier = candidate.normal.barrier(),
                                            .at_point = candidate.normal.at_point});
  const Real meets = meeting_distance(lower, upper);
  for (int i = 0; i < n; ++i) {
    const auto& plane = planes[slot_of(i)];
    if (beyond_limit<Dim>(plane, pressed, n_pressed, candidate.normal)) continue;
    const Real ignored = ignored_overlap(candidate.laws.initial_overlap, plane.deepest, meets);
    touch.overlap = std::max(touch.overlap, ignored);
    touch.bonded = touch.bonded || candidate.laws.bond.begins(-plane.penetration, meets);
  }
  return touch;
}

template <int Dim>
Real deepest_of(std::span<const CommonPlane<Dim>> planes) {
  Real deepest = 0;
  for (const auto& plane : planes) deepest = std::max(deepest, plane.deepest);
  return deepest;
}

template <int Dim>
FirstTouch born_touch(const FacePlane<Dim>& lower, const FacePlane<Dim>& upper,
                      const Section& section) {
  FirstTouch touch;
  Planes<Dim> planes;
  const int n = common_planes<Dim>(lower, upper, section, planes, {.whole = true});
  const Real deepest = deepest_of<Dim>({planes.data(), slot_of(n)});
  if (deepest > meeting_distance(lower, upper)) touch.overlap = deepest;
  return touch;
}

template <int Dim>
int planes_of(const FacePlane<Dim>& lower, const FacePlane<Dim>& upper, const Section& section,
              const FaceCandidate& candidate, const TouchStep& step, FirstTouch& touch,
              Planes<Dim>& planes) {
  if (!touch.matters()) {
    return pressing_planes<Dim>(lower, upper, section, candidate, 0, planes);
  }
  if (!step.again) {
    touch.bonded = touch.bonded && !touch.slips;
    touch.slips = false;
  }
  int n = common_planes<Dim>(lower, upper, section, planes, {.whole = true});
  touch.overlap = std::min(touch.overlap, deepest_of<Dim>({planes.data(), slot_of(n)}));
  touch.bonded = touch.bonded && n > 0;
  if (touch.bonded) {
    n = common_planes<Dim>(lower, upper, section, planes,
                           {.middle = true,
                            .opening = -touch.overlap,
                            .whole = true,
                            .barrier = candidate.normal.barrier()});
    if (!tears(planes, n, candidate)) return n;
    touch.bonded = false;
  }
  return pressing_planes<Dim>(lower, upper, section, candidate, -touch.overlap, planes);
}

template FirstTouch first_touch<2>(const FacePlane<2>&, const FacePlane<2>&, const Section&,
                                   const FaceCandidate&);
template FirstTouch born_touch<2>(const FacePlane<2>&, const FacePlane<2>&, const Section&);
template FirstTouch born_touch<3>(const FacePlane<3>&, const FacePlane<3>&, const Section&);
template Real deepest_of<2>(std::span<const CommonPlane<2>>);
template int planes_of<2>(const FacePlane<2>&, const FacePlane<2>&, const Section&,
                          const FaceCandidate&, const TouchStep&, FirstTouch&, Planes<2>&);
template FirstTouch first_touch<3>(const FacePlane<3>&, const FacePlane<3>&, const Section&,
                                   const FaceCandidate&);
template Real deepest_of<3>(std::span<const CommonPlane<3>>);
template int planes_of<3>(const FacePlane<3>&, const FacePlane<3>&, const Section&,
                          const FaceCandidate&, const TouchStep&, FirstTouch&, Planes<3>&);

}  // namespace brunt
// Tested by tests/unit/contact/manager_test.cpp.
