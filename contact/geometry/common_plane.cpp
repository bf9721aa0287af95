#include "contact/geometry/common_plane.hpp"

#include <algorithm>
#include <cmath>

#include "contact/geometry/bilinear_weights.hpp"
#include "contact/geometry/overlap_push.hpp"

namespace brunt {

namespace {
constexpr Real kTouching = 1e-12;  // of the face's size: a mean penetration below it is none
constexpr Real kSliver = 1e-12;    // of the smaller face's area: an overlap below it is none

/// The normal, origin and ramp; false if the faces do not oppose each other.
template <int Dim>
bool orient(const FacePlane<Dim>& lower, const FacePlane<Dim>& upper, const PlaneNeeds& needs,
            CommonPlane<Dim>& plane) {
  const Real facing = -lower.normal.dot(upper.normal);
  const FacingRamp<Dim> ramp(lower, upper);
  if (!(facing > (needs.turned ? kMayTurn : ramp.none))) return false;
  plane.facing = facing;
  plane.share = 0;
  plane.layered = 0;
  plane.fade = 1;
  plane.barrier = needs.barrier.at(facing);
  plane.ramp = needs.turned ? 1.0 : ramp.at(facing);
  plane.ramp_growth = needs.turned ? 0.0 : ramp.growth(facing);
  plane.normal = (lower.normal - upper.normal).normalized();
  plane.origin = 0.5 * (lower.center + upper.center);
  return true;
}

/// True if every corner of the upper face, warped by no more than it is, lies above the lower.
template <int Dim>
bool apart(const FacePlane<Dim>& lower, const FacePlane<Dim>& upper, const Vec<Dim>& n,
           const Vec<Dim>& origin, Real opening) {
  Real top = -kInfinity, bottom = kInfinity;
  for (int i = 0; i < lower.n_corners; ++i) {
    top = std::max(top, n.dot(lower.corner[slot_of(i)] - origin));
  }
  for (int i = 0; i < upper.n_corners; ++i) {
    bottom = std::min(bottom, n.dot(upper.corner[slot_of(i)] - origin));
  }
  // The planes lean against n by 45 degrees at most: their corners are nearer than 1.42 warps.
  return bottom - top >= 1.42 * (lower.warp + upper.warp) + opening;
}

/// Mean plane of a face as a height along n over the common plane.
LinearField height(const FacePlane<3>& face, const CommonPlane<3>& plane) {
  const Real along = face.normal.dot(plane.normal);
  LinearField field;
  field.value = face.normal.dot(face.center - plane.origin) / along;
  field.slope =
      Vec<2>(-face.normal.dot(plane.axis_1) / along, -face.normal.dot(plane.axis_2) / along);
  return field;
}

void set_axes(CommonPlane<3>& plane) {
  // The smallest component decides; equal ones go to the first.
  Eigen::Index smallest = 0;
  plane.normal.cwiseAbs().minCoeff(&smallest);
  const Vec3 unit = Vec3::Unit(smallest);
  plane.axis_1 = (unit - unit.dot(plane.normal) * plane.normal).normalized();
  plane.axis_2 = plane.normal.cross(plane.axis_1);
}

/// Corners in the plane, counter-clockwise about the normal: those of the upper face run back.
Polygon project(const FacePlane<3>& face, const CommonPlane<3>& plane, bool reverse) {
  Polygon polygon;
  for (int i = 0; i < face.n_corners; ++i) {
    const int k = reverse ? face.n_corners - 1 - i : i;
    const Vec3 arm = face.corner[slot_of(k)] - plane.origin;
    polygon.push(Vec<2>(arm.dot(plane.axis_1), arm.dot(plane.axis_2)),
                 static_cast<std::uint8_t>(i));
  }
  return polygon;
}

std::array<Real, 4> weights(const Polygon& face, bool reverse, const Vec<2>& p) {
  std::array<Real, 4> in_order{};
  if (face.size == 4) {
    in_order = bilinear_weights({face[0], face[1], face[2], face[3]}, p);
  } else {
    const Vec<2> a = face[1] - face[0], b = face[2] - face[0], r = p - face[0];
    const Real twice = a[0] * b[1] - a[1] * b[0];
    in_order[1] = (r[0] * b[1] - r[1] * b[0]) / twice;
    in_order[2] = (a[0] * r[1] - a[1] * r[0]) / twice;
    in_order[0] = 1 - in_order[1] - in_order[2];
  }
  if (reverse) std::reverse(in_order.begin(), in_order.begin() + face.size);
  return in_order;
}

/// Weights of both faces at two points: most faces are quads, whose weights are found together.
void set_weights(const Polygon& below, const Polygon& above, const Vec<2>& p, const Vec<2>& middle,
                 CommonPlane<3>& plane) {
  if (below.size != 4 || above.size != 4) {
    plane.lower_weight = weights(below, false, p);
    plane.upper_weight = weights(above, true, p);
    plane.lower_at_middle = weights(below, false, middle);
    plane.upper_at_middle = weights(above, true, middle);
    return;
  }
  const auto found = bilinear_weights(below, above, p, middle);
  plane.lower_weight = found[0], plane.upper_weight = found[1];
  plane.lower_at_middle = found[2], plane.upper_at_middle = found[3];
}

/// Lets the spring fade as omega, and its barrier as omega^3: what came in over borders is as deep
/// as the bodies are long there, where a barrier would push a hundred times as hard as the sides
/// that meet.
template <int Dim>
void set_fade(Real omega, CommonPlane<Dim>& plane) {
  plane.fade = omega;
  plane.ramp *= omega;
  plane.barrier.strength *= omega * omega;
}

/// Sets volume and energy of a plane; returns the share that its barrier has of the push.
/// total  [m^3] integral of the penetration;  mean  [m] where the linear pressure acts
/// deep   DeepArea or DeepLine;  whole  one pressure everywhere, of the mean penetration
template <int Dim, class Deep>
Real set_spring(Real total, Real mean, const Deep& deep, bool whole, CommonPlane<Dim>& plane) {
  const auto& barrier = plane.barrier;
  const Real linear = 0.25 * (1 + plane.facing) * total * mean;
  Real beside = 0, energy = 0;
  plane.mean_slope = 1;
  if (whole) {
    plane.mean_slope = barrier.tangent(mean);
    beside = plane.area * barrier.pressure(mean);
    energy = plane.area * barrier.energy(mean);
  } else if (deep.squared > 0) {
    plane.mean_slope = 1 + 2 * barrier.steepness() * deep.linear / plane.area;
    beside = plane.half_cosine() * barrier.steepness() * deep.squared;
    energy = barrier.steepness() / 3 * deep.cubed;
  }
  plane.volume = plane.ramp * (total + beside);
  plane.energy = plane.ramp * (linear + energy);
  plane.energy_by_fade = plane.ramp * (linear + 3 * energy);
  plane.energy_by_facing = plane.ramp_growth * plane.energy + barrier.growth * plane.ramp * energy;
  return whole ? 0.0 : beside / (total + beside);
}

/// The plane between two simple faces in 3D; false if it carries no pressure.
bool one_plane(const FacePlane<3>& lower, const FacePlane<3>& upper, const Section&,
               const PlaneNeeds& needs, CommonPlane<3>& plane) {
  if (!orient(lower, upper, needs, plane)) return false;
  if (!needs.whole && apart(lower, upper, plane.normal, plane.origin, needs.opening)) return false;
  set_axes(plane);
  const Polygon below = project(lower, plane, false), above = project(upper, plane, true);
  const Polygon overlap = intersect(below, above);
  const Real smaller = std::min(lower.area, upper.area);
  if (!(area(overlap) > kSliver * smaller)) return false;
  const bool whole = needs.whole || needs.at_point;

  const LinearField top = height(lower, plane), bottom = height(upper, plane);
  LinearField penetration;
  penetration.value = top.value - bottom.value + needs.opening;
  penetration.slope = top.slope - bottom.slope;
  if (whole) {
    plane.polygon = overlap;
  } else {
    clip(overlap, penetration, plane.polygon);
  }
  const FieldIntegrals sum = integrate(plane.polygon, penetration);
  // What is left of an overlap where it penetrates may be a line: its area, of either sign, is
  // round-off.
  if (!(sum.area > kSliver * smaller)) return false;
  if (!needs.whole && !(sum.total > kTouching * std::sqrt(smaller) * sum.area)) return false;
  plane.deepest = -kInfinity;
  for (int i = 0; i < plane.polygon.size; ++i) {
    plane.deepest = std::max(plane.deepest, penetration.at(plane.polygon[i]));
  }

  const DeepArea deep = whole ? DeepArea()
                              : deep_area(plane.polygon, penetration, plane.half_cosine(),
                                          plane.deepest, plane.barrier);
  const OverlapArea area{below,         above, penetration,   sum,        lower.borders,
                         upper.borders, deep,  needs.opening, needs.limit};
  const bool pushes = needs.pushes && !whole;
  const auto fade = pushes ? fade_of(lower, upper, area, plane) : BorderFade<3>();
  if (fade.factor == 0) return false;
  set_fade(fade.factor, plane);
  plane.area = sum.area;
  Vec<2> p = whole ? Vec<2>(sum.first / sum.area) : Vec<2>(sum.moment / sum.total);
  const Real of_barrier = set_spring(sum.total, penetration.at(p), deep, whole, plane);
  if (of_barrier > 0) p += of_barrier * (deep.moment / deep.squared - p);
  plane.penetration = penetration.at(p);
  plane.point = plane.origin + p[0] * plane.axis_1 + p[1] * plane.axis_2;
  const Vec<2> middle = needs.middle ? Vec<2>(sum.first / sum.area) : p;
  set_weights(below, above, p, middle, plane);
  if (needs.middle) {
    plane.middle = plane.origin + middle[0] * plane.axis_1 + middle[1] * plane.axis_2;
  }
  if (!pushes) return true;
  const PotentialShare share = potential_share(plane.facing, area.change(plane), fade);
  if (share.value > 0) add_potential(lower, upper, area, fade, share, plane);
  return true;
}

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

/// The line between two edges in 2D; the integrands are cubic at most, so Simpson is exact.
bool one_plane(const FacePlane<2>& lower, const FacePlane<2>& upper, const Section& section,
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

/// True where a face counts as four triangles beside a mate. Beside one that keeps its plane it
/// does so from nearly no warp on: else its corners may be deep in the mate while its plane hardly
/// touches it, and push all at once where it is split, again and again where it trembles there.
bool is_split(const FacePlane<3>& face, const FacePlane<3>& mate) {
  constexpr Real kBlunt = 0.99 * kBoxSharpness;  // edges and points dig into one plane, not in four
  return !face.simple || (mate.rigid && mate.sharpness > kBlunt && !face.rigid && !face.flat);
}

/// A face as itself, or as the four triangles of one that is split.
struct Parts {
  Parts(const FacePlane<3>& face, const FacePlane<3>& mate) : whole(face) {
    if (!is_split(face, mate)) return;
    parts = split(face);
    count = 4;
  }
  const FacePlane<3>& operator[](std::size_t i) const { return count == 1 ? whole : parts[i]; }
  /// Puts the weights of part i where the corners of the whole face are: of its centre each corner
  /// has a quarter.
  template <class Value>
  void spread(std::size_t i, std::array<Value, 4>& weight) const {
    if (count == 1) return;
    const std::array<Value, 4> of_part = weight;
    weight.fill(0.25 * of_part[2]);
    weight[i] += of_part[0];
    weight[(i + 1) % 4] += of_part[1];
  }
  const FacePlane<3>& whole;
  std::array<FacePlane<3>, 4> parts;
  std::size_t count = 1;
};

int split_planes(const FacePlane<3>& lower, const FacePlane<3>& upper, const Section& section,
                 const PlaneNeeds& needs, Planes<3>& plane) {
  const Parts below(lower, upper), above(upper, lower);
  std::size_t n = 0;
  for (std::size_t i = 0; i < below.count; ++i) {
    for (std::size_t j = 0; j < above.count; ++j) {
      if (!one_plane(below[i], above[j], section, needs, plane[n])) continue;
      plane[n].ordinal = static_cast<std::uint32_t>(4 * i + j);
      below.spread(i, plane[n].lower_weight);
      above.spread(j, plane[n].upper_weight);
      below.spread(i, plane[n].lower_at_middle);
      above.spread(j, plane[n].upper_at_middle);
      if (plane[n].share > 0) {
        below.spread(i, plane[n].lower_push);
        above.spread(j, plane[n].upper_push);
      }
      ++n;
    }
  }
  return static_cast<int>(n);
}
}  // namespace

template <int Dim>
int common_planes(const FacePlane<Dim>& lower, const FacePlane<Dim>& upper, const Section& section,
                  Planes<Dim>& plane, const PlaneNeeds& needs) {
  if constexpr (Dim == 3) {
    if (is_split(lower, upper) || is_split(upper, lower)) {
      return split_planes(lower, upper, section, needs, plane);
    }
  }
  plane[0].ordinal = 0;
  return one_plane(lower, upper, section, needs, plane[0]) ? 1 : 0;
}

template int common_planes<2>(const FacePlane<2>&, const FacePlane<2>&, const Section&, Planes<2>&,
                              const PlaneNeeds&);
template int common_planes<3>(const FacePlane<3>&, const FacePlane<3>&, const Section&, Planes<3>&,
                              const PlaneNeeds&);

}  // namespace brunt
