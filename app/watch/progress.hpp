#pragma once
#include <chrono>
#include <string>

#include "app/loop/clock.hpp"

namespace brunt {

/// What a line of progress says.
struct ProgressState {
  Real time = 0, end = 0;  ///< [s]
  std::int64_t step = 0;
  Real dt = 0;         ///< [s]
  std::string whose;   ///< what bounds dt
  Real drift = 0;      ///< of the energy
  double elapsed = 0;  ///< [s] of wall time
};
std::string progress_text(const ProgressState& state);
/// "12 s", "3 min 05 s", "2 h 10 min".
std::string duration_text(double seconds);

/// Progress on stderr: a bar on a terminal, a line now and then in a file.
class Progress {
 public:
  explicit Progress(bool quiet);
  void show(const Clock& clock, const std::string& whose, Real drift);
  void finish();

 private:
  bool quiet_, terminal_, shown_ = false;
  std::chrono::steady_clock::time_point start_, last_;
};

}  // namespace brunt
