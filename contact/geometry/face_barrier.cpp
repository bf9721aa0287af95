#include "contact/geometry/face_barrier.hpp"

#include <span>

namespace brunt {

namespace {
/// Sum of all products of `degree`, 3 at most, of the values, each as often as it is named: a
/// linear function with these values at the corners of a simplex of dimension d has
///   int u^m dV = V d! m!/(m + d)! h_m, and weighted by a corner's own coordinate
///   V d! m!/(m + d + 1)! h_m with that corner twice.
template <std::size_t N>
Real complete_sum(int degree, const std::array<Real, N>& values) {
  std::array<Real, 4> sum{};  // of the first values, by degree
  sum[0] = 1;
  for (const Real value : values) {
    for (int m = 1; m <= degree; ++m) {
      sum[slot_of(m)] += value * sum[slot_of(m - 1)];
    }
  }
  return sum[slot_of(degree)];
}
}  // namespace

DeepArea deep_area(const Polygon& overlap, const LinearField& penetration, Real cosine,
                   Real deepest, const FaceBarrier& barrier) {
  DeepArea deep;
  if (!(barrier.onset > 0) || cosine * deepest <= barrier.onset) return deep;
  deep.u.value = cosine * penetration.value - barrier.onset;
  deep.u.slope = cosine * penetration.slope;
  clip(overlap, deep.u, deep.polygon);
  const auto value = [&](int i) { return std::max(deep.u.at(deep.polygon[i]), 0.0); };
  for (int i = 1; i + 1 < deep.polygon.size; ++i) {
    const Vec<2>&p = deep.polygon[0], &q = deep.polygon[i], &r = deep.polygon[i + 1];
    const Real a = value(0), b = value(i), c = value(i + 1);
    const Vec<2> pq = q - p, pr = r - p;
    const Real twice = pq[0] * pr[1] - pq[1] * pr[0];
    deep.linear += twice / 6 * (a + b + c);
    deep.squared += twice / 12 * complete_sum<3>(2, {a, b, c});
    deep.cubed += twice / 20 * complete_sum<3>(3, {a, b, c});
    deep.moment += twice / 60 *
                   (complete_sum<4>(2, {a, a, b, c}) * p + complete_sum<4>(2, {a, b, b, c}) * q +
                    complete_sum<4>(2, {a, b, c, c}) * r);
  }
  return deep;
}

SideMeans cubic_means(Real a, Real b) {
  return {complete_sum<2>(3, {a, b}) / 4, complete_sum<3>(3, {a, b, b}) / 20};
}

}  // namespace brunt
