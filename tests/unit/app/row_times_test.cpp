/// Rows come at multiples of what a deck names; without that where the last one is so many steps
/// ago as is asked for, and as often as is sure.
#include "app/watch/row_times.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace brunt {
namespace {

/// Steps of rows of a run over a time of 1 in equal steps, which may go on from a checkpoint.
std::vector<std::int64_t> rows_of(RowTimes times, std::int64_t steps, std::int64_t restart = -1) {
  std::vector<std::int64_t> rows;
  times.written(0, 0);
  for (std::int64_t step = 1; step <= steps; ++step) {
    const Real time = static_cast<Real>(step) / static_cast<Real>(steps);
    if (times.due(time, step)) {
      times.written(time, step);
      rows.push_back(step);
    }
    EXPECT_FALSE(times.due(time, step));
    if (step == restart) times.go_on(time, times.last_step());
  }
  return rows;
}

RowTimes apart(std::int64_t steps, Real sure) {
  RowTimes times(std::nullopt, 1);
  times.keep_apart(steps, sure);
  return times;
}

TEST(RowTimes, KeepTheIntervalThatADeckNames) {
  RowTimes times(0.01, 1);
  times.keep_apart(1000, 0);
  const auto rows = rows_of(times, 250);
  ASSERT_EQ(rows.size(), 100U);
  EXPECT_EQ(rows[0], 3);  // the first step at or after 0.01
  EXPECT_EQ(rows[1], 5);
}

TEST(RowTimes, AreTwoThousandAtMost) {
  EXPECT_EQ(rows_of(apart(1, kInfinity), 10'000).size(), 2000U);
  EXPECT_EQ(rows_of(apart(1, 0), 10'000).size(), 2000U);
  EXPECT_EQ(rows_of(apart(1, 0), 300).size(), 300U);  // one each step
}

TEST(RowTimes, AreSoManyStepsApart) {
  EXPECT_EQ(rows_of(apart(40, 0), 800).size(), 20U);
  EXPECT_EQ(rows_of(apart(40, 0), 80'000).size(), 2000U);
}

TEST(RowTimes, AreSureHoweverFewStepsThereAre) {
  EXPECT_EQ(rows_of(apart(100, 50), 200).size(), 50U);
  EXPECT_EQ(rows_of(apart(100, 2), 1000).size(), 10U);  // the halves are among them
  EXPECT_EQ(rows_of(apart(100, kInfinity), 200).size(), 200U);
  EXPECT_EQ(rows_of(apart(100, 0.9), 90).size(), 0U);  // the last state has its row anyhow
}

TEST(RowTimes, GoOnAsIfNothingHadBeen) {
  for (const auto& times : {apart(37, 0), apart(37, 11), apart(1, 0), RowTimes(0.013, 1)}) {
    const auto whole = rows_of(times, 997);
    for (const std::int64_t step : {1, 36, 37, 38, 500, 996}) {
      EXPECT_EQ(rows_of(times, 997, step), whole) << "from step " << step;
    }
  }
}

}  // namespace
}  // namespace brunt
