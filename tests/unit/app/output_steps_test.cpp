/// Rows and frames by default take no more than their share of the time, by the costs that stand in
/// docs/performance.md; steps between them depend on counts alone.
#include "app/watch/output_steps.hpp"

#include <gtest/gtest.h>

namespace brunt {
namespace {

TEST(OutputSteps, KeepTheShareOfRows) {
  for (const Real row : {0.5, 1.0, 10.0, 90.0}) {
    const OutputWork work{row, 0, 100};
    const auto steps = static_cast<Real>(steps_between_rows(work));
    EXPECT_LE(row / (steps * work.step), kShareOfRows);
    EXPECT_TRUE(steps == 1 || row / ((steps - 1) * work.step) > kShareOfRows);
  }
}

TEST(OutputSteps, KeepTheShareOfFrames) {
  for (const Real frame : {0.5, 1.0, 200.0, 5000.0}) {
    const OutputWork work{0, frame, 100};
    const auto steps = static_cast<Real>(steps_between_frames(work));
    EXPECT_LE(frame / (steps * work.step), kShareOfFrames);
    EXPECT_TRUE(steps == 1 || frame / ((steps - 1) * work.step) > kShareOfFrames);
  }
}

TEST(OutputSteps, SureRowsTakeTheirTime) {
  EXPECT_EQ(sure_rows({kTimeOfSureRows / 40.5, 0, 1}), 40);
  EXPECT_EQ(sure_rows({2 * kTimeOfSureRows, 0, 1}), 0);
  EXPECT_EQ(sure_rows({0, 0, 1}), kInfinity);
}

TEST(OutputSteps, AreBounded) {
  EXPECT_EQ(steps_between_rows({1e9, 0, 1}), 100);
  EXPECT_EQ(steps_between_rows({0, 0, 1}), 1);
  EXPECT_EQ(steps_between_rows({1, 1, 0}), 1);  // nothing but rigid bodies
  EXPECT_EQ(steps_between_frames({1, 1, 0}), 1);
}

}  // namespace
}  // namespace brunt
