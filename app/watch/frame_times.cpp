#include "app/watch/frame_times.hpp"

#include <algorithm>
#include <cmath>

namespace brunt {

namespace {
constexpr int kMostFrames = 80;
constexpr int kSecond = 2, kFourth = 4;  // each so many of them, where more would be too close
}  // namespace

std::int64_t multiples(Real time, Real every) {
  return every > 0 ? static_cast<std::int64_t>(std::floor(time / every * (1 + 1e-12))) : 0;
}

FrameTimes::FrameTimes(std::optional<Real> every, Real end)
    : every_(every.value_or(end / kMostFrames)), named_(every.has_value()) {}

bool FrameTimes::due(Real time, std::int64_t step) const {
  const std::int64_t now = multiples(time, every_);
  if (now <= passed_) return false;
  if (named_ || now / kFourth > passed_ / kFourth) return true;
  if (step - frame_step_ < steps_apart_) return false;
  // Frames are equally far apart: none between two seconds of which the first had none.
  const std::int64_t before = now / kSecond > passed_ / kSecond ? now - kSecond : now - 1;
  return frame_ >= before;
}

void FrameTimes::go_on(const std::optional<FrameTimes>& saved, Real time, std::int64_t step) {
  passed_ = frame_ = multiples(time, every_), frame_step_ = step;
  if (!saved || saved->every_ != every_) return;
  passed_ = saved->passed_, frame_ = saved->frame_, frame_step_ = saved->frame_step_;
}

bool FrameTimes::pass(Real time, std::int64_t step) {
  const bool is_due = due(time, step);
  passed_ = std::max(passed_, multiples(time, every_));
  if (is_due) frame_ = passed_, frame_step_ = step;
  return is_due;
}

}  // namespace brunt
