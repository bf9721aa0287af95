#include "contact/geometry/crossing.hpp"

#include <algorithm>
#include <cmath>

namespace brunt {

namespace {
/// Heights [m] of the corners of a face above the plane of another.
template <int Dim>
struct Heights {
  std::array<Real, FacePlane<Dim>::kCorners> at{};
  Real least = kInfinity, largest = -kInfinity;

  Heights(const FacePlane<Dim>& face, const FacePlane<Dim>& over) {
    for (std::size_t c = 0; c < slot_of(face.n_corners); ++c) {
      at[c] = over.normal.dot(face.corner[c] - over.center);
      least = std::min(least, at[c]);
      largest = std::max(largest, at[c]);
    }
  }
};

/// Where a face meets the plane over which its corners have these heights, along a direction.
struct SharedSpan {
  Real from = kInfinity, to = -kInfinity;  // [m] from `origin`

  SharedSpan(const FacePlane<3>& face, const Heights<3>& height, const Vec3& direction,
             const Vec3& origin) {
    const auto n = slot_of(face.n_corners);
    for (std::size_t c = 0; c < n; ++c) {
      const std::size_t next = (c + 1) % n;
      const Real a = height.at[c], b = height.at[next];
      if ((a < 0) == (b < 0)) continue;
      const Vec3 x = face.corner[c] + a / (a - b) * (face.corner[next] - face.corner[c]);
      from = std::min(from, direction.dot(x - origin));
      to = std::max(to, direction.dot(x - origin));
    }
  }
};

/// The line that two faces share [m]; none: 0 or less.
Real shared_line(const FacePlane<3>& lower, const FacePlane<3>& upper, const Heights<3>& of_lower,
                 const Heights<3>& of_upper, Vec3& middle) {
  const Vec3 along = lower.normal.cross(upper.normal);
  const Real sine = along.norm();
  if (!(sine > 0)) return 0;
  const Vec3 direction = along / sine, origin = upper.center;
  const SharedSpan a(lower, of_lower, direction, origin), b(upper, of_upper, direction, origin);
  const Real from = std::max(a.from, b.from), to = std::min(a.to, b.to);
  // From the upper face's centre down its own plane to the lower face's.
  const Vec3 down = upper.normal.cross(direction);
  const Real height = lower.normal.dot(origin - lower.center);
  const Vec3 foot = origin - height / lower.normal.dot(down) * down;
  middle = foot + (0.5 * (from + to) - direction.dot(foot - origin)) * direction;
  return to - from;
}
Real shared_line(const FacePlane<2>&, const FacePlane<2>& upper, const Heights<2>&,
                 const Heights<2>& of_upper, Vec<2>& point) {
  const Real a = of_upper.at[0], b = of_upper.at[1];
  point = upper.corner[0] + a / (a - b) * (upper.corner[1] - upper.corner[0]);
  return kInfinity;
}
}  // namespace

template <int Dim>
bool find_crossing(const FacePlane<Dim>& lower, const FacePlane<Dim>& upper, Real limit,
                   Crossing<Dim>& crossing) {
  const Heights<Dim> of_upper(upper, lower);
  if (!(of_upper.least < -limit && of_upper.largest > 0)) return false;
  const Heights<Dim> of_lower(lower, upper);
  if (!(of_lower.least < -limit && of_lower.largest > 0)) return false;
  Vec<Dim> point;
  const Real line = shared_line(lower, upper, of_lower, of_upper, point);
  if (!(line > limit)) return false;
  crossing.depth = std::min({-of_upper.least, -of_lower.least, line});
  crossing.point = point;
  return true;
}

template bool find_crossing<2>(const FacePlane<2>&, const FacePlane<2>&, Real, Crossing<2>&);
template bool find_crossing<3>(const FacePlane<3>&, const FacePlane<3>&, Real, Crossing<3>&);

}  // namespace brunt
