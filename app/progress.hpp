#pragma once
#include <chrono>
#include <string>

#include "app/clock.hpp"

namespace brunt {

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
