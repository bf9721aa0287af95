/// Each lane of a Pack does what a Real does, bit for bit, signs of zero and NaN included. A fused
/// product is that of the library, whose own one works without the instruction too: what every
/// instruction set agrees on.
#include "core/simd.hpp"

#include "core/lane_sums.hpp"
#include "core/simd_single.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <random>

namespace brunt {
namespace {

constexpr Real kNan = std::numeric_limits<Real>::quiet_NaN();
constexpr std::array kValues{0.0, -0.0, 1.0, -1.0, 2.25, 1e300, 5e-324, kInfinity, -kInfinity};

std::uint64_t bits(Real x) { return std::bit_cast<std::uint64_t>(x); }

TEST(Simd, ElementwiseFunctionsAgreeWithReal) {
  for (const Real a : kValues) {
    for (const Real b : kValues) {
      const Pack x{a, b, b, a}, y{b, a, b, a};
      for (int lane = 0; lane < kLanes; ++lane) {
        const Real s = x[lane], t = y[lane];
        EXPECT_EQ(bits(vmin(x, y)[lane]), bits(vmin(s, t)));
        EXPECT_EQ(bits(vmax(x, y)[lane]), bits(vmax(s, t)));
        EXPECT_EQ(bits(vabs(x)[lane]), bits(vabs(s)));
        EXPECT_EQ(bits(vsqrt(vabs(x))[lane]), bits(vsqrt(vabs(s))));
        EXPECT_EQ(bits(select(x < y, x, y)[lane]), bits(select(s < t, s, t)));
        EXPECT_EQ(lane_of(x < y, lane), s < t);
        EXPECT_EQ(bits(lane_of(x, lane)), bits(s));
      }
    }
  }
}

TEST(Simd, MinAndMaxTakeTheSecondOfANan) {
  EXPECT_EQ(vmin(kNan, 1.0), 1.0);
  EXPECT_EQ(vmax(kNan, 1.0), 1.0);
  EXPECT_TRUE(std::isnan(vmin(1.0, kNan)));
  EXPECT_EQ(vmin(broadcast<Pack>(kNan), broadcast<Pack>(1.0))[2], 1.0);
}

void expect_fused(Real a, Real b, Real c) {
  const auto expect = [](Real got, Real wanted) {
    EXPECT_TRUE(bits(got) == bits(wanted) || (std::isnan(got) && std::isnan(wanted)))
        << got << " " << wanted;
  };
  const Real sum = std::fma(a, b, c), rest = std::fma(-a, b, c);
  expect(vfma(a, b, c), sum);
  expect(vfnma(a, b, c), rest);
  const Pack x{a, b, 1, a}, y{b, a, c, b}, z{c, c, 0, c};
  const Pack p = vfma(x, y, z), q = vfnma(x, y, z);
  const Wide twice = vfma(joined_wide(x, y), joined_wide(y, x), joined_wide(z, z));
  const Wide less = vfnma(joined_wide(x, y), joined_wide(y, x), joined_wide(z, z));
  for (const int lane : {0, 1, 3}) {
    expect(p[lane], sum), expect(twice[lane], sum), expect(twice[lane + kLanes], sum);
    expect(less[lane], rest), expect(q[lane], rest);
  }
  expect(p[2], std::fma(1.0, c, 0.0));
  expect(line_at(a, c, b), sum);
}

TEST(Simd, FusedProductsAreRoundedOnce) {
  // 1 + 2^-30 squared less its own rounding: what rounding the product first would lose.
  const Real a = 1 + 0x1p-30, square = a * a;
  EXPECT_EQ(vfma(a, a, -square), 0x1p-60);
  EXPECT_EQ(vfnma(a, a, square), -0x1p-60);
  for (const Real x : kValues) {
    for (const Real y : kValues) {
      for (const Real z : kValues) expect_fused(x, y, z);
    }
  }
  std::mt19937_64 random(3);
  std::uniform_real_distribution<Real> part(-1, 1);
  for (int k = 0; k < 10000; ++k) {
    const Real x = part(random), y = part(random);
    expect_fused(x, y, -x * y * (1 + 1e-15 * part(random)));
    expect_fused(x, y, std::ldexp(part(random), static_cast<int>(60 * part(random))));
  }
}

TEST(Simd, AnySeesEachLane) {
  const Pack zero{};
  EXPECT_FALSE(any(zero < zero));
  EXPECT_FALSE(any(zero < broadcast<Pack>(kNan)));
  for (int lane = 0; lane < kLanes; ++lane) {
    Pack one{};
    one[lane] = 1;
    EXPECT_TRUE(any(zero < one));
    EXPECT_FALSE(any(one < zero));
  }
}

TEST(Simd, LoadAndStoreKeepOrder) {
  const Real in[5] = {1, 2, 3, 4, 5};
  Real out[4] = {};
  store(out, load(in + 1));  // not aligned
  for (int lane = 0; lane < kLanes; ++lane) EXPECT_EQ(out[lane], in[lane + 1]);
}

TEST(Simd, SumsOfFourPacksHaveTheBitsOfEach) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<Real> value(-1, 1);
  Pack pack[4];
  for (auto& one : pack) one = Pack{value(random), value(random), value(random), value(random)};
  const Pack sums = sums_of(pack[0], pack[1], pack[2], pack[3]);
  for (int k = 0; k < 4; ++k) {
    EXPECT_EQ(sums[k], (pack[k][0] + pack[k][1]) + (pack[k][2] + pack[k][3]));
    EXPECT_EQ(sums[k], sum_of(pack[k]));
  }
}

TEST(Simd, EightRowsOfFourAreTransposed) {
  float rows[8][4];
  for (int r = 0; r < 8; ++r) {
    for (int c = 0; c < 4; ++c) rows[r][c] = static_cast<float>(10 * r + c);
  }
  SinglePack columns[4];
  load_transposed({rows[0], rows[1], rows[2], rows[3], rows[4], rows[5], rows[6], rows[7]},
                  columns);
  for (int c = 0; c < 4; ++c) {
    for (int r = 0; r < 8; ++r) EXPECT_EQ(columns[c][r], rows[r][c]);
  }
  const SinglePack a = columns[3];
  EXPECT_EQ(mask_bits(a < 40.0), 0x0fU);
  EXPECT_EQ(vsqrt(a)[6], std::sqrt(63.0F));
  const SinglePack again = joined(low_half(a), high_half(a));
  for (int r = 0; r < 8; ++r) EXPECT_EQ(again[r], a[r]);
}

}  // namespace
}  // namespace brunt
