#pragma once
/// Where a point lies about boxes, which it is asked of one after another.
#include <algorithm>

#include "core/search/search.hpp"
#include "core/simd.hpp"

namespace brunt {

template <int Dim>
class BoxQuery {
 public:
  explicit BoxQuery(const Vec<Dim>& x) : x_(x) {}
  /// True if the box, wider by reach [m] on all sides, holds the point.
  bool in(const SearchBox<Dim>& box, Real reach) const {
    for (int c = 0; c < Dim; ++c) {
      const auto k = slot_of(c);
      if (x_[c] < box.lo[k] - reach || x_[c] > box.hi[k] + reach) return false;
    }
    return true;
  }
  /// Squared distance [m^2] from the box, 0 inside.
  Real squared_distance(const SearchBox<Dim>& box) const {
    Real square = 0;
    for (int c = 0; c < Dim; ++c) {
      const auto k = slot_of(c);
      const Real out = std::max({box.lo[k] - x_[c], x_[c] - box.hi[k], 0.0});
      square += out * out;
    }
    return square;
  }

 private:
  Vec<Dim> x_;
};

/// The same in all components at once, without a branch. Lanes 0 .. 2 of below_ stand beside those
/// of box.lo, lanes 1 .. 3 of above_ beside those of box.hi; the fourth is beyond all boxes.
template <>
class BoxQuery<3> {
 public:
  explicit BoxQuery(const Vec3& x)
      : below_{x[0], x[1], x[2], kInfinity}, above_{-kInfinity, x[0], x[1], x[2]} {}
  bool in(const SearchBox<3>& box, Real reach) const {
    const Pack by = broadcast<Pack>(reach);
    return !any((below_ < lower(box) - by) | (above_ > upper(box) + by));
  }
  Real squared_distance(const SearchBox<3>& box) const {
    const Pack zero = broadcast<Pack>(0.0);
    const Pack before = lower(box) - below_, behind = above_ - upper(box);
    const Pack from_hi = {behind[1], behind[2], behind[3], behind[0]};
    Pack out = select(before < from_hi, from_hi, before);
    out = select(out < zero, zero, out);
    const Pack square = out * out;
    return square[0] + square[1] + square[2];
  }

 private:
  static_assert(sizeof(SearchBox<3>) == 6 * sizeof(Real));
  /// The first four numbers of the box, and the last four.
  static BRUNT_INLINE Pack lower(const SearchBox<3>& box) {
    Pack four;
    std::memcpy(&four, &box, sizeof four);
    return four;
  }
  static BRUNT_INLINE Pack upper(const SearchBox<3>& box) {
    Pack four;
    std::memcpy(&four, reinterpret_cast<const char*>(&box) + 2 * sizeof(Real), sizeof four);
    return four;
  }
  Pack below_, above_;
};

}  // namespace brunt
