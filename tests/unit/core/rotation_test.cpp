/// Hughes-Winget rotation. The Cayley form turns by 2 atan(|spin|/2) about the spin's axis.
/// Simple shear of a hypoelastic Jaumann body: d gamma in L_xy gives D_xy = d gamma / 2 and
/// w_yx = -d gamma / 2; ds/dgamma = w s - s w + 2 G D has sigma_xy = G sin gamma,
/// sigma_xx = G (1 - cos gamma). Rotating first and adding the strain after leaves an error of
/// first order, d gamma / 2 of the stress: 5e-4 at 1000 steps to gamma = 1; tolerance 1e-3.
#include "core/geometry/rotation.hpp"

#include <gtest/gtest.h>

#include <bit>

namespace brunt {
namespace {

Mat3 matrix(const Rotation<Real>& r) {
  Mat3 m;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) m(i, j) = r.row[i][j];
  }
  return m;
}
Mat3 matrix(const Real* s) {
  Mat3 m;
  m << s[xx], s[xy], s[zx], s[xy], s[yy], s[yz], s[zx], s[yz], s[zz];
  return m;
}

TEST(Rotation, IsTheCayleyTransformOfTheSpin) {
  const Vec3 spin(0.3, -0.7, 1.1);
  Mat3 w;
  w << 0, -spin.z(), spin.y(), spin.z(), 0, -spin.x(), -spin.y(), spin.x(), 0;
  const Mat3 wanted = (Mat3::Identity() - 0.5 * w).inverse() * (Mat3::Identity() + 0.5 * w);
  const Mat3 got = matrix(hughes_winget(spin.x(), spin.y(), spin.z()));
  EXPECT_LT((got - wanted).cwiseAbs().maxCoeff(), 1e-15);  // a few roundings of numbers below 1
  EXPECT_LT((got * got.transpose() - Mat3::Identity()).cwiseAbs().maxCoeff(), 1e-15);
  EXPECT_NEAR(std::acos((got.trace() - 1) / 2), 2 * std::atan(spin.norm() / 2), 1e-15 * 10);
}

TEST(Rotation, TurnsTensors) {
  const auto r = hughes_winget(0.2, 0.5, -0.9);
  Real s[6] = {1, -2, 3, 0.5, -0.25, 4};
  const Mat3 wanted = matrix(r) * matrix(s) * matrix(r).transpose();
  rotate_symmetric(r, s);
  EXPECT_LT((matrix(s) - wanted).cwiseAbs().maxCoeff(), 1e-14);  // sums of nine numbers below 4
}

TEST(Rotation, InThePlaneItIsTheSameAboutZ) {
  const auto plane = hughes_winget(0.8);
  const auto full = hughes_winget(0.0, 0.0, 0.8);
  Real s[6] = {1, -2, 3, 0.5, -0.25, 4}, t[6];
  std::copy_n(s, 6, t);
  rotate_symmetric(plane, s);
  rotate_symmetric(full, t);
  for (int c = 0; c < 6; ++c) EXPECT_NEAR(s[c], t[c], 1e-15 * 10);
}

TEST(Rotation, TenTurnsKeepTheNormOfStress) {
  Real s[6] = {1, -2, 1, 0.5, -0.25, 4};
  const Real norm = matrix(s).norm();
  const auto r = hughes_winget(0.01, 0.012, 2 * kPi / 360);
  for (int i = 0; i < 3600; ++i) rotate_symmetric(r, s);
  EXPECT_NEAR(matrix(s).norm() / norm, 1, 1e-12);  // 3600 steps of a few 1e-16
}

// ds/dt of Jaumann's rate in simple shear, G = 1: s_xy = sin gamma, s_xx = -s_yy = 1 - cos gamma.
// Rotated first and strained then, in the axes of the step's end, the error is of second order: a
// step leaves out [w, [w, D]]/6 of the strain, which is step^2/6 of it.
TEST(Rotation, SimpleShearIsThatOfJaumannToSecondOrder) {
  Real error[2];
  for (const int fine : {0, 1}) {
    const int steps = 100 << fine;
    const Real step = 1.0 / steps;
    const Real L[2][2] = {{0, step}, {0, 0}};
    Real s[6] = {};
    for (int i = 0; i < steps; ++i) {
      Real e[6] = {};
      step_strain(L, e);
      rotate_symmetric(hughes_winget(-0.5 * step), s);
      for (int c = 0; c < 6; ++c) s[c] += 2 * e[c];
    }
    error[fine] = std::max({std::abs(s[xy] - std::sin(1.0)), std::abs(s[xx] - (1 - std::cos(1.0))),
                            std::abs(s[yy] + (1 - std::cos(1.0)))});
    EXPECT_LT(error[fine], step * step / 6);
  }
  EXPECT_NEAR(error[0] / error[1], 4, 0.1);
}

// Half of the rotation of a step R takes what is seen from its middle to its end: e is
// R^1/2 D R^1/2^T up to terms of third order, here some 1e-12 where w D is 1e-8.
TEST(Rotation, StrainIsInTheAxesOfTheEnd) {
  const Real L[3][3] = {{1e-4, 3e-4, -2e-4}, {-1e-4, -2e-4, 1e-4}, {2e-4, -3e-4, 3e-4}};
  const Real D[6] = {L[0][0],
                     L[1][1],
                     L[2][2],
                     0.5 * (L[0][1] + L[1][0]),
                     0.5 * (L[1][2] + L[2][1]),
                     0.5 * (L[2][0] + L[0][2])};
  Real half[6], e[6];
  std::copy_n(D, 6, half);
  rotate_symmetric(hughes_winget(0.25 * (L[2][1] - L[1][2]), 0.25 * (L[0][2] - L[2][0]),
                                 0.25 * (L[1][0] - L[0][1])),
                   half);
  step_strain(L, e);
  Real turned = 0;
  for (int c = 0; c < 6; ++c) {
    EXPECT_NEAR(e[c], half[c], 2e-11);
    turned = std::max(turned, std::abs(e[c] - D[c]));
  }
  EXPECT_GT(turned, 1e-8);
  EXPECT_NEAR(e[xx] + e[yy] + e[zz], D[xx] + D[yy] + D[zz], 1e-19);

  const Real plane[2][2] = {{L[0][0], L[0][1]}, {L[1][0], L[1][1]}};
  const Real flat[3][3] = {{L[0][0], L[0][1], 0}, {L[1][0], L[1][1], 0}, {0, 0, 0}};
  Real in_plane[6] = {}, in_space[6];
  step_strain(plane, in_plane);
  step_strain(flat, in_space);
  for (int c = 0; c < 6; ++c) EXPECT_EQ(in_plane[c], in_space[c]);
}

TEST(Rotation, LanesHaveTheBitsOfAReal) {
  const Pack x{0.1, -2, 0, 30}, y{1e-9, 0.3, 0, -1}, z{-0.4, 0.6, 0, 2};
  Pack s[6];
  for (int c = 0; c < 6; ++c) s[c] = Pack{1.0 + c, -0.3 * c, 2e8, 1e-3 * c};
  Pack turned[6];
  std::copy_n(s, 6, turned);
  rotate_symmetric(hughes_winget(x, y, z), turned);
  for (int lane = 0; lane < kLanes; ++lane) {
    Real one[6];
    for (int c = 0; c < 6; ++c) one[c] = s[c][lane];
    rotate_symmetric(hughes_winget(x[lane], y[lane], z[lane]), one);
    for (int c = 0; c < 6; ++c) {
      EXPECT_EQ(std::bit_cast<std::uint64_t>(one[c]),
                std::bit_cast<std::uint64_t>(turned[c][lane]));
    }
  }
}

}  // namespace
}  // namespace brunt
