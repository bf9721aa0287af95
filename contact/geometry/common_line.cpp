/// The common plane of two edges in 2D: a line.
#include <algorithm>
#include <cmath>

#include "contact/geometry/overlap_push.hpp"
#include "contact/geometry/plane_parts.hpp"

namespace brunt {

namespace {
/// An edge along the common line: places s of its corners there, and their heights above it.
struct Span {
  Real s0, s1, h0, h1;
  Real share(Real s) const { return (s - s0) / (s1 - s0); }
  Real height(Real s) const { return h0 + share(s) * (h1 - h0); }
};

/// t  unit vector of the line
Span span_of(const FacePlane<2>& face, const CommonPlane<2>& plane, const Vec<2>& t) {
  const Vec<2> a = face.corner[0] - plane.origin, b = face.corner[1] - plane.origin;
  return Span{a.dot(t), b.dot(t), a.dot(plane.normal), b.dot(plane.normal)};
}

/// Ends a line that penetrates at one end alone where the depth [m] passes 0.
void leave_out_gap(Real& from, Real& to, std::array<Real, 2>& depth) {
  const Real crossing = from + (to - from) * depth[0] / (depth[0] - depth[1]);
  if (depth[0] < 0) from = crossing, depth[0] = 0;
  if (depth[1] < 0) to = crossing, depth[1] = 0;
}

/// Integrals over a line by Simpson's rule: of 1, s - middle, g and g (s - middle).
struct LineIntegrals {
  Real area = 0, first = 0, total = 0, moment = 0;
};

/// depth  [m] g at both ends, linear between;  breadth  [m] at a place of the line
template <class Breadth>
LineIntegrals integrate(Real from, Real to, const std::array<Real, 2>& depth,
                        const Breadth& breadth) {
  const Real middle = 0.5 * (from + to);
  const std::array<Real, 3> s = {from, middle, to}, share = {1.0 / 6, 4.0 / 6, 1.0 / 6};
  const std::array<Real, 3> g = {depth[0], 0.5 * (depth[0] + depth[1]), depth[1]};
  LineIntegrals sum;
  for (std::size_t i = 0; i < 3; ++i) {
    const Real strip = (to - from) * share[i] * breadth(s[i]);
    sum.area += strip;
    sum.first += strip * (s[i] - middle);
    sum.total += strip * g[i];
    sum.moment += strip * g[i] * (s[i] - middle);
  }
  return sum;
}

/// Sets the line itself, and the place p where its force acts with the weights of both edges there.
void place_line(const Span& below, const Span& above, const std::array<Real, 2>& end, Real p,
                const Vec<2>& t, CommonPlane<2>& plane) {
  plane.point = plane.origin + p * t;
  plane.axis_1 = t;
  plane.axis_2.setZero();
  plane.polygon.size = 0;
  plane.polygon.push(Vec<2>(end[0], 0));
  plane.polygon.push(Vec<2>(end[1], 0));
  plane.lower_weight = {1 - below.share(p), below.share(p)};
  plane.upper_weight = {1 - above.share(p), above.share(p)};
}

/// The same of the middle m of the area.
void place_middle(const Span& below, const Span& above, Real m, const Vec<2>& t,
                  CommonPlane<2>& plane) {
  plane.middle = plane.origin + m * t;
  plane.lower_at_middle = {1 - below.share(m), below.share(m)};
  plane.upper_at_middle = {1 - above.share(m), above.share(m)};
}
}  // namespace

/// The line between two edges in 2D; the integrands are cubic at most, so Simpson is exact.
bool common_line(const FacePlane<2>& lower, const FacePlane<2>& upper, const Section& section,
                 const PlaneNeeds& needs, CommonPlane<2>& plane) {
  if (!orient(lower, upper, needs, plane)) return false;
  if (!needs.whole && apart(lower, upper, plane.normal, plane.origin, needs.opening)) return false;
  const Vec<2> t(-plane.normal[1], plane.normal[0]);
  const Span below = span_of(lower, plane, t), above = span_of(upper, plane, t);
  Real from = std::max(std::min(below.s0, below.s1), std::min(above.s0, above.s1));
  Real to = std::min(std::max(below.s0, below.s1), std::max(above.s0, above.s1));
  const Real smaller = std::min(lower.area, upper.area);
  const auto penetration = [&](Real s) {
    return below.height(s) - above.height(s) + needs.opening;
  };
  std::array<Real, 2> depth = {penetration(from), penetration(to)};
  plane.deepest = std::max(depth[0], depth[1]);
  const bool whole = needs.whole || needs.at_point;
  if (!needs.whole && plane.deepest <= 0) return false;
  if (!whole) leave_out_gap(from, to, depth);
  if (!(to - from > kSliver * smaller)) return false;

  const Real middle = 0.5 * (from + to);
  const auto breadth = [&](Real s) { return section.breadth(plane.origin[0] + s * t[0]); };
  const auto [area, first, total, moment] = integrate(from, to, depth, breadth);
  if (!needs.whole && !(total > kTouching * smaller * area)) return false;

  DeepLine deep;
  if (!whole) {
    const Real c = plane.half_cosine();
    deep = deep_line({from, to}, {c * depth[0], c * depth[1]}, plane.barrier, breadth);
  }
  const OverlapLine line{{below.s0, below.s1},
                         {above.s0, above.s1},
                         {from, to},
                         depth,
                         area,
                         first,
                         total,
                         moment,
                         lower.borders,
                         upper.borders,
                         deep,
                         needs.opening,
                         needs.limit,
                         section};
  const bool pushes = needs.pushes && !whole;
  const auto fade = pushes ? fade_of(lower, upper, line, plane) : BorderFade<2>();
  if (fade.factor == 0) return false;
  set_fade(fade.factor, plane);
  plane.area = area;
  Real p = middle + (whole ? first / area : moment / total);
  const Real of_barrier = set_spring(total, penetration(p), deep, whole, plane);
  if (of_barrier > 0) p += of_barrier * (deep.moment / deep.squared - p);
  plane.penetration = penetration(p);
  place_line(below, above, {from, to}, p, t, plane);
  if (needs.middle) place_middle(below, above, middle + first / area, t, plane);
  if (!pushes) return true;
  const PotentialShare follows = potential_share(plane.facing, line.change(), fade);
  if (follows.value > 0) add_potential(lower, upper, line, fade, follows, plane);
  return true;
}

}  // namespace brunt
// Tested by tests/unit/contact/common_plane_test.cpp.
