// The potential of the overlap of two edges in 2D (contact/geometry/overlap_push.hpp).
#include <algorithm>
#include <cmath>

#include "contact/geometry/overlap_gradient.hpp"

namespace brunt {

namespace {
/// The end of an edge at its corner c, seen along the line: distances grow into the edge.
struct End {
  Real at, into;  ///< [m], 1 or -1
};
End end_of(const OverlapLine& overlap, bool of_upper, int c) {
  const auto& edge = of_upper ? overlap.above : overlap.below;
  const Real at = edge[slot_of(c)], other = edge[slot_of(1 - c)];
  return {at, other > at ? 1.0 : -1.0};
}

class LineGradient {
 public:
  LineGradient(const OverlapLine& overlap, const BorderFade<2>& fade, Real layer,
               const CommonPlane<2>& plane)
      : overlap_(overlap),
        plane_(plane),
        layer_(layer),
        fade_(fade),
        density_(fade, plane),
        c_(plane.half_cosine()) {
    const Real m = overlap.middle();
    const Real first = overlap.first + m * overlap.area,
               moment = overlap.moment + m * overlap.total;
    push(2 * density_.squared * c_ * overlap.total + density_.linear * overlap.area,
         2 * density_.squared * c_ * moment + density_.linear * first);
    const Real steep = 3 * density_.cubed;
    push(steep * overlap.deep.squared, steep * overlap.deep.moment);
    for (const std::size_t e : {0, 1}) add_end(e);
    for (std::size_t k = 0; k < slot_of(fade.n); ++k) {
      const auto& pair = fade.pair[k];
      const Vec<2> in = density_.by_room[k] * overlap.area * plane.axis_1;
      gradient_.lower[slot_of(pair.lower)] -= end_of(overlap, false, pair.lower).into * in;
      gradient_.upper[slot_of(pair.upper)] -= end_of(overlap, true, pair.upper).into * in;
    }
    if (overlap.section.geometry == Geometry::axisymmetric) add_rings();
  }
  OverlapGradient<2>& gradient() { return gradient_; }

 private:
  void push(Real by_depth, Real moment) {
    gradient_.push += by_depth;
    gradient_.push_moment += moment * plane_.axis_1;
  }
  Real depth(Real s) const {
    const Real share = (s - overlap_.end[0]) / (overlap_.end[1] - overlap_.end[0]);
    return c_ * ((1 - share) * overlap_.penetration[0] + share * overlap_.penetration[1]);
  }
  /// dU/dA at s, where G is g, without the barrier.
  Real squares(Real s, Real g) const {
    Real sum = density_.squared * g * g + density_.linear * g + density_.uniform;
    for (std::size_t k = 0; k < slot_of(fade_.n); ++k) {
      const auto& pair = fade_.pair[k];
      const End lower = end_of(overlap_, false, pair.lower);
      const End upper = end_of(overlap_, true, pair.upper);
      sum += density_.by_room[k] * (lower.into * (s - lower.at) + upper.into * (s - upper.at));
    }
    return sum;
  }
  /// With it.
  Real density(Real s, Real g) const {
    return squares(s, g) + plane_.ramp * plane_.barrier.energy(g);
  }

  /// Moves an end of the overlap by the corner that it is, or by G where it is 0.
  void add_end(std::size_t e) {
    const Real s = overlap_.end[e];
    const Real breadth = overlap_.section.breadth(plane_.origin[0] + s * plane_.axis_1[0]);
    const Real here = breadth * density(s, c_ * overlap_.penetration[e]);
    const Vec<2> out = (e == 0 ? -here : here) * plane_.axis_1;
    for (std::size_t c = 0; c < 2; ++c) {
      if (s == overlap_.below[c]) return move(false, c, out);
    }
    for (std::size_t c = 0; c < 2; ++c) {
      if (s == overlap_.above[c]) return move(true, c, out);
    }
    const Real slope = c_ * std::fabs(overlap_.penetration[1] - overlap_.penetration[0]) /
                       (overlap_.end[1] - overlap_.end[0]);
    push(here / slope, s * here / slope);
  }

  /// Moves a corner, and the border of the other face that is flush with it.
  void move(bool of_upper, std::size_t c, const Vec<2>& out) {
    const auto is_border = [&](bool upper, std::size_t k) {
      return ((upper ? overlap_.upper_borders : overlap_.lower_borders) >> k & 1U) != 0;
    };
    const auto length = [](const std::array<Real, 2>& edge) {
      return std::fabs(edge[1] - edge[0]);
    };
    const Real width = std::min(length(overlap_.below), length(overlap_.above));
    const End end = end_of(overlap_, of_upper, static_cast<int>(c));
    Real left = 1;
    for (std::size_t k = 0; k < 2 && is_border(of_upper, c); ++k) {
      if (!is_border(!of_upper, k)) continue;
      const End other = end_of(overlap_, !of_upper, static_cast<int>(k));
      const Real part = layer_ * part_of_flush(end.at - other.at, end.into * other.into, width);
      (of_upper ? gradient_.lower : gradient_.upper)[k] += part * out;
      left -= part;
    }
    (of_upper ? gradient_.upper : gradient_.lower)[c] += left * out;
  }

  /// A ring of the plane at r: moving the plane along its normal, or turning it, changes r.
  void add_rings() {
    const Vec<2>&t = plane_.axis_1, &n = plane_.normal;
    const std::array<Real, 3> s = {overlap_.end[0], overlap_.middle(), overlap_.end[1]};
    const Real width = overlap_.end[1] - overlap_.end[0];
    Real all = 0, moment = 0;  // Simpson's rule: cubic at most
    for (std::size_t i = 0; i < 3; ++i) {
      const Real part = width * (i == 1 ? 4.0 : 1.0) / 6 * squares(s[i], depth(s[i]));
      all += part;
      moment += part * s[i];
    }
    all += density_.cubed * overlap_.deep.cubed_by_length;
    moment += density_.cubed * overlap_.deep.cubed_moment;
    gradient_.by_place = 2 * kPi * all * n[0];
    gradient_.by_normal = -2 * kPi * moment * n[0] * t;
  }

  const OverlapLine& overlap_;
  const CommonPlane<2>& plane_;
  Real layer_;
  const BorderFade<2>& fade_;
  Density<2> density_;
  Real c_;
  OverlapGradient<2> gradient_;
};
}  // namespace

BorderFade<2> fade_of(const FacePlane<2>& lower, const FacePlane<2>& upper,
                      const OverlapLine& overlap, const CommonPlane<2>& plane) {
  BorderFade<2> fade;
  const Real volume = plane.half_cosine() * overlap.total;
  const auto room_of = [&](const End& end) {
    return end.into * (overlap.first + (overlap.middle() - end.at) * overlap.area);
  };
  for (int i = 0; i < 2; ++i) {
    if ((lower.borders >> i & 1U) == 0) continue;
    const End of_lower = end_of(overlap, false, i);
    for (int j = 0; j < 2; ++j) {
      if ((upper.borders >> j & 1U) == 0) continue;
      const End of_upper = end_of(overlap, true, j);
      const Real room = room_of(of_lower) + room_of(of_upper);
      const Real between = room / overlap.area, length = overlap.end[1] - overlap.end[0];
      fade.add(
          i, j, -of_lower.into * of_upper.into,
          {volume, room, overlap.area, length < between ? length / between : 1.0, overlap.limit});
    }
  }
  return fade;
}

void add_potential(const FacePlane<2>& lower, const FacePlane<2>& upper, const OverlapLine& overlap,
                   const BorderFade<2>& fade, const PotentialShare& share, CommonPlane<2>& plane) {
  LineGradient line(overlap, fade, share.layer, plane);
  finish(lower, upper, overlap.opening, share.value, line.gradient(), plane);
}

}  // namespace brunt
// Tested by tests/unit/contact/overlap_push_test.cpp.
