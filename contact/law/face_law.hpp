#pragma once
#include <algorithm>

#include "contact/geometry/face_barrier.hpp"
#include "contact/geometry/soft_layer.hpp"
#include "contact/law/contact_state.hpp"

namespace brunt {

/// The spring and damper between two faces along their normal, by area (docs/theory/contact.md
/// (C9), (C15), (C16), (C46) to (C48)).
struct FaceLaw {
  Real stiffness = 0;      ///< [Pa/m]
  Real damping = 0;        ///< [Pa s/m]
  Real limit = 0;          ///< [m] penetration at which they let go: the smaller depth
  Real leaning = 0;        ///< [m] the same where they meet at an angle
  bool at_point = false;   ///< pressure is that at the middle of an overlap
  SoftLayer layer{};       ///< over the spring, where one body rests on the other
  Real layer_damping = 0;  ///< [Pa s/m] of it

  /// The penetration [m] at which faces let go that meet by this cosine.
  Real limit_at(Real facing) const {
    return leaning > limit ? leaning + FaceBarrier::part_at(facing) * (limit - leaning) : limit;
  }
  FaceBarrier barrier() const { return FaceBarrier::before(limit); }
  /// [N] of the dampers, without what may not pull. That of a soft layer acts in the layer alone,
  /// so that impacts go through it with next to no loss. at  area, closing, and the mean
  /// penetration of the layer
  Real damping_force(const ContactState& at) const {
    const bool in_layer = at.penetration != 0;
    if (!in_layer) return damping * at.area * at.closing;
    const Real part = layer.damped(at.penetration);
    const Real most = stiffness * at.area * layer.most_damped(at.penetration);
    return std::clamp(part * layer_damping * at.area * at.closing, -most, most) +
           (1 - part) * damping * at.area * at.closing;
  }
};

}  // namespace brunt
// Tested by tests/unit/contact/soft_layer_test.cpp.
