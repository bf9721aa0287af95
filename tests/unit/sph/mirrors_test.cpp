// Reflections across planes (sph/mirrors.hpp): x' = 2 p - x of places, R m R of matrices with
// R = diag(+-1), which is its own inverse.
#include "sph/mirrors.hpp"

#include <gtest/gtest.h>

namespace brunt {
namespace {

Mirrors<3> two_planes() {
  Mirrors<3> mirrors;
  mirrors.plane[0] = {1.5, {{2, 1.0}, {7, -1.0}}};
  mirrors.plane[2] = {-1.0, {{7, 1.0}}};
  return mirrors;
}

TEST(Mirrors, SumsKnowTheirPlanes) {
  EXPECT_FALSE(Mirrors<2>{}.any());
  const auto mirrors = two_planes();
  EXPECT_TRUE(mirrors.any());
  EXPECT_EQ(mirrors.across(1), 0u);
  EXPECT_EQ(mirrors.across(2), 1u);
  EXPECT_EQ(mirrors.across(7), 5u);
  EXPECT_EQ(mirrors.distance({2, 0, 0}, 0, 2), 0.5);
  EXPECT_EQ(mirrors.distance({2, 0, 0}, 0, 7), -0.5);
}

TEST(Mirrors, PlacesAndVectors) {
  const auto mirrors = two_planes();
  EXPECT_EQ(mirrors.reflected({2, 3, 4}, 1), Vec3(1, 3, 4));
  EXPECT_EQ(mirrors.reflected({2, 3, 4}, 5), Vec3(1, 3, -6));
  Real v[3] = {1, 2, 3};
  reflect_vector<3>(5, v);
  EXPECT_EQ(Vec3(v[0], v[1], v[2]), Vec3(-1, 2, -3));
}

TEST(Mirrors, MatricesAreThoseOfReflectedAxes) {
  for (MirrorAxes axes = 0; axes < 8; ++axes) {
    Mat3 R = Mat3::Identity();
    for (int c = 0; c < 3; ++c) {
      if (is_across(axes, c)) R(c, c) = -1;
    }
    Eigen::Matrix<Real, 3, 3, Eigen::RowMajor> m;
    m << 1, 2, 3, 4, 5, 6, 7, 8, 9;
    const Mat3 wanted = R * m * R;
    reflect_matrix<3>(axes, m.data());
    EXPECT_EQ(Mat3(m), wanted) << axes;
    const Mat3 even = wanted + wanted.transpose();  // of m + m^T
    Real s[kSymmetric<3>];
    for (int a = 0; a < 3; ++a) {
      for (int b = a; b < 3; ++b) {
        s[symmetric_place<3>(a, b)] = Real(3 * a + b + 1) + Real(3 * b + a + 1);
      }
    }
    reflect_symmetric<3>(axes, s);
    for (int a = 0; a < 3; ++a) {
      for (int b = a; b < 3; ++b) EXPECT_EQ(s[symmetric_place<3>(a, b)], even(a, b));
    }
  }
}

}  // namespace
}  // namespace brunt
