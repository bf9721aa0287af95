#pragma once
#include "contact/geometry/face_plane.hpp"

namespace brunt {

/// Part of a quad that counts as one plane, the rest as two triangles: from 1 to 0 without a step,
///   w = (1 - S(q)) prod_i S(c_i),   q = warp/sqrt(min(A, A_0)),   c_i = |t_i x t_i+1| / A,
/// over the band of warps about kWarpLimit, and as a corner stops being convex. Each surface has
/// its own potential of an overlap; those of both, by their parts, have one too, where a switch
/// from one to the other makes energy of their difference each time it is crossed.
struct WholePart {
  Real value = 1;
  std::array<Vec3, 4> slope;  ///< [1/m] by the corners
};
WholePart whole_part(const FacePlane<3>& face);

/// A face as the planes that stand for it: 0 the whole, 1 and 2 its triangles.
class FaceParts {
 public:
  /// both  where it is between, the whole and the triangles; else what it is more
  FaceParts(const FacePlane<3>& face, bool both);
  std::size_t first() const { return first_; }
  std::size_t last() const { return last_; }
  bool shared() const { return last_ - first_ == 3; }
  const FacePlane<3>& operator[](std::size_t i) const {
    return i == 0 ? whole_ : halves_.part[i - 1];
  }
  Real weight(std::size_t i) const { return i == 0 ? part_.value : 1 - part_.value; }
  Vec3 slope(std::size_t i, std::size_t corner) const {
    return i == 0 ? part_.slope[corner] : Vec3(-part_.slope[corner]);
  }
  /// Puts the weights of part i where the corners of the whole face are.
  template <class Value>
  void spread(std::size_t i, const Value& none, std::array<Value, 4>& weight) const {
    if (i == 0) return;
    const std::array<Value, 4> of_part = weight;
    weight.fill(none);
    for (std::size_t c = 0; c < 3; ++c) {
      weight[slot_of(halves_.corners[i - 1][c])] = of_part[c];
    }
  }

 private:
  const FacePlane<3>& whole_;
  SplitFace halves_;
  WholePart part_;
  std::size_t first_ = 0, last_ = 1;
};

}  // namespace brunt
