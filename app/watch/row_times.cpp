#include "app/watch/row_times.hpp"

#include <algorithm>

#include "app/watch/frame_times.hpp"

namespace brunt {

namespace {
constexpr Real kMostRows = 2000;
}  // namespace

RowTimes::RowTimes(std::optional<Real> every, Real end)
    : every_(every.value_or(end / kMostRows)), end_(end), named_(every.has_value()) {}

void RowTimes::keep_apart(std::int64_t steps, Real sure) {
  steps_apart_ = steps;
  sure_every_ = sure >= 1 ? end_ / std::min(sure, kMostRows) : 0;
}

bool RowTimes::due(Real time, std::int64_t step) const {
  if (multiples(time, every_) <= passed_) return false;
  return named_ || step - step_ >= steps_apart_ ||
         multiples(time, sure_every_) > multiples(last_, sure_every_);
}

void RowTimes::written(Real time, std::int64_t step) {
  passed_ = multiples(time, every_), last_ = time, step_ = step;
}

void RowTimes::go_on(Real time, std::int64_t step) {
  passed_ = multiples(named_ ? time : last_, every_), step_ = step;
}

}  // namespace brunt
