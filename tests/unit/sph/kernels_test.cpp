// Kernels against their definition: unit integral over the support, derivative, lattice sums.
//
// Integral: 2 pi alpha int f q dq (2D) and 4 pi alpha int f q^2 dq (3D) over [0, 2] are 1. On each
// of [0, 1] and [1, 2] the integrand is a polynomial of degree at most 10, so that Gauss-Legendre
// of 8 points (exact to degree 15) gives the integral to round-off; 1e-10 is asked for.
// Derivative: central differences of step 1e-5 err by f''' 1e-10/6 and by round-off of 1e-11;
// |f'''| is below 50, so that 1e-7 leaves room. Lattice sums at h/dp = 1.2, sum V W and sum V F r^2
// with F = -W'/r: the table under docs/theory/sph.md (S1), printed with three decimals: one unit of
// the last.
#include "sph/kernels.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace brunt {
namespace {

template <class Kernel>
class Kernels : public ::testing::Test {};
using AllKernels = ::testing::Types<CubicKernel, QuadraticKernel, HyperbolicKernel,
                                    WendlandC2Kernel, WendlandC4Kernel>;
TYPED_TEST_SUITE(Kernels, AllKernels);

template <class Kernel, class V>
V slope_over_q(V q) {
  return Kernel::slope_over_q(q, 1.0 / vmax(q, broadcast<V>(kSmallestRatio)));
}

Real gauss(Real a, Real b, auto f) {
  constexpr Real node[4] = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                            0.9602898564975363};
  constexpr Real weight[4] = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                              0.1012285362903763};
  Real sum = 0;
  for (int k = 0; k < 4; ++k) {
    const Real half = 0.5 * (b - a), middle = 0.5 * (a + b);
    sum += half * weight[k] * (f(middle - half * node[k]) + f(middle + half * node[k]));
  }
  return sum;
}

TYPED_TEST(Kernels, IntegralIsOne) {
  const auto ring = [](Real q) { return TypeParam::value(q) * q; };
  const auto shell = [](Real q) { return TypeParam::value(q) * q * q; };
  EXPECT_NEAR(2 * kPi * TypeParam::template kAlpha<2> * (gauss(0, 1, ring) + gauss(1, 2, ring)), 1,
              1e-10);
  EXPECT_NEAR(4 * kPi * TypeParam::template kAlpha<3> * (gauss(0, 1, shell) + gauss(1, 2, shell)),
              1, 1e-10);
}

TYPED_TEST(Kernels, SlopeIsTheDerivative) {
  for (Real q = 0.01; q < 2; q += 0.0101) {
    const Real difference = (TypeParam::value(q + 1e-5) - TypeParam::value(q - 1e-5)) / 2e-5;
    if (std::fabs(q - 1) > 1e-4) {
      EXPECT_NEAR(q * slope_over_q<TypeParam>(q), difference, 1e-7);
    }
  }
}

TYPED_TEST(Kernels, LanesHaveTheBitsOfOne) {
  const Pack q = {0.0, 0.37, 1.0, 1.91};
  const Pack value = TypeParam::value(q), slope = slope_over_q<TypeParam>(q);
  for (int k = 0; k < kLanes; ++k) {
    EXPECT_EQ(value[k], TypeParam::value(Real{q[k]}));
    EXPECT_EQ(slope[k], slope_over_q<TypeParam>(Real{q[k]}));
  }
}

TYPED_TEST(Kernels, ForceOfACoincidentPairIsFinite) {
  for (const Real q : {0.0, 1e-300, 1e-9}) {
    EXPECT_TRUE(std::isfinite(slope_over_q<TypeParam>(q)));
    EXPECT_LT(std::fabs(q * slope_over_q<TypeParam>(q)), 10);
  }
}

struct Sums {
  Real value = 0, slope = 0;
};
template <class Kernel, int Dim>
Sums lattice_sums() {
  constexpr Real h = 1.2;
  Sums sums;
  const int depth = Dim == 3 ? 3 : 0;
  for (int i = -3; i <= 3; ++i) {
    for (int j = -3; j <= 3; ++j) {
      for (int k = -depth; k <= depth; ++k) {
        const Real r2 = i * i + j * j + k * k, q = std::sqrt(r2) / h;
        if (q >= 2) continue;
        const Real scale = Kernel::template kAlpha<Dim> / std::pow(h, Dim);
        sums.value += scale * Kernel::value(q);
        if (r2 > 0) sums.slope -= scale / (h * h) * slope_over_q<Kernel>(q) * r2 / Dim;
      }
    }
  }
  return sums;
}

template <class Kernel, int Dim>
void expect_sums(Real value, Real slope) {
  const Sums sums = lattice_sums<Kernel, Dim>();
  EXPECT_NEAR(sums.value, value, 1e-3);
  EXPECT_NEAR(sums.slope, slope, 1e-3);
}

TEST(Lattice, SumsOfTheTable) {
  expect_sums<HyperbolicKernel, 2>(1.083, 0.945);
  expect_sums<HyperbolicKernel, 3>(1.060, 0.962);
  expect_sums<QuadraticKernel, 3>(1.030, 0.959);
  expect_sums<CubicKernel, 3>(1.001, 0.982);
  expect_sums<WendlandC2Kernel, 3>(1.018, 0.985);
  expect_sums<WendlandC4Kernel, 3>(1.013, 0.984);
}

}  // namespace
}  // namespace brunt
