#pragma once
/// The corners of one side of a contact, a lane each: what friction does to all of them at once.
#include <array>
#include <cmath>

#include "contact/contacts/friction.hpp"
#include "contact/contacts/record.hpp"
#include "contact/law/spring_slider.hpp"
#include "contact/surfaces/face_side.hpp"

namespace brunt {

template <int Dim>
BRUNT_INLINE CornerVectors<Dim> all(const Vec<Dim>& v) {
  CornerVectors<Dim> of;
  for (std::size_t c = 0; c < Dim; ++c) of[c] = broadcast<Pack>(v[c]);
  return of;
}
/// What a turn does to each corner.
BRUNT_INLINE CornerVectors<2> turn(Real w, const CornerVectors<2>& r) {
  return {broadcast<Pack>(-w) * r[1], broadcast<Pack>(w) * r[0]};
}
BRUNT_INLINE CornerVectors<3> turn(const Vec3& w, const CornerVectors<3>& r) {
  return cross(all<3>(w), r);
}

/// One side of a contact: its corners, and what they give by their weights at the point of contact.
template <int Dim>
struct SideCorners {
  static_assert(Facet<Dim>::kNodes <= kLanes);
  const FaceSide<Dim>& face;
  int n;
  Pack weight;                           // [1]
  Vec<Dim> point = Vec<Dim>::Zero();     // [m] of contact, on the face
  Vec<Dim> velocity = Vec<Dim>::Zero();  // [m/s] there

  SideCorners(const FaceSide<Dim>& of_face, const std::array<Real, Friction<Dim>::kNodes>& weights,
              const ContactSide& side)
      : face(of_face), n(side.last - side.first) {
    // Lane by lane it would go through memory, and wait for its own stores.
    const Real* const of = &weights[slot_of(side.first)];
    if (n == kLanes) {
      weight = load(of);
    } else {
      weight = Pack{of[0], n > 1 ? of[1] : 0.0, n > 2 ? of[2] : 0.0, 0.0};
    }
    const Pack zero = broadcast<Pack>(0.0);
    const auto at_point = [&](const CornerVectors<Dim>& of_corner, const Vec<Dim>& mean,
                              Vec<Dim>& value) {
      CornerVectors<Dim> weighted;
      for (std::size_t c = 0; c < Dim; ++c) weighted[c] = weight * of_corner[c];
      const Pack sum = sums_of(weighted, zero);
      for (int c = 0; c < Dim; ++c) value[c] = mean[c] + sum[c];
    };
    at_point(face.arm, face.mean, point);
    at_point(face.v, face.mean_velocity, velocity);
  }
};

/// Adds the spin of a face about the new normal, as a unit vector of its cosine and sine.
inline void add_spin(const SideCorners<3>& side, const PlaneTurn<3>& turn, const Vec3& normal,
                     Real dt, Real& cosine, Real& sine) {
  const CornerVectors<3> n = all<3>(normal), &arm = side.face.arm;
  CornerVectors<3> before;
  for (std::size_t c = 0; c < 3; ++c) before[c] = arm[c] - dt * side.face.v[c];
  before = turn.tilted(before);
  const Pack cosines = dot(before, arm) - dot(n, before) * dot(n, arm);
  const Pack sines = dot(n, cross(before, arm));
  const Pack sums = sums_of(cosines, sines, sines, sines);
  const Real c = sums[0], s = sums[1];
  const Real size = std::sqrt(c * c + s * s);
  if (!(size > 0)) return;
  cosine += c / size, sine += s / size;
}

}  // namespace brunt
// Tested by tests/unit/contact/friction_law_test.cpp.
