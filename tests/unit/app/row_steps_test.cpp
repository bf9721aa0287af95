/// Rows by default take no more than their share of the time, by the costs that stand in
/// docs/performance.md; steps between them depend on counts alone.
#include "app/watch/row_steps.hpp"

#include <gtest/gtest.h>

namespace brunt {
namespace {

TEST(RowSteps, KeepTheShareOfRows) {
  for (const Real row : {1.0, 10.0, 150.0}) {
    const RowWork work{row, 100};
    const auto steps = static_cast<Real>(steps_between_rows(work));
    EXPECT_LE(row / (steps * work.step), kShareOfRows);
    EXPECT_TRUE(steps == 1 || row / ((steps - 1) * work.step) > kShareOfRows);
  }
}

TEST(RowSteps, AreBounded) {
  EXPECT_EQ(steps_between_rows({1e9, 1}), 100);
  EXPECT_EQ(steps_between_rows({0, 1}), 1);
  EXPECT_EQ(steps_between_rows({1, 0}), 1);  // nothing but rigid bodies
}

}  // namespace
}  // namespace brunt
