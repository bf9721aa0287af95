// Orders, limits and bounds on made-up series f = f_0 + C h^p, whose answers are known.
#include "app/trade/convergence.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace brunt {
namespace {

std::vector<SizedValue> series_of(const std::vector<Real>& sizes, Real limit, Real slope,
                                  Real order) {
  std::vector<SizedValue> values;
  for (const Real size : sizes) values.push_back({size, limit + slope * std::pow(size, order)});
  return values;
}

TEST(Convergence, FindsTheOrderOfUnevenRatios) {
  for (const Real order : {0.7, 1.0, 1.6, 2.0, 3.5}) {
    const auto v = series_of({0.5, 0.8, 2.0}, 10, -3, order);
    const auto found = observed_order(v[0], v[1], v[2]);
    ASSERT_TRUE(found);
    EXPECT_NEAR(*found, order, 1e-9);  // bisection to the last bits of an order of about 1
  }
}

TEST(Convergence, HasNoOrderWhereDifferencesGrowOrChangeSign) {
  EXPECT_FALSE(observed_order({1, 1.0}, {2, 2.0}, {4, 2.5}));  // grows towards the finest
  EXPECT_FALSE(observed_order({1, 1.0}, {2, 1.2}, {4, 0.9}));  // turns
  EXPECT_FALSE(observed_order({1, 1.0}, {2, 1.0}, {4, 0.9}));  // stands still
}

TEST(Convergence, ExtrapolatesAndBoundsWhatConverges) {
  const auto v = series_of({1, 2, 4}, 7, 0.3, 1.5);
  const auto found = fit_convergence({v[2], v[0], v[1]});  // in any order
  EXPECT_TRUE(found.asymptotic);
  ASSERT_TRUE(found.limit && found.order);
  EXPECT_NEAR(*found.order, 1.5, 1e-9);
  EXPECT_NEAR(*found.limit, 7, 1e-9);
  // A grid convergence index of factor 1.25 at first order: 1.25 (2^1.5 - 1) of the true error.
  EXPECT_NEAR(found.bound, 1.25 * 0.3 * (std::pow(2, 1.5) - 1), 1e-9);
}

TEST(Convergence, ManySizesAreFittedTogether) {
  const auto found = fit_convergence(series_of({1, 1.4, 2, 3, 4}, -2, 0.1, 2));
  EXPECT_TRUE(found.asymptotic);
  ASSERT_TRUE(found.limit && found.order);
  EXPECT_NEAR(*found.order, 2, 0.01);  // orders are tried in steps of 0.01
  EXPECT_NEAR(*found.limit, -2, 1e-3);
  EXPECT_GE(found.bound, 0.1);  // the true error
  EXPECT_LE(found.bound, 0.2);
}

TEST(Convergence, NoiseOverFourSizesIsNotAsymptotic) {
  auto values = series_of({1, 2, 4, 8}, 5, 0.01, 1);
  values[3].value = 4.9;  // the coarsest goes the other way
  const auto found = fit_convergence(values);
  EXPECT_FALSE(found.asymptotic);
  EXPECT_FALSE(found.limit);
  EXPECT_NE(found.words.find("not asymptotic"), std::string::npos);
  EXPECT_GE(found.bound, 0.01);
}

TEST(Convergence, OscillationIsBoundedByItsSpread) {
  const auto found = fit_convergence({{1, 10}, {2, 11}, {4, 10.5}});
  EXPECT_FALSE(found.asymptotic);
  EXPECT_EQ(found.words, "not asymptotic: it oscillates");
  EXPECT_DOUBLE_EQ(found.bound, 3);  // three times the spread of 1
}

TEST(Convergence, AChanceAgreementOfTheFinestTwoIsNoConvergence) {
  // 10.000, 10.001, 10.4: an observed order of 8.6. The coarse difference of 0.399 leaves at
  // second order 0.399/4 between the finer two, and a third of that, times 3.
  const auto found = fit_convergence({{1, 10}, {2, 10.001}, {4, 10.4}});
  EXPECT_FALSE(found.asymptotic);
  EXPECT_GT(found.bound, 0.05);
}

TEST(Convergence, TwoSizesAssumeSecondOrder) {
  const auto found = fit_convergence({{1, 10}, {2, 10.4}});
  EXPECT_FALSE(found.asymptotic);
  EXPECT_NEAR(found.bound, 3 * 0.4 / 3, 1e-12);  // F/(r^2 - 1) = 3/3
}

TEST(Convergence, WhatDoesNotDependOnTheSizeIsDone) {
  const auto found = fit_convergence({{1, 3}, {2, 3}, {4, 3}});
  EXPECT_TRUE(found.asymptotic);
  EXPECT_EQ(found.bound, 0);
  EXPECT_DOUBLE_EQ(*found.limit, 3);
}

TEST(Convergence, NumbersOfCellsCorrectNominalSizes) {
  // 10 mm in sizes of 1, 1.4 and 2 mm: 10, 7 and 5 cells a side of a cube.
  const auto sizes = effective_sizes({1, 1.4, 2}, {1000, 343, 125});
  EXPECT_NEAR(sizes[1], 10.0 / 7, 1e-12);
  EXPECT_NEAR(sizes[2], 2, 1e-12);
  // A bar of one cell across: one direction.
  EXPECT_NEAR(effective_sizes({1, 2}, {100, 48})[1], 100.0 / 48, 1e-12);
  // What does not follow the sizes is left alone.
  EXPECT_EQ(effective_sizes({1, 2}, {100, 100}), (std::vector<Real>{1, 2}));
}

}  // namespace
}  // namespace brunt
