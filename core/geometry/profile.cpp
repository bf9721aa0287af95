#include "core/geometry/profile.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace brunt {

namespace {
/// Simpson's rule over each smooth part, fine enough for 1e-9 of a volume.
template <class Function>
Real integrate(const std::vector<Real>& breaks, Function f) {
  constexpr int n = 2000;
  Real sum = 0;
  for (std::size_t part = 0; part + 1 < breaks.size(); ++part) {
    const Real a = breaks[part], h = (breaks[part + 1] - a) / n;
    Real partial = f(a) + f(a + n * h);
    for (int i = 1; i < n; ++i) partial += (i % 2 ? 4 : 2) * f(a + i * h);
    sum += partial * h / 3;
  }
  return sum;
}
}  // namespace

Real Profile::largest() const {
  Real r = 0;
  for (const Real s : breaks) r = std::max(r, radius(s));
  return r;
}

Real Profile::volume() const {
  return kPi * integrate(breaks, [this](Real s) { return radius(s) * radius(s); });
}

Real Profile::area() const {
  return 2 * integrate(breaks, [this](Real s) { return radius(s); });
}

Profile cylinder_profile(Real radius, Real length) {
  return {length, {0, length}, [radius](Real) { return radius; }};
}

Profile ogive_profile(const Ogive& ogive) {
  const Real R = ogive.radius, N = ogive.nose, shank = ogive.length - ogive.nose;
  if (!(shank >= 0)) throw std::invalid_argument("`nose` is longer than the whole ogive");
  if (!(N > 0)) throw std::invalid_argument("`nose` must be longer than 0");
  const Real arc = (R * R + N * N) / (2 * R);
  return {ogive.length, {0, shank, ogive.length}, [=](Real s) {
            const Real t = s - shank;
            if (t <= 0) return R;
            return std::max(Real{0}, std::sqrt(std::max(Real{0}, arc * arc - t * t)) - (arc - R));
          }};
}

bool inside_polygon(const std::vector<Vec<2>>& points, const Vec<2>& x) {
  bool inside = false;
  for (std::size_t i = 0, j = points.size() - 1; i < points.size(); j = i++) {
    const auto& a = points[i];
    const auto& b = points[j];
    if ((a[1] > x[1]) == (b[1] > x[1])) continue;
    if (x[0] < a[0] + (b[0] - a[0]) * (x[1] - a[1]) / (b[1] - a[1])) inside = !inside;
  }
  return inside;
}

void require_simple(const std::vector<Vec<2>>& points) {
  const std::size_t n = points.size();
  if (n < 3) throw std::invalid_argument("a polygon needs at least three points");
  const auto turn = [](const Vec<2>& a, const Vec<2>& b, const Vec<2>& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  };
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j + 1 == n) continue;  // these two share a point
      const auto &a = points[i], &b = points[i + 1], &c = points[j], &d = points[(j + 1) % n];
      if (turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0) {
        throw std::invalid_argument(
            "the polygon crosses itself: the side from point " + std::to_string(i) +
            " cuts that from point " + std::to_string(j) +
            " (counted from 0); list the points in order along its outline");
      }
    }
  }
  Real area = 0, longest = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const auto &a = points[i], &b = points[(i + 1) % n];
    area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
    longest = std::max(longest, (b - a).norm());
  }
  constexpr Real kFlat = 1e-12;  // of the square of its longest side
  if (!(std::fabs(area) > kFlat * longest * longest)) {
    throw std::invalid_argument("the polygon has no area: its points lie on a line");
  }
}

}  // namespace brunt
// Tested by tests/unit/core/shapes_test.cpp.
