#pragma once
#include <algorithm>
#include <cmath>

#include "tests/support/simulate.hpp"

namespace brunt::test {

/// Of a force that acts once: its duration [s], its mean over the middle half of that and its peak
/// [N].
struct ForcePulse {
  Real duration = 0, mean = 0, peak = 0;
};

/// The pulse in a column of history.csv, whatever its sign.
inline ForcePulse force_pulse(const Simulation& run, const std::string& column) {
  const auto time = run.column("time"), force = run.column(column);
  Real first = -1, last = 0;
  ForcePulse pulse;
  for (std::size_t i = 0; i < time.size(); ++i) {
    const Real f = std::fabs(force[i]);
    if (f == 0) continue;
    if (first < 0) first = time[i];
    last = time[i];
    pulse.peak = std::max(pulse.peak, f);
  }
  pulse.duration = last - first;
  Real sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < time.size(); ++i) {
    const Real s = (time[i] - first) / pulse.duration;
    if (s < 0.25 || s > 0.75) continue;
    sum += std::fabs(force[i]), ++count;
  }
  pulse.mean = sum / count;
  return pulse;
}

}  // namespace brunt::test
