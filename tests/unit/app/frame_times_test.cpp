/// Frames come at multiples of what a deck names; without that at eightieths, fortieths or
/// twentieths of the end, the closest that leave the steps between them that are asked for.
#include "app/watch/frame_times.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <vector>

namespace brunt {
namespace {

/// Steps of frames of a run over a time of 1; dt(time) is its step.
std::vector<std::int64_t> frames_of(FrameTimes times, const std::function<Real(Real)>& dt,
                                    std::int64_t restart = -1) {
  std::vector<std::int64_t> frames;
  Real time = 0;
  for (std::int64_t step = 1; time < 1; ++step) {
    time = std::min(time + dt(time), Real{1});
    const bool due = times.due(time, step);
    EXPECT_EQ(times.pass(time, step), due);
    EXPECT_FALSE(times.due(time, step));
    if (due) frames.push_back(step);
    if (step == restart) {
      FrameTimes later(std::nullopt, 1);
      later.keep_apart(100);
      later.go_on(times, time, step);
      times = later;
    }
  }
  return frames;
}

std::vector<std::int64_t> frames_of(std::int64_t apart, Real steps) {
  FrameTimes times(std::nullopt, 1);
  times.keep_apart(apart);
  return frames_of(times, [&](Real) { return 1 / steps; });
}

/// All the same to a step, which times round to.
void expect_regular(const std::vector<std::int64_t>& frames, std::int64_t each) {
  std::int64_t last = 0;
  for (const std::int64_t step : frames) {
    EXPECT_LE(std::abs(step - last - each), 1) << "at step " << step;
    last = step;
  }
}

TEST(FrameTimes, KeepTheIntervalThatADeckNames) {
  FrameTimes times(0.01, 1);
  times.keep_apart(1000);
  const auto frames = frames_of(times, [](Real) { return 1e-3; });
  EXPECT_EQ(frames.size(), 100U);
  expect_regular(frames, 10);
}

TEST(FrameTimes, AreAsCloseAsTheirStepsAllow) {
  expect_regular(frames_of(100, 8000), 100);
  EXPECT_EQ(frames_of(99, 8000).size(), 80U);
  expect_regular(frames_of(110, 8000), 200);
  EXPECT_EQ(frames_of(110, 8000).size(), 40U);
  expect_regular(frames_of(150, 8000), 200);  // three of four would not be equally far apart
  expect_regular(frames_of(210, 8000), 400);
  EXPECT_EQ(frames_of(210, 8000).size(), 20U);
}

TEST(FrameTimes, AreTwentyAtLeast) {
  EXPECT_EQ(frames_of(1000, 8000).size(), 20U);
  EXPECT_EQ(frames_of(1'000'000'000, 8000).size(), 20U);
  EXPECT_EQ(frames_of(1000, 40).size(), 20U);
  EXPECT_EQ(frames_of(1, 10).size(), 10U);  // one each step
}

TEST(FrameTimes, ComeCloserWhereStepsGetShorter) {
  FrameTimes times(std::nullopt, 1);
  times.keep_apart(100);
  const auto frames = frames_of(times, [](Real t) { return t < 0.5 ? 1 / 2400.0 : 1 / 16000.0; });
  // Ten of the first half, each 120 steps; forty of the second, each 200.
  EXPECT_EQ(frames.size(), 50U);
}

TEST(FrameTimes, GoOnAsIfNothingHadBeen) {
  const auto dt = [](Real t) { return 1 / (4000.0 + 6000 * t); };
  FrameTimes times(std::nullopt, 1);
  times.keep_apart(100);
  const auto whole = frames_of(times, dt);
  for (const std::int64_t step : {1, 49, 50, 51, 99, 151, 437, 2222}) {
    EXPECT_EQ(frames_of(times, dt, step), whole) << "from step " << step;
  }
}

TEST(FrameTimes, OfAnotherIntervalStartAnew) {
  FrameTimes coarse(0.1, 1), fine(0.01, 1);
  coarse.pass(0.55, 55);
  fine.go_on(coarse, 0.555, 56);
  EXPECT_FALSE(fine.due(0.559, 57));
  EXPECT_TRUE(fine.due(0.561, 58));
}

}  // namespace
}  // namespace brunt
