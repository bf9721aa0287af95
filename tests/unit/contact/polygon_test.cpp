// Two unit squares about the same centre, one turned by 45 degrees, overlap in a regular octagon of
// apothem 1/2: area 8 (1/2)^2 tan(pi/8) = 2 (sqrt 2 - 1) = 0.8284271247461903.
#include "contact/geometry/polygon.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace brunt {
namespace {

Polygon square(Real angle, Real side = 1, Vec<2> center = Vec<2>::Zero()) {
  Polygon polygon;
  for (const auto& [x, y] : {std::pair(-.5, -.5), {.5, -.5}, {.5, .5}, {-.5, .5}}) {
    const Vec<2> turned(std::cos(angle) * x - std::sin(angle) * y,
                        std::sin(angle) * x + std::cos(angle) * y);
    polygon.push(center + side * turned);
  }
  return polygon;
}

TEST(Polygon, SquaresTurnedByAnEighth) {
  // A few roundings of numbers of order 1.
  EXPECT_NEAR(area(intersect(square(0), square(kPi / 4))), 0.8284271247461903, 1e-15);
}

TEST(Polygon, NearlyCoincidentSquares) {
  // Turned by a small angle t, each corner loses a triangle of about t/8: never more than all, and
  // never clockwise.
  for (int k = 1; k <= 15; ++k) {
    const Real angle = std::pow(10.0, -k);
    const Real overlap = area(intersect(square(0), square(angle)));
    EXPECT_GE(overlap, 1 - angle) << k;
    EXPECT_LE(overlap, 1 + 1e-15) << k;
  }
  EXPECT_EQ(area(intersect(square(0), square(0))), 1.0);
}

// Sides that cut nothing off are passed by: what is left is, bit for bit, what cutting by one side
// after the other leaves.
TEST(Polygon, OverlapsAreCutSideBySide) {
  int whole = 0, cut = 0;
  for (int k = 0; k < 500; ++k) {
    const Vec<2> center(0.45 * std::sin(3.0 * k), 0.45 * std::cos(5.0 * k));
    const Polygon a = square(0.1 * k, 0.2 + 0.002 * k, center), b = square(0.3 * k, 1.3);
    Polygon left = a;
    for (int i = 0; i < b.size && left.size > 2; ++i) {
      const Vec<2> edge = b[i + 1 == b.size ? 0 : i + 1] - b[i];
      LinearField inside;
      inside.slope = Vec<2>(-edge[1], edge[0]);
      inside.value = -inside.slope.dot(b[i]);
      Polygon kept;
      clip(left, inside, kept);
      left = kept;
    }
    const Polygon found = intersect(a, b);
    ASSERT_EQ(found.size, left.size < 3 ? 0 : left.size) << k;
    for (int i = 0; i < found.size; ++i) EXPECT_EQ(found[i], left[i]) << k;
    const bool same = found.size == 4 && found[0] == a[0] && found[2] == a[2];
    (same ? whole : cut) += found.size > 0 ? 1 : 0;
  }
  EXPECT_GT(whole, 50);
  EXPECT_GT(cut, 50);
}

TEST(Polygon, SquaresThatShareAnEdgeDoNotOverlap) {
  EXPECT_EQ(area(intersect(square(0), square(0, 1, Vec<2>(1, 0)))), 0.0);
}

TEST(Polygon, TilesAddUpToTheFace) {
  // 7 x 7 tiles that cover the turned square: the sum of overlaps is its area, to 49 roundings.
  Real sum = 0;
  for (int i = 0; i < 7; ++i) {
    for (int j = 0; j < 7; ++j) {
      sum += area(intersect(square(0, 0.25, Vec<2>(0.25 * (i - 3), 0.25 * (j - 3))), square(0.3)));
    }
  }
  EXPECT_NEAR(sum, 1.0, 1e-13);
}

TEST(Polygon, IntegralsOfALinearField) {
  // g = 1 + x over [-1/2, 1/2]^2: total 1, moments 1/12 and 0.
  LinearField g;
  g.value = 1;
  g.slope = Vec<2>(1, 0);
  const FieldIntegrals sum = integrate(square(0), g);
  EXPECT_NEAR(sum.area, 1, 1e-15);
  EXPECT_NEAR(sum.total, 1, 1e-15);
  EXPECT_NEAR(sum.moment[0], 1.0 / 12, 1e-15);
  EXPECT_NEAR(sum.moment[1], 0, 1e-15);
}

Polygon clipped(const Polygon& polygon, const LinearField& keep) {
  Polygon kept;
  clip(polygon, keep, kept);
  return kept;
}

TEST(Polygon, ClipKeepsThePartWhereTheFieldIsNotNegative) {
  LinearField keep;
  keep.value = -0.25;
  keep.slope = Vec<2>(1, 0);
  EXPECT_NEAR(area(clipped(square(0), keep)), 0.25, 1e-15);
  keep.value = -0.75;
  EXPECT_EQ(clipped(square(0), keep).size, 0);
}

}  // namespace
}  // namespace brunt
