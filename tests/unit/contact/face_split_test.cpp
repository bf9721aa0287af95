// A quad passes to two triangles by a smooth step of its warp over the root of its area, and by one
// of the sharpest turn of its corners; its gradient is found by central differences, of second
// order in their distance, whose rounding is 1e-16/d.
#include "contact/geometry/face_split.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace brunt {
namespace {

// A face that is 2 m wide now and was `start` at time 0 begins to be split where its warp is beyond
// 3 % of the smaller width, and is so wholly at 9 %.
Real split_at(Real warp, Real start) {
  FacePlane<3> plane;
  plane.corner = {Vec3(0, 0, warp), {2, 0, -warp}, {2, 2, warp}, {0, 2, -warp}};
  plane.area_start = start * start;
  refresh(plane);
  return plane.split;
}

TEST(FaceSplit, IsMeasuredByTheSmallerOfTheWidthsNowAndAtTimeZero) {
  EXPECT_EQ(split_at(0.0149, 0.5), 0);
  EXPECT_NEAR(split_at(0.03, 0.5), 0.5, 1e-12);
  EXPECT_EQ(split_at(0.0451, 0.5), 1);
  EXPECT_EQ(split_at(0.059, 4), 0);
  EXPECT_NEAR(split_at(0.12, 4), 0.5, 1e-12);
  EXPECT_EQ(split_at(0.181, 4), 1);
}

// A kite whose corner at (d, d) comes in towards the diagonal from (1, 0) to (0, 1): there its
// edges are (d - 1, d) and (-d, 1 - d), their parallelogram has 2d - 1, the face d.
TEST(FaceSplit, BeginsBeforeACornerIsStraight) {
  const auto at = [](Real d) {
    FacePlane<3> plane;
    plane.corner = {Vec3(0, 0, 0), {1, 0, 0}, {d, d, 0}, {0, 1, 0}};
    refresh(plane);
    return plane.split;
  };
  EXPECT_EQ(at(0.527), 0);                      // 0.054/0.527 > 0.1
  EXPECT_NEAR(at(1 / (2 - 0.06)), 0.5, 1e-12);  // (2d - 1)/d = 0.06
  EXPECT_EQ(at(0.505), 1);                      // 0.01/0.505 < 0.02
}

TEST(FaceSplit, GradientIsThatOfTheSplit) {
  std::mt19937_64 random(20261125);
  std::uniform_real_distribution<Real> near(-0.25, 0.25);
  const std::array<Vec3, 4> square = {Vec3(-.5, -.5, 0), {.5, -.5, 0}, {.5, .5, 0}, {-.5, .5, 0}};
  int found = 0, by_turn = 0;
  for (int k = 0; k < 4000 && found < 400; ++k) {
    FacePlane<3> face;
    for (std::size_t c = 0; c < 4; ++c) {
      face.corner[c] = square[c] + Vec3(near(random), near(random), 0.4 * near(random));
    }
    if (k % 3 == 0) face.area_start = 0.7;
    if (k % 2 == 0) face.corner[2] = 0.5 * (face.corner[1] + face.corner[3]) + Vec3(0.03, 0.03, 0);
    refresh(face);
    if (!(face.split > 0.01 && face.split < 0.99)) continue;
    ++found;
    by_turn += k % 2 == 0 ? 1 : 0;
    const auto gradient = split_gradient(face);
    Vec3 sum = Vec3::Zero(), moment = Vec3::Zero();
    for (std::size_t c = 0; c < 4; ++c) {
      sum += gradient[c];
      moment += face.corner[c].cross(gradient[c]);
      for (int i = 0; i < 3; ++i) {
        const Real d = 1e-6;
        auto moved = face;
        moved.corner[c][i] += d;
        refresh(moved);
        const Real more = moved.split;
        moved.corner[c][i] -= 2 * d;
        refresh(moved);
        EXPECT_NEAR((more - moved.split) / (2 * d), gradient[c][i], 2e-4) << k;
      }
    }
    // Moving or turning a face as a whole changes nothing.
    EXPECT_LT(sum.norm(), 1e-12) << k;
    EXPECT_LT(moment.norm(), 1e-12) << k;
  }
  EXPECT_EQ(found, 400);
  EXPECT_GT(by_turn, 50);
}

}  // namespace
}  // namespace brunt
