// The tensile part of a tensor. Reference: S = Q diag(a, b, c) Q^T with a rotation Q and chosen
// principal values has the tensile part Q diag(a+, b+, c+) Q^T. Jacobi diagonalises to round-off, a
// few ulp of the largest principal value: 1e-14 of it.
#include "sph/principal_tension.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

namespace brunt {
namespace {

TEST(PrincipalTension, KeepsThePositivePrincipalValues) {
  const Mat3 turn = (Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()) *
                     Eigen::AngleAxisd(-1.9, Vec3(-2, 1, 0.5).normalized()))
                        .toRotationMatrix();
  const Vec3 cases[] = {{3, -1, -2}, {3, 2, 1},  {1, 1, 1},      {-1, -1, -1},  {2, 2, -1},
                        {0, 0, 0},   {5, 0, -5}, {1e8, 1, -1e8}, {1e-9, -1, -1}};
  for (const Vec3& values : cases) {
    const Mat3 tensor = turn * values.asDiagonal() * turn.transpose();
    const Mat3 expected = turn * values.cwiseMax(0.0).asDiagonal() * turn.transpose();
    Real a[3][3], positive[3][3];
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) a[i][j] = tensor(std::min(i, j), std::max(i, j));
    }
    principal_tension<3>(a, positive);
    const Real tolerance = 1e-14 * std::max(values.cwiseAbs().maxCoeff(), 1e-300);
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) EXPECT_NEAR(positive[i][j], expected(i, j), tolerance);
    }
  }
}

TEST(PrincipalTension, PlaneByItsAngle) {
  // Gray, Monaghan & Swift 2001: tan 2 theta = 2 s_xy/(s_xx - s_yy)
  const Real s[2][2] = {{2.0, 1.5}, {1.5, -1.0}};
  Real positive[2][2];
  principal_tension<2>(s, positive);
  const Real theta = 0.5 * std::atan2(2 * 1.5, 2.0 - -1.0);
  const Real value = 0.5 + std::hypot(1.5, 1.5);
  const Real c = std::cos(theta), n = std::sin(theta);
  EXPECT_NEAR(positive[0][0], value * c * c, 1e-14);
  EXPECT_NEAR(positive[0][1], value * c * n, 1e-14);
  EXPECT_NEAR(positive[1][1], value * n * n, 1e-14);
}

TEST(PrincipalTension, CompressionIsExactlyZeroAndLanesAgree) {
  const Real values[4] = {-1.0, 2.0, 0.0, -3.0};
  Pack a[3][3], positive[3][3];
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      for (int k = 0; k < kLanes; ++k) a[i][j][k] = i == j ? values[k] - 0.1 * i : 0.01;
    }
  }
  principal_tension<3>(a, positive);
  for (int k = 0; k < kLanes; ++k) {
    Real one[3][3], alone[3][3];
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) one[i][j] = a[i][j][k];
    }
    principal_tension<3>(one, alone);
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) EXPECT_EQ(positive[i][j][k], alone[i][j]);
    }
  }
  EXPECT_EQ(positive[0][0][0], 0.0);
  EXPECT_EQ(positive[1][2][3], 0.0);
}

}  // namespace
}  // namespace brunt
