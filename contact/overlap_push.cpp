#include "contact/overlap_push.hpp"

#include <cmath>

namespace brunt {

namespace {
/// What a side of the overlap gives to the corners of the edge of a face that it lies on.
/// [0] of the corner where the edge begins, [1] where it ends: int G^2/2 (share of the corner) ds.
struct SideShares {
  Real at[2];
};
/// share  along the edge where the side begins and ends; depth  G there
SideShares side_shares(const Real (&share)[2], const Real (&depth)[2], Real length) {
  const Real a = depth[0], b = depth[1];
  const Real all = length * (a * a + a * b + b * b) / 6;
  const Real late = length * (a * a + 2 * a * b + 3 * b * b) / 24;  // weighted by 0 .. 1 along it
  const Real of_end = share[0] * all + (share[1] - share[0]) * late;
  return {{all - of_end, of_end}};
}

/// Derivatives of U/k by the places of the corners in the plane, whose normal is held, and by that
/// normal and the plane's place where the breadth depends on them.
template <int Dim>
struct RimGradient {
  static constexpr int kCorners = CommonPlane<Dim>::kCorners;
  std::array<Vec<Dim>, kCorners> lower, upper;  ///< [m^3]
  Vec<Dim> by_normal = Vec<Dim>::Zero();        ///< [m^4]
  Real by_place = 0;                            ///< [m^3] along the normal
  RimGradient() {
    lower.fill(Vec<Dim>::Zero());
    upper.fill(Vec<Dim>::Zero());
  }
};

/// Adds the gradient by a face's normal, d = (dU/dn) / k, at its corners: n = D/|D|.
void add_turn(const FacePlane<3>& face, const Vec3& d, std::array<Vec3, 4>& gradient) {
  const auto& x = face.corner;
  const Vec3 w = (d - face.normal.dot(d) * face.normal) / (2 * face.area);
  if (face.n_corners == 3) {  // D = (x1 - x0) x (x2 - x0)
    const Vec3 of_1 = (x[2] - x[0]).cross(w), of_2 = w.cross(x[1] - x[0]);
    gradient[0] -= of_1 + of_2;
    gradient[1] += of_1;
    gradient[2] += of_2;
    return;
  }
  const Vec3 of_02 = (x[3] - x[1]).cross(w);  // D = (x2 - x0) x (x3 - x1)
  const Vec3 of_13 = w.cross(x[2] - x[0]);
  gradient[0] -= of_02, gradient[2] += of_02;
  gradient[1] -= of_13, gradient[3] += of_13;
}

void add_turn(const FacePlane<2>& face, const Vec<2>& d, std::array<Vec<2>, 2>& gradient) {
  const Vec<2> w = (d - face.normal.dot(d) * face.normal) / face.area;
  const Vec<2> of_1(-w[1], w[0]);  // D = (e_y, -e_x), e = x1 - x0
  gradient[0] -= of_1;
  gradient[1] += of_1;
}

/// What the rims' corners do where the plane turns: a corner at height h moves by -h dn in it.
template <int Dim>
Vec<Dim> turn_of_outlines(const FacePlane<Dim>& face, const CommonPlane<Dim>& plane,
                          const std::array<Vec<Dim>, CommonPlane<Dim>::kCorners>& rim) {
  Vec<Dim> sum = Vec<Dim>::Zero();
  for (int i = 0; i < face.n_corners; ++i) {
    const auto k = static_cast<std::size_t>(i);
    sum -= plane.normal.dot(face.corner[k] - plane.origin) * rim[k];
  }
  return sum;
}

/// Joins the parts of the gradient, and turns it to a push beside the old one.
/// total  [m^3] integral of the penetration g
template <int Dim>
void finish(const FacePlane<Dim>& lower, const FacePlane<Dim>& upper, Real opening, Real total,
            const RimGradient<Dim>& rim, CommonPlane<Dim>& plane) {
  const Real c = std::sqrt(0.5 * (1 + plane.facing));  // cos(th/2)
  const Real push = plane.ramp * c * total;            // N/k
  const Vec<Dim> outlines = rim.by_normal + turn_of_outlines(lower, plane, rim.lower) +
                            turn_of_outlines(upper, plane, rim.upper);
  const Real ramp_slope = plane.facing < kFullFacing ? 1 / (kFullFacing - kFacing) : 0.0;
  const Real fading = 0.5 * ramp_slope * c * c * total * plane.penetration;
  // By n = (n_l - n_u) / 2c, and by c itself in what of G is no distance of the faces.
  const Vec<Dim> by_plane = outlines / (2 * c) + 0.5 * push * opening * plane.normal;
  const Vec<Dim> by_lower = push * (lower.center - plane.point) + by_plane - fading * upper.normal;
  const Vec<Dim> by_upper = push * (upper.center - plane.point) - by_plane - fading * lower.normal;

  auto of_lower = rim.lower, of_upper = rim.upper;
  add_turn(lower, by_lower, of_lower);
  add_turn(upper, by_upper, of_upper);
  const Vec<Dim> place = 0.5 * rim.by_place * plane.normal;
  const Vec<Dim> lower_centre = (push * lower.normal + place) / lower.n_corners;
  const Vec<Dim> upper_centre = (push * upper.normal + place) / upper.n_corners;
  const Real share = lean_share(plane.facing);
  const auto beside = [&](const Vec<Dim>& gradient, Real weight) {
    return Vec<Dim>(share * (-gradient - weight * plane.volume * plane.normal));
  };
  plane.leans = true;
  for (int i = 0; i < lower.n_corners; ++i) {
    const auto k = static_cast<std::size_t>(i);
    plane.lower_push[k] = beside(of_lower[k] + lower_centre, -plane.lower_weight[k]);
  }
  for (int i = 0; i < upper.n_corners; ++i) {
    const auto k = static_cast<std::size_t>(i);
    plane.upper_push[k] = beside(of_upper[k] + upper_centre, plane.upper_weight[k]);
  }
}

/// Where p lies along the edge of a polygon that begins at its corner i, 0 .. 1.
Real along_edge(const Polygon& face, int i, const Vec<2>& p) {
  const Vec<2> edge = face[i + 1 == face.size ? 0 : i + 1] - face[i];
  const Real squared = edge.squaredNorm();
  return squared > 0 ? (p - face[i]).dot(edge) / squared : 0.0;
}

RimGradient<3> rim_of(const OverlapArea& overlap, const CommonPlane<3>& plane) {
  RimGradient<3> rim;
  const Real c = std::sqrt(0.5 * (1 + plane.facing));
  const auto& area = plane.polygon;
  for (int i = 0; i < area.size; ++i) {
    const int side = area.side[static_cast<std::size_t>(i)];
    if (side == Polygon::kCut) continue;
    const bool of_upper = side >= Polygon::kOfSecond;
    const Polygon& face = of_upper ? overlap.above : overlap.below;
    const int from = of_upper ? side - Polygon::kOfSecond : side;
    const int to = from + 1 == face.size ? 0 : from + 1;
    const Vec<2>& p = area[i];
    const Vec<2>& q = area[i + 1 == area.size ? 0 : i + 1];
    const Real share[2] = {along_edge(face, from, p), along_edge(face, from, q)};
    const Real depth[2] = {c * overlap.penetration.at(p), c * overlap.penetration.at(q)};
    const SideShares sums = side_shares(share, depth, plane.ramp);
    const Vec<2> out(q[1] - p[1], p[0] - q[0]);  // as long as the side
    const Vec3 outward = out[0] * plane.axis_1 + out[1] * plane.axis_2;
    // Corners of the upper face run back in its polygon.
    const auto corner = [&](int k) {
      return static_cast<std::size_t>(of_upper ? face.size - 1 - k : k);
    };
    auto& corners = of_upper ? rim.upper : rim.lower;
    corners[corner(from)] += sums.at[0] * outward;
    corners[corner(to)] += sums.at[1] * outward;
  }
  return rim;
}

RimGradient<2> rim_of(const OverlapLine& overlap, const Section& section,
                      const CommonPlane<2>& plane) {
  RimGradient<2> rim;
  const Vec<2>&t = plane.axis_1, &n = plane.normal;
  const Real squared = plane.ramp * 0.5 * (1 + plane.facing);
  const auto radius = [&](Real s) { return plane.origin[0] + s * t[0]; };
  for (std::size_t e = 0; e < 2; ++e) {
    const Real s = overlap.end[e], depth = overlap.penetration[e];
    const Real out = (e == 0 ? -0.5 : 0.5) * squared * depth * depth * section.breadth(radius(s));
    if (s == overlap.below[0] || s == overlap.below[1]) {
      rim.lower[s == overlap.below[0] ? 0 : 1] += out * t;
    } else if (s == overlap.above[0] || s == overlap.above[1]) {
      rim.upper[s == overlap.above[0] ? 0 : 1] += out * t;
    }
  }
  if (section.geometry != Geometry::axisymmetric) return rim;
  // A ring of the plane at r: moving the plane along its normal, or turning it, changes r.
  const Real a = overlap.penetration[0], b = overlap.penetration[1];
  const Real length = overlap.end[1] - overlap.end[0];
  const Real all = length * (a * a + a * b + b * b) / 3;
  const Real late = length * length * (a * a + 2 * a * b + 3 * b * b) / 12;
  rim.by_place = squared * kPi * all * n[0];
  rim.by_normal = -squared * kPi * (overlap.end[0] * all + late) * n[0] * t;
  return rim;
}
}  // namespace

void push_leaning(const FacePlane<3>& lower, const FacePlane<3>& upper, const OverlapArea& overlap,
                  CommonPlane<3>& plane) {
  finish(lower, upper, overlap.opening, overlap.total, rim_of(overlap, plane), plane);
}

void push_leaning(const FacePlane<2>& lower, const FacePlane<2>& upper, const OverlapLine& overlap,
                  const Section& section, CommonPlane<2>& plane) {
  finish(lower, upper, overlap.opening, overlap.total, rim_of(overlap, section, plane), plane);
}

}  // namespace brunt
