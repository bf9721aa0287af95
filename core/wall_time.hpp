#pragma once
#include <chrono>

#include "core/parallel/communicator.hpp"

namespace brunt {

/// Wall time that a part of a run took.
struct WallTime {
  double seconds = 0;  ///< [s]
  double waiting = 0;  ///< [s] of these: sending, receiving, waiting for others

  WallTime& operator+=(const WallTime& other) {
    seconds += other.seconds, waiting += other.waiting;
    return *this;
  }
  /// This rank's own work [s].
  double work() const { return seconds - waiting; }
};

/// Adds its life time to a wall time.
class WallTimer {
 public:
  WallTimer(WallTime& time, const Communicator& ranks)
      : time_(time),
        ranks_(ranks),
        waited_(ranks.traffic().seconds),
        start_(std::chrono::steady_clock::now()) {}
  ~WallTimer() {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start_;
    time_ += {passed.count(), ranks_.traffic().seconds - waited_};
  }
  WallTimer(const WallTimer&) = delete;
  WallTimer& operator=(const WallTimer&) = delete;

 private:
  WallTime& time_;
  const Communicator& ranks_;
  double waited_;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace brunt
// Tested by tests/parallel/scaling.sh.
