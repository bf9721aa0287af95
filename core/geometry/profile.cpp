#include "core/geometry/profile.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

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

}  // namespace brunt
