#include "core/geometry/placement.hpp"

#include <gtest/gtest.h>

namespace brunt {
namespace {

// Rotations and products of three numbers of order 1: some units in the last place.
constexpr Real kRounding = 1e-15;

TEST(Placement, AFrameIsOrthonormalAndRightHanded) {
  for (const std::vector<Real>& axis : std::vector<std::vector<Real>>{
           {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}, {1, 2, 3}, {-3, 1e-9, 0}}) {
    const Frame3 frame = frame_along({1, 2, 3}, axis);
    EXPECT_LT((frame.columns.transpose() * frame.columns - Mat3::Identity()).norm(), 8 * kRounding);
    EXPECT_NEAR(frame.columns.determinant(), 1, 8 * kRounding);
    EXPECT_LT((frame.columns.col(2) - to_vector<3>(axis).normalized()).norm(), 8 * kRounding);
  }
}

TEST(Placement, LocalUndoesPlace) {
  const Frame3 frame = frame_along({1, -2, 0.5}, {1, 1, 1});
  const Vec3 point(0.3, 0.4, -0.7);
  EXPECT_LT((frame.local(frame.place(point)) - point).norm(), 16 * kRounding);
  EXPECT_EQ(frame.place(Vec3::Zero()), Vec3(1, -2, 0.5));
}

TEST(Placement, WhatIsNotGivenIsZero) {
  EXPECT_EQ(to_vector<3>({1, 2}), Vec3(1, 2, 0));
  EXPECT_EQ(to_vector<2>({1, 2, 3}), Vec<2>(1, 2));
}

}  // namespace
}  // namespace brunt
