#include "core/geometry/grading.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace brunt {

void describe(Schema& s, Grading& grading) {
  static constexpr const char* kEnds[] = {"min", "max", "both", "middle"};
  s.choice({"axis", "axis of the deck, before the shape is turned", Need::required}, grading.axis,
           s.axes());
  s.real({"ratio", "largest over smallest element size along the axis", Need::required},
         grading.ratio, {"1", at_least(1), between(1, 1000)});
  s.choice(
      {"toward", "where elements are finer: at an end, at both, or in the middle", Need::required},
      grading.toward, kEnds);
}

namespace {
/// Sizes of n layers over the smallest, from the min end.
std::vector<Real> relative_sizes(const Grading& grading, int n) {
  // steps from the smallest to the largest
  const int last = grading.symmetric() ? (n - 1) / 2 : n - 1;
  std::vector<Real> sizes;
  for (int i = 0; i < n; ++i) {
    const int from_end = grading.symmetric() ? std::min(i, n - 1 - i) : i;
    const int step = grading.toward == Toward::middle ? last - from_end : from_end;
    sizes.push_back(std::pow(grading.ratio, static_cast<Real>(step) / last));
  }
  if (grading.toward == Toward::max) std::reverse(sizes.begin(), sizes.end());
  return sizes;
}

int fewest(const Grading& grading) { return grading.symmetric() ? 3 : 2; }

/// The thickest of n layers over the whole length.
Real largest_share(const Grading& grading, int n) {
  Real sum = 0;
  for (const Real size : relative_sizes(grading, n)) sum += size;
  return grading.ratio / sum;
}
}  // namespace

std::optional<Grading> turned(const Grading* grading, bool against) {
  if (!grading) return {};
  Grading seen = *grading;
  if (against && !seen.symmetric()) {
    seen.toward = seen.toward == Toward::min ? Toward::max : Toward::min;
  }
  return seen;
}

std::vector<Real> graded_layers(const Grading& grading, int n) {
  if (n < fewest(grading)) {
    throw GradingError("a smallest and a largest element take " + std::to_string(fewest(grading)) +
                       " along the axis, and it has " + std::to_string(n) +
                       ": give more `cells` or take the grading out");
  }
  std::vector<Real> layers{0};
  for (const Real size : relative_sizes(grading, n)) layers.push_back(layers.back() + size);
  const Real whole = layers.back();
  for (Real& layer : layers) layer /= whole;
  return layers;
}

int graded_count(const Grading& grading, Real length, Real size) {
  // 3.81/0.381 is 10 layers, whatever rounding says.
  const Real share = size / length * (1 + 1e-9);
  int low = fewest(grading), high = low;
  while (largest_share(grading, high) > share) high *= 2;
  while (low < high) {
    const int middle = low + (high - low) / 2;
    if (largest_share(grading, middle) > share) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}

template <int Dim>
void grade_ball(const Vec<Dim>& direction, Real ratio, Real radius, std::vector<Vec<Dim>>& nodes) {
  const Real root = std::sqrt(ratio), length = (root - 1) / (root + 1), square = length * length;
  for (auto& node : nodes) {
    const Vec<Dim> x = node / radius;
    const Real along = 2 * length * direction.dot(x), far = x.squaredNorm();
    node = radius * ((1 + along + far) * length * direction + (1 - square) * x) /
           (1 + along + square * far);
  }
}

template void grade_ball<2>(const Vec<2>&, Real, Real, std::vector<Vec<2>>&);
template void grade_ball<3>(const Vec3&, Real, Real, std::vector<Vec3>&);

}  // namespace brunt
