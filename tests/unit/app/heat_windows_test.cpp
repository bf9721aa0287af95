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
    const bool due = windows.is_due(step, 1, 1e-9);  // of which heat's step says nothing
    EXPECT_EQ(due, step % 3 == 0) << step;
    if (due) windows.begin(step, 1, 2), ++begun;
    windows.advance(1);
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

// Chosen for a hundredth of heat's step they end where they would take 0.015 of it: where steps
// grow, and where heat's own becomes shorter.
TEST(HeatWindows, ChosenOnesEndBeforeTheyAreLong) {
  HeatWindows windows;
  ASSERT_TRUE(windows.is_due(kLate, 1, 800));
  windows.begin(kLate, 1, 800);
  ASSERT_EQ(windows.steps(), 8);
  windows.advance(1);
  EXPECT_FALSE(windows.is_due(kLate + 1, 1, 800));
  EXPECT_FALSE(windows.is_due(kLate + 1, 10.9, 800));
  EXPECT_TRUE(windows.is_due(kLate + 1, 11.1, 800));
  EXPECT_FALSE(windows.is_due(kLate + 1, 1, 134));
  EXPECT_TRUE(windows.is_due(kLate + 1, 1, 133));
  EXPECT_TRUE(windows.is_due(kLate + 1, 1, std::numeric_limits<Real>::quiet_NaN()));
  EXPECT_TRUE(windows.is_due(kLate + 8, 1, 800));
  windows.begin(kLate + 1, 1, 133);
  windows.advance(1);
  EXPECT_EQ(windows.steps(), 1);
}

TEST(HeatWindows, WhatChangesMakesThemShortAgain) {
  HeatWindows windows, given(4);
  windows.begin(kLate, 1, 1e9);
  windows.restart(kLate + 3), given.restart(2);
  EXPECT_TRUE(windows.is_due(kLate + 3, 1, 1e9));
  EXPECT_EQ(windows.length(kLate + 3, 1, 1e9), 1);
  EXPECT_EQ(windows.length(kLate + 3 + 64, 1, 1e9), 2);
  EXPECT_EQ(given.length(2, 1, 1e9), 4);
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
