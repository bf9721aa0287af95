// The clock: what bounds a step, and that only the end shortens one.
#include "app/loop/clock.hpp"

#include <gtest/gtest.h>

namespace brunt {
namespace {

TEST(Clock, EndsExactly) {
  Clock clock(1.0, 0.9, kInfinity);
  int steps = 0;
  while (!clock.finished()) {
    clock.advance(clock.limit({0.1 / 0.9, "element", 1, 2}));
    ++steps;
  }
  EXPECT_EQ(clock.time(), 1.0);
  EXPECT_LE(steps, 11);
}

// Twenty thousand times 1e-6 are 6.5e-16 less than 0.02: no step is made for them.
TEST(Clock, RoundingIsNoStep) {
  Clock clock(0.02, 1.0, 1e-6);
  while (!clock.finished()) {
    const StepLimit step_limit{1.0, "element", 0, 0};
    EXPECT_EQ(clock.shortens(step_limit), clock.step() == 19999) << clock.step();
    clock.advance(clock.limit(step_limit));
    ASSERT_NEAR(clock.dt(), 1e-6, 1e-15);
  }
  EXPECT_EQ(clock.step(), 20000);
  EXPECT_EQ(clock.time(), 0.02);
}

TEST(Clock, KnowsWhetherTheEndShortenedTheLastStep) {
  Clock clock(1.0, 1.0, 0.4), even(1.0, 1.0, 0.25);
  for (const bool last : {false, false, true}) {
    clock.advance(clock.limit({1.0, "element", 0, 0}));
    EXPECT_EQ(clock.shortened(), last);
  }
  while (!even.finished()) even.advance(even.limit({1.0, "element", 0, 0}));
  EXPECT_FALSE(even.shortened());
}

TEST(Clock, MaxStepHasItsName) {
  Clock clock(1.0, 0.5, 1e-3);
  EXPECT_EQ(clock.limit({1.0, "element", 0, 0}), 1e-3);
  EXPECT_STREQ(clock.whose().reason, "max_step");
  EXPECT_EQ(clock.limit({1e-3, "element", 0, 0}), 5e-4);
  EXPECT_STREQ(clock.whose().reason, "element");
}

TEST(Clock, TheStepHasCollapsedAThousandfoldBelowTheFirstThatMaterialBounds) {
  Clock clock(1.0, 0.5, 1e-2);
  EXPECT_EQ(clock.least_step(), 1e-9);  // of the end, until there is a plan
  clock.limit({1e-1, "spin of a rigid body", 0, 0});
  EXPECT_EQ(clock.planned_step(), 0);
  clock.limit({1e-3, "contact speed", 0, 0});
  EXPECT_EQ(clock.planned_step(), 0);
  clock.limit({4e-3, "element", 0, 0});
  clock.limit({1e-4, "element", 0, 0});
  EXPECT_EQ(clock.planned_step(), 2e-3);
  EXPECT_EQ(clock.least_step(), 2e-6);
  EXPECT_EQ(Clock(1.0, 0.5, 1e-2, 1e-7).least_step(), 1e-7);
}

TEST(Clock, CountsWhatBoundedTheStepsOfEachBody) {
  Clock clock(1.0, 1.0, 0.1);
  for (const StepLimit limit : {StepLimit{0.05, "element", 1, 2}, StepLimit{0.04, "element", 1, 9},
                                StepLimit{0.03, "element", 0, 2}, StepLimit{0.5, "element", 1, 2},
                                StepLimit{0.06, "element", 1, 7}}) {
    clock.advance(clock.limit(limit));
  }
  const auto bounds = clock.bounds().sorted();
  ASSERT_EQ(bounds.size(), 3U);
  EXPECT_STREQ(bounds[0].reason, "element");
  EXPECT_EQ(bounds[0].body, 1U);
  EXPECT_EQ(bounds[0].steps, 3);
  EXPECT_EQ(bounds[1].body, 0U);
  EXPECT_STREQ(bounds[2].reason, "max_step");
}

TEST(StepLimit, TiesGoToTheSmallerEntity) {
  StepLimit step_limit;
  step_limit.take({2.0, "b", 0, 7});
  step_limit.take({2.0, "a", 0, 3});
  step_limit.take({3.0, "c", 0, 1});
  EXPECT_STREQ(step_limit.reason, "a");
}

}  // namespace
}  // namespace brunt
