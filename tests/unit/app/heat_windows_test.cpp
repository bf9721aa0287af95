// Windows in which an evaluation of conduction acts.
#include "app/scene/heat_windows.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace brunt::test {
namespace {

constexpr std::int64_t kLate = 100000;

TEST(HeatWindows, AGivenNumberIsThatOfEach) {
  HeatWindows windows(3);
  EXPECT_TRUE(windows.may_last());
  int begun = 0;
  for (std::int64_t step = 0; step < 9; ++step) {
    EXPECT_EQ(windows.is_due(step), step % 3 == 0) << step;
    if (windows.is_due(step)) windows.begin(step, 1, 2), ++begun;
    EXPECT_EQ(windows.steps(), 3);
  }
  EXPECT_EQ(windows.evaluations(), begun);
  EXPECT_EQ(windows.largest_part(), 1.5);
  EXPECT_FALSE(HeatWindows(1).may_last());
}

TEST(HeatWindows, WithoutOneTheyAreAHundredthOfHeatsStep) {
  const HeatWindows windows;
  EXPECT_TRUE(windows.may_last());
  EXPECT_EQ(windows.length(kLate, 1, 750), 7);
  EXPECT_EQ(windows.length(kLate, 1, 250), 2);
  EXPECT_EQ(windows.length(kLate, 1, 1e9), 16);
  EXPECT_EQ(windows.length(kLate, 1, 50), 1);
  EXPECT_EQ(windows.length(kLate, 1, 0), 1);
}

TEST(HeatWindows, TheFirstAreShort) {
  const HeatWindows windows;
  EXPECT_EQ(windows.length(0, 1, 1e9), 1);
  EXPECT_EQ(windows.length(63, 1, 1e9), 1);
  EXPECT_EQ(windows.length(64, 1, 1e9), 2);
  EXPECT_EQ(windows.length(640, 1, 1e9), 11);
}

TEST(HeatWindows, WhatIsNoNumberIsConductedInEachStep) {
  const HeatWindows windows;
  const Real none = std::numeric_limits<Real>::quiet_NaN();
  const Real infinite = std::numeric_limits<Real>::infinity();
  EXPECT_EQ(windows.length(kLate, 1, none), 1);
  EXPECT_EQ(windows.length(kLate, none, 1), 1);
  EXPECT_EQ(windows.length(kLate, infinite, infinite), 1);
  EXPECT_EQ(windows.length(kLate, 1, infinite), 16);  // nothing flows
}

}  // namespace
}  // namespace brunt::test
