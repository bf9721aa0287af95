#pragma once
#include "contact/geometry/face_plane.hpp"

namespace brunt {

/// A face as a plane, as its two halves, or as both where it is on its way from one to the other.
struct FaceParts {
  explicit FaceParts(const FacePlane<3>& face) : whole(face) {
    if (face.split > 0) halves = split(face);
  }
  const FacePlane<3>& operator[](std::size_t i) const {
    return i == 0 ? whole : halves.part[i - 1];
  }
  Real share(std::size_t i) const { return i == 0 ? 1 - whole.split : whole.split; }
  /// Puts the weights of part i where the corners of the whole face are.
  template <class Value>
  void spread(std::size_t i, const Value& none, std::array<Value, 4>& weight) const {
    if (i == 0) return;
    const std::array<Value, 4> of_part = weight;
    weight.fill(none);
    for (std::size_t c = 0; c < 3; ++c) {
      weight[slot_of(halves.corners[i - 1][c])] = of_part[c];
    }
  }
  /// Adds the push of an energy [m^4] that passes from the whole to its halves.
  void add_push(std::size_t i, Real energy, std::array<Vec3, 4>& push) const {
    if (whole.split == 0 || whole.split == 1) return;
    const auto gradient = split_gradient(whole);
    for (std::size_t c = 0; c < 4; ++c) push[c] += (i == 0 ? energy : -energy) * gradient[c];
  }
  const FacePlane<3>& whole;
  SplitFace halves;
};

}  // namespace brunt
// Tested by tests/unit/contact/overlap_push_test.cpp.
