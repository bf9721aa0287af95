#include "contact/geometry/edge_contact.hpp"

#include <algorithm>
#include <cmath>

#include "contact/geometry/gradient_number.hpp"

namespace brunt {

namespace {
constexpr int kCorners = Facet<3>::kNodes;
constexpr Real kInFace = 0.127, kBeside = 0.24;   // sines of n against a face
constexpr Real kParallel = 0.01, kAcross = 0.09;  // squared sines of edges

template <class Number>
using Vector = std::array<Number, 3>;

template <class Number>
Vector<Number> minus(const Vector<Number>& a, const Vector<Number>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
template <class Number>
Number dot(const Vector<Number>& a, const Vector<Number>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class Number>
Vector<Number> cross(const Vector<Number>& a, const Vector<Number>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// 0 up to x = low, 1 from high on, without a kink.
template <class Number>
Number smooth_step(const Number& x, Real low, Real high) {
  if (value_of(x) <= low) return Number(0.0);
  if (value_of(x) >= high) return Number(1.0);
  const Number s = (x - Number(low)) * Number(1 / (high - low));
  return s * s * (Number(3.0) - Number(2.0) * s);
}

template <class Number>
Number size_of(const Number& x) {
  return value_of(x) < 0 ? Number(0.0) - x : x;
}

/// A face by its corners, and the edge of it in question.
template <class Number>
struct Blade {
  std::array<Vector<Number>, kCorners> corner;
  int n_corners = kCorners, edge = 0;
  std::uint8_t borders = 0;

  const Vector<Number>& at(int c) const { return corner[slot_of((c + n_corners) % n_corners)]; }
  const Vector<Number>& from() const { return at(edge); }
  Vector<Number> along() const { return minus(at(edge + 1), at(edge)); }
  Vector<Number> normal() const {
    if (n_corners == 3) return cross(minus(at(1), at(0)), minus(at(2), at(0)));
    return cross(minus(at(2), at(0)), minus(at(3), at(1)));
  }
  bool has_border(int c) const { return (borders >> ((c + n_corners) % n_corners) & 1U) != 0; }
  /// Fades out to an end of the blade, where the face has a border on the side too; from one edge
  /// to the next, which may turn away where elements are dented, over both sides of their corner.
  Number fade(const Number& share, const Number& length, Real over) const {
    const Real reach = std::min(over, 0.25 * value_of(length));
    const Number from = share * length, to = (Number(1.0) - share) * length;
    return smooth_step(from, has_border(edge - 1) ? 0 : -reach, reach) *
           smooth_step(to, has_border(edge + 1) ? 0 : -reach, reach);
  }
};

template <class Number>
struct Push {
  Number depth, share, shares_lower, shares_upper;
  Vector<Number> normal;
  bool any = false;
};

/// out_of_lower, into_upper  from the edge out of the lower face, and into the upper one
template <class Number>
Push<Number> push_of(const Blade<Number>& lower, const Blade<Number>& upper,
                     const Vec3& out_of_lower, const Vec3& into_upper, Real stiffening) {
  Push<Number> push;
  const auto u = lower.along(), v = upper.along(), w = minus(lower.from(), upper.from());
  const auto across = cross(u, v);
  const Number uu = dot(u, u), vv = dot(v, v), uv = dot(u, v), square = dot(across, across);
  if (!(value_of(square) > kParallel * value_of(uu) * value_of(vv))) return push;
  const Number uw = dot(u, w), vw = dot(v, w);
  push.shares_lower = (uv * vw - vv * uw) / square;
  push.shares_upper = (uu * vw - uv * uw) / square;
  const Vec3 n(value_of(across[0]), value_of(across[1]), value_of(across[2]));
  const Real side = out_of_lower.dot(n);
  // Blades that point the same way do not push each other, however far one is ahead.
  if (!(side * into_upper.dot(n) > 0)) return push;
  const Number scale = Number(side < 0 ? -1.0 : 1.0) / root_of(square);
  for (std::size_t c = 0; c < 3; ++c) push.normal[c] = scale * across[c];
  push.depth = dot(w, push.normal);
  if (!(value_of(push.depth) > 0)) return push;
  push.share = Number(0.25) * smooth_step(square / (uu * vv), kParallel, kAcross) *
               lower.fade(push.shares_lower, root_of(uu), stiffening) *
               upper.fade(push.shares_upper, root_of(vv), stiffening);
  for (const auto* blade : {&lower, &upper}) {
    const auto normal = blade->normal();
    const Number sine = size_of(dot(push.normal, normal)) / root_of(dot(normal, normal));
    push.share = push.share * (Number(1.0) - smooth_step(sine, kInFace, kBeside));
  }
  push.any = value_of(push.share) > 0;
  return push;
}

/// Largest second derivative of smooth_step by x where x is on its slope, else 0.
Real step_curvature(Real x, Real low, Real high) {
  return x > low && x < high ? 6 / ((high - low) * (high - low)) : 0.0;
}

/// Of a blade: of its ends, and of the sine against its face, which turns by 1/height a metre.
Real curvature_of(const Blade<Real>& blade, const Push<Real>& push, Real share, Real over) {
  const auto along = blade.along(), normal = blade.normal();
  const Real length = root_of(dot(along, along)), twice_area = root_of(dot(normal, normal));
  const Real reach = std::min(over, 0.25 * length);
  const Real sine = std::fabs(dot(push.normal, normal)) / twice_area;
  const Real height = twice_area / (blade.n_corners == 3 ? 1.0 : 2.0) / length;
  return step_curvature(share * length, blade.has_border(blade.edge - 1) ? 0 : -reach, reach) +
         step_curvature((1 - share) * length, blade.has_border(blade.edge + 1) ? 0 : -reach,
                        reach) +
         step_curvature(sine, kInFace, kBeside) / (height * height);
}

template <class Number>
Blade<Number> blade_of(const FacePlane<3>& face, int edge, int first) {
  Blade<Number> blade;
  blade.n_corners = face.n_corners, blade.edge = edge, blade.borders = face.borders;
  for (int c = 0; c < face.n_corners; ++c) {
    for (int k = 0; k < 3; ++k) {
      blade.corner[slot_of(c)][slot_of(k)] =
          variable<Number>(face.corner[slot_of(c)][k], 3 * (first + c) + k);
    }
  }
  return blade;
}

/// From the edge into the face.
Vec3 inwards(const FacePlane<3>& face, int edge) {
  const auto at = [&](int c) { return face.corner[slot_of(c % face.n_corners)]; };
  return face.normal.cross(at(edge + 1) - at(edge)).normalized();
}
}  // namespace

bool find_edge_contact(const FacePlane<3>& lower, int i, const FacePlane<3>& upper, int j,
                       const BladeDepths& depths, Real& overlap, EdgeContact& contact) {
  const Real stiffening = depths.stiffening;
  const Vec3 out_of_lower = -inwards(lower, i), into_upper = inwards(upper, j);
  const auto lower_blade = blade_of<Real>(lower, i, 0);
  const auto upper_blade = blade_of<Real>(upper, j, kCorners);
  const auto found = push_of(lower_blade, upper_blade, out_of_lower, into_upper, stiffening);
  if (found.depth > depths.farthest) overlap = found.depth;
  overlap = found.any ? std::min(overlap, found.depth) : 0;
  const Real d = found.depth - overlap;
  if (!found.any || !(d > 0)) return false;
  using Number = GradientNumber<3 * EdgeContact::kMost>;
  const auto push = push_of(blade_of<Number>(lower, i, 0), blade_of<Number>(upper, j, kCorners),
                            out_of_lower, into_upper, stiffening);
  const Number depth = push.depth - Number(overlap), square = depth * depth;
  const Number energy =
      push.share * square * (Number(0.5) + Number(0.25 / (stiffening * stiffening)) * square);
  for (int c = 0; c < 3; ++c) contact.normal[c] = found.normal[slot_of(c)];
  const Real s = found.shares_lower, t = found.shares_upper;
  contact.penetration = d;
  contact.share = found.share;
  contact.force = found.share * d * (1 + d * d / (stiffening * stiffening));
  contact.energy = energy.value;
  contact.fade_curvature = curvature_of(lower_blade, found, s, stiffening) +
                           curvature_of(upper_blade, found, t, stiffening);
  contact.weight.fill(0);
  const auto corner = [](const FacePlane<3>& face, int c) { return slot_of(c % face.n_corners); };
  const std::size_t a = corner(lower, i), b = corner(lower, i + 1);
  const std::size_t p = corner(upper, j), q = corner(upper, j + 1);
  contact.weight[a] = s - 1, contact.weight[b] = -s;
  contact.weight[kCorners + p] = 1 - t, contact.weight[kCorners + q] = t;
  contact.point = 0.5 * ((1 - s) * lower.corner[a] + s * lower.corner[b] +
                         (1 - t) * upper.corner[p] + t * upper.corner[q]);
  for (std::size_t k = 0; k < contact.push.size(); ++k) {
    const Vec3 slope(energy.slope[3 * k], energy.slope[3 * k + 1], energy.slope[3 * k + 2]);
    contact.push[k] = -slope - contact.weight[k] * contact.force * contact.normal;
  }
  return true;
}

}  // namespace brunt
