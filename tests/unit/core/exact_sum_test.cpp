/// The exact sum rounded once, to nearest with ties to even. Expected values are exact: small cases
/// by hand, random ones from 128-bit integers, which the conversion to double rounds in the same
/// way.
#include "core/exact_sum.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <random>

namespace brunt {
namespace {

__extension__ using Wide = __int128;

Real sum(const std::vector<Real>& values) {
  ExactSum total;
  for (const Real value : values) total.add(value);
  return total.value();
}

TEST(ExactSum, OfNothingIsZero) {
  EXPECT_EQ(sum({}), 0.0);
  EXPECT_EQ(sum({1.5, -1.5}), 0.0);
}

TEST(ExactSum, OfOneNumberIsThatNumber) {
  constexpr Real kLeast = std::numeric_limits<Real>::denorm_min();
  constexpr Real kMin = std::numeric_limits<Real>::min(), kMax = std::numeric_limits<Real>::max();
  for (const Real value : {1.0, -1.0, 0.1, kLeast, -kLeast, 7 * kLeast, kMin, kMin - kLeast,
                           kMin + kLeast, kMax, -kMax, 1e-310}) {
    EXPECT_EQ(sum({value}), value);
  }
}

TEST(ExactSum, TakesAnotherSumAway) {
  ExactSum total, part;
  for (const Real value : {1e300, 1.5, -3e-200}) total.add(value);
  for (const Real value : {1e300, -3e-200, 2.0}) part.add(value);
  total.subtract(part);
  EXPECT_EQ(total.value(), -0.5);
}

TEST(ExactSum, KeepsWhatCancellationLeaves) {
  EXPECT_EQ(sum({1e308, 1e-308, -1e308}), 1e-308);
  EXPECT_EQ(sum({1e308, 1e308, -1e308, -1e308, -5e-324}), -5e-324);
  EXPECT_EQ(sum({1e16, 1, -1e16}), 1.0);
  // beyond the largest double in between, but not at the end
  EXPECT_EQ(sum({1.7e308, 1.7e308, -1.7e308}), 1.7e308);
}

TEST(ExactSum, BeyondTheLargestDoubleIsInfinite) {
  EXPECT_EQ(sum({1.7e308, 1.7e308}), kInfinity);
  EXPECT_EQ(sum({-1.7e308, -1.7e308}), -kInfinity);
}

TEST(ExactSum, RoundsTiesToEvenAndKnowsWhatIsBelowThem) {
  const Real half = std::ldexp(1.0, -53), ulp = std::ldexp(1.0, -52);
  EXPECT_EQ(sum({1, half}), 1.0);                // tie, 1 is even
  EXPECT_EQ(sum({1 + ulp, half}), 1 + 2 * ulp);  // tie, 1 + ulp is odd
  EXPECT_EQ(sum({1, half, 5e-324}), 1 + ulp);    // a little above the tie
  EXPECT_EQ(sum({1 + ulp, half, -5e-324}), 1 + ulp);
  EXPECT_EQ(sum({-1, -half, -5e-324}), -1 - ulp);
  EXPECT_EQ(sum({2 - ulp, half}), 2.0);  // the tie carries into the next binade
}

TEST(ExactSum, NanAndInfinityPoison) {
  EXPECT_TRUE(std::isnan(sum({1, std::nan(""), 2})));
  EXPECT_TRUE(std::isnan(sum({1, kInfinity})));
  ExactSum total, poisoned;
  poisoned.add(-kInfinity);
  total.add(1);
  total.add(poisoned);
  EXPECT_TRUE(std::isnan(total.value()));
}

TEST(ExactSum, AgreesWithIntegersInAnyOrderAndGrouping) {
  std::mt19937_64 random(5);
  for (int round = 0; round < 300; ++round) {
    std::vector<Real> values;
    Wide wanted = 0;
    for (int i = 0; i < 50; ++i) {
      const auto mantissa = static_cast<std::int64_t>(random()) >> 11;  // 53 bits with sign
      const int shift = static_cast<int>(random() % 66);
      values.push_back(std::ldexp(static_cast<Real>(mantissa), shift));
      wanted += static_cast<Wide>(mantissa) * (static_cast<Wide>(1) << shift);
    }
    const Real exact = static_cast<Real>(wanted);
    EXPECT_EQ(sum(values), exact);
    std::shuffle(values.begin(), values.end(), random);
    ExactSum left, right;
    for (std::size_t i = 0; i < values.size(); ++i) (i % 3 ? left : right).add(values[i]);
    right.add(left);
    EXPECT_EQ(std::bit_cast<std::uint64_t>(right.value()), std::bit_cast<std::uint64_t>(exact));
  }
}

/// n times the largest mantissa at each place of its lowest bit within a word: words carry in time,
/// also where a sum that is nearly full takes in another.
TEST(ExactSum, CarriesBeforeAWordIsFull) {
  constexpr int kTimes = 2000;
  for (int place = 0; place < 64; ++place) {
    const auto mantissa = static_cast<Real>((1LL << 53) - 1);
    const Real value = std::ldexp(mantissa, place);
    const Real wanted = std::ldexp(static_cast<Real>(Wide{(1LL << 53) - 1} * kTimes), place);
    for (const Real sign : {1.0, -1.0}) {
      ExactSum total, of_sums, nearly_full;
      for (int i = 0; i < kTimes; ++i) total.add(sign * value);
      EXPECT_EQ(total.value(), sign * wanted);
      for (int i = 0; i < 1023; ++i) nearly_full.add(sign * value);
      for (int i = 0; i < 1023; ++i) of_sums.add(sign * value);
      of_sums.add(nearly_full);
      for (int i = 2046; i < kTimes + 1023; ++i) of_sums.add(sign * value);
      of_sums.subtract(nearly_full);
      EXPECT_EQ(of_sums.value(), sign * wanted);
    }
  }
}

/// Many values at once are the sum of each by itself, bit for bit: by sums that were checked above.
TEST(ExactSum, OfManyAtOnceIsThatOfEach) {
  std::mt19937_64 random(7);
  const auto uniform = [&](int low, int high) {
    return low + static_cast<int>(random() % static_cast<std::uint64_t>(high - low + 1));
  };
  const std::array<std::pair<int, int>, 6> ranges{
      {{0, 0}, {-40, 10}, {-300, 300}, {-1074, 971}, {900, 971}, {-1074, -1000}}};
  for (int round = 0; round < 600; ++round) {
    const auto [low, high] = ranges[static_cast<std::size_t>(round) % ranges.size()];
    std::vector<Real> values(static_cast<std::size_t>(uniform(0, 400)));
    for (Real& value : values) {
      const auto mantissa = static_cast<Real>(static_cast<std::int64_t>(random()) >> 11);
      value = uniform(0, 9) == 0 ? 0.0 : std::ldexp(mantissa, uniform(low, high));
    }
    if (round % 5 == 0 && !values.empty()) {  // alike: what the largest leave is not cut in one go
      std::fill(values.begin(), values.end(), std::ldexp(static_cast<Real>((1LL << 53) - 1), low));
    }
    ExactSum at_once;
    at_once.add(std::span<const Real>(values));
    EXPECT_EQ(std::bit_cast<std::uint64_t>(at_once.value()),
              std::bit_cast<std::uint64_t>(sum(values)))
        << "round " << round;
    for (Real& value : values) value = -value;
    at_once.add(std::span<const Real>(values));
    EXPECT_EQ(at_once.value(), 0.0) << "round " << round;
  }
  std::vector<Real> values(100, 1.0);
  values[63] = std::nan("");
  ExactSum poisoned;
  poisoned.add(std::span<const Real>(values));
  EXPECT_TRUE(std::isnan(poisoned.value()));
}

TEST(ExactSum, OfColumnsCountsEveryEntityOnce) {
  ExactColumns<2> columns;
  for (int i = 1; i <= 1000; ++i) columns.add({Real(i), -0.5 * i});
  EXPECT_EQ(columns.sum(0).value(), 500500.0);
  EXPECT_EQ(columns.sum(1).value(), -250250.0);
  columns.add({1, 1});
  EXPECT_EQ(columns.sum(0).value(), 500501.0);
}

TEST(ExactSum, DoublingFillsAndCarriesEveryDigit) {
  ExactSum total;
  total.add(1.0);
  for (int i = 0; i < 600; ++i) total.add(ExactSum(total));  // 2^600, by sums of sums
  EXPECT_EQ(total.value(), std::ldexp(1.0, 600));
}

}  // namespace
}  // namespace brunt
