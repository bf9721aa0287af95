#include "app/scene/heat_windows.hpp"

#include <algorithm>
#include <cmath>

namespace brunt {

bool HeatWindows::is_due(std::int64_t step, Real dt, Real longest) const {
  // Steps grow, and heat's own may become shorter, after a window was chosen for a hundredth of it.
  constexpr Real kLongest = 0.015;
  if (step >= next_) return true;
  return is_chosen() && !(elapsed_ + dt <= kLongest * longest);
}

int HeatWindows::length(std::int64_t step, Real dt, Real longest) const {
  if (given_) return *given_;
  // No mode fades faster than by 2/longest (Gershgorin), so that none fades more than 1 % too fast,
  // and those that elements resolve 0.02 %.
  constexpr Real kWindow = 0.01;
  constexpr Real kMostSteps = 16;  // what more would save is a hundredth of a step
  // A jump at time 0, or of a boundary that begins, is conducted a window late: 0.158 of window
  // over time since then, of the jump.
  constexpr std::int64_t kPartOfPast = 64;
  const std::int64_t of_past = 1 + (step - restarted_) / kPartOfPast;
  const Real steps =
      std::floor(std::min({kWindow * longest / dt, kMostSteps, static_cast<Real>(of_past)}));
  return steps >= 1 ? static_cast<int>(steps) : 1;
}

void HeatWindows::begin(std::int64_t step, Real dt, Real longest) {
  steps_ = length(step, dt, longest);
  next_ = step + steps_;
  elapsed_ = 0;
  ++evaluations_;
  largest_part_ = std::max(largest_part_, steps_ * dt / longest);
}

}  // namespace brunt
// Tested by tests/unit/app/heat_windows_test.cpp.
