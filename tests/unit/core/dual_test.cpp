#include "core/materials/dual.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace brunt {
namespace {

using Number = Dual<Real>;

// x, y and z are the three variables.
constexpr Real kX = 0.7, kY = 1.3, kZ = 2.1;
const Number x{kX, {1, 0, 0}}, y{kY, {0, 1, 0}}, z{kZ, {0, 0, 1}};

/// A value and slopes, to rounding: vexp and its like are good to a few units in the last place.
void expect_number(const Number& found, Real value, const std::array<Real, 3>& slope) {
  EXPECT_NEAR(found.value, value, 1e-14 * std::fabs(value));
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(found.slope[i], slope[i], 1e-13) << i;
}

TEST(Dual, SumsAndDifferencesHaveTheSlopesOfTheirParts) {
  expect_number(x + 2.0 * y - z, kX + 2 * kY - kZ, {1, 2, -1});
  expect_number(3.0 - x, 3 - kX, {-1, 0, 0});
}

TEST(Dual, ProductsFollowTheProductRule) {
  expect_number(x * y * z, kX * kY * kZ, {kY * kZ, kX * kZ, kX * kY});
}

TEST(Dual, QuotientsFollowTheQuotientRule) {
  expect_number(x / (y + z), kX / (kY + kZ),
                {1 / (kY + kZ), -kX / ((kY + kZ) * (kY + kZ)), -kX / ((kY + kZ) * (kY + kZ))});
}

TEST(Dual, FunctionsFollowTheChainRule) {
  expect_number(vexp(x * y), std::exp(kX * kY),
                {kY * std::exp(kX * kY), kX * std::exp(kX * kY), 0});
  expect_number(vlog(z), std::log(kZ), {0, 0, 1 / kZ});
  expect_number(vsqrt(y), std::sqrt(kY), {0, 0.5 / std::sqrt(kY), 0});
  expect_number(vpow(x, 0.31), std::pow(kX, 0.31), {0.31 * std::pow(kX, 0.31 - 1), 0, 0});
}

// The slope of a power at 0 is infinite; its product with 0 would be no number.
TEST(Dual, PowersAtZeroHaveFiniteSlopes) {
  const Number zero{0, {0, 1, 0}};
  for (const Number& found : {vpow(zero, 0.5), vsqrt(zero)}) {
    EXPECT_EQ(found.value, 0);
    for (const Real slope : found.slope) EXPECT_TRUE(std::isfinite(slope)) << slope;
  }
}

TEST(Dual, NothingChangesBeyondABound) {
  expect_number(held_above(x, 1.0), 1, {0, 0, 0});
  expect_number(held_above(y, 1.0), kY, {0, 1, 0});
  expect_number(held_below(x, 1.0), kX, {1, 0, 0});
  expect_number(held_below(y, 1.0), 1, {0, 0, 0});
}

}  // namespace
}  // namespace brunt
