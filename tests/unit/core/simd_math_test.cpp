/// vexp, vlog, vpow against long double functions of the maths library (64 bits of mantissa, so
/// their own error of 1e-19 does not count), and the lanes of a Pack against a Real, bit for bit.
/// Expected errors: the last rounding (1.1e-16) and a half-ulp of the reduced argument; 2.3e-16
/// allows one unit in the last place.
#include "core/simd_math.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <random>

namespace brunt {
namespace {

constexpr Real kUlp = 2.3e-16;

std::uint64_t bits(Real x) { return std::bit_cast<std::uint64_t>(x); }

Real relative_error(Real got, long double wanted) {
  return static_cast<Real>(std::fabs((static_cast<long double>(got) - wanted) / wanted));
}

TEST(SimdMath, ExpIsWithinOneUlpOverItsRange) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<Real> exponent(-708, 709.7);
  Real worst = 0;
  for (int i = 0; i < 200000; ++i) {
    const Real x = i % 2 ? exponent(random) : exponent(random) * 1e-3;
    worst = std::max(worst, relative_error(vexp(x), std::exp(static_cast<long double>(x))));
  }
  EXPECT_LT(worst, kUlp);
}

TEST(SimdMath, LogIsWithinOneUlpAlsoNearOne) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<Real> exponent(-740, 709), near(0.5, 2);
  Real worst = 0;
  for (int i = 0; i < 200000; ++i) {
    const Real x = i % 2 ? std::exp(exponent(random)) : near(random);
    worst = std::max(worst, relative_error(vlog(x), std::log(static_cast<long double>(x))));
  }
  EXPECT_LT(worst, kUlp);
}

TEST(SimdMath, PowKeepsItsPrintedBound) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<Real> exponent(-20, 20), power(-1, 1);
  for (int i = 0; i < 200000; ++i) {
    const Real x = std::exp(exponent(random)), y = power(random);
    const long double wanted = std::pow(static_cast<long double>(x), static_cast<long double>(y));
    const Real t = std::fabs(y * std::log(x));
    ASSERT_LT(relative_error(vpow(x, y), wanted), (1 + t) * 5e-16) << x << ' ' << y;
  }
  // |y ln x| < 20 is all that flow stresses ask for
  EXPECT_LT((1 + 19.0) * 5e-16, 1.01e-14);
}

TEST(SimdMath, EdgesAreThoseOfTheMathsLibrary) {
  EXPECT_EQ(vexp(0.0), 1.0);
  EXPECT_EQ(vexp(kInfinity), kInfinity);
  EXPECT_EQ(vexp(-kInfinity), 0.0);
  EXPECT_EQ(vexp(1000.0), kInfinity);
  EXPECT_EQ(vexp(-1000.0), 0.0);
  EXPECT_EQ(vexp(-745.1), 4.9406564584124654e-324);
  EXPECT_TRUE(std::isnan(vexp(std::nan(""))));
  EXPECT_EQ(vlog(1.0), 0.0);
  EXPECT_EQ(vlog(0.0), -kInfinity);
  EXPECT_EQ(vlog(kInfinity), kInfinity);
  EXPECT_TRUE(std::isnan(vlog(-1.0)));
  EXPECT_TRUE(std::isnan(vlog(std::nan(""))));
  EXPECT_DOUBLE_EQ(vlog(4.9406564584124654e-324), -744.44007192138122);  // -1074 ln 2
  EXPECT_EQ(vpow(0.0, 0.31), 0.0);
  EXPECT_EQ(vpow(0.0, 0.0), 1.0);
  EXPECT_EQ(vpow(0.0, -1.0), kInfinity);
  EXPECT_TRUE(std::isnan(vpow(-1.0, 0.5)));
}

TEST(SimdMath, LanesHaveTheBitsOfAReal) {
  std::mt19937_64 random(4);
  std::uniform_int_distribution<std::uint64_t> any_bits;
  for (int i = 0; i < 50000; ++i) {
    Pack x{}, y{};
    for (int lane = 0; lane < kLanes; ++lane) {  // all doubles: subnormal, infinite, negative
      x[lane] = std::bit_cast<Real>(any_bits(random));
      y[lane] = std::ldexp(static_cast<Real>(any_bits(random) >> 12), -50 + lane);
    }
    const Pack e = vexp(x), g = vexp(y - 500.0), l = vlog(x), p = vpow(y, x);
    for (int lane = 0; lane < kLanes; ++lane) {
      if (std::isnan(x[lane])) continue;  // a NaN's payload is nobody's answer
      ASSERT_EQ(bits(e[lane]), bits(vexp(x[lane])));
      ASSERT_EQ(bits(g[lane]), bits(vexp(y[lane] - 500.0)));
      if (x[lane] >= 0) {
        ASSERT_EQ(bits(l[lane]), bits(vlog(x[lane])));
      }
      const Real power = vpow(y[lane], x[lane]);
      if (!std::isnan(power)) {
        ASSERT_EQ(bits(p[lane]), bits(power));
      }
    }
  }
}

}  // namespace
}  // namespace brunt
