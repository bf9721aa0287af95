#pragma once
#include "contact/geometry/face_plane.hpp"

namespace brunt {

/// A face as its plane, part 0, and as its halves, parts 1 and 2. A triangle has none: its plane
/// stands for them.
struct FaceParts {
  explicit FaceParts(const FacePlane<3>& face) : whole(face) {
    if (face.n_corners == 4) halves = split(face), first = 1, last = 2;
  }
  const FacePlane<3>& operator[](std::size_t i) const {
    return i == 0 ? whole : halves.part[i - 1];
  }
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
  const FacePlane<3>& whole;
  std::size_t first = 0, last = 0;  ///< parts that are its halves
  SplitFace halves;
};

}  // namespace brunt
// Tested by tests/unit/contact/overlap_push_test.cpp.
