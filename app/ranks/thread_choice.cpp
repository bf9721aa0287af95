#include "app/ranks/thread_choice.hpp"

#include <omp.h>

#include <algorithm>
#include <ctime>
#include <utility>

namespace brunt {

namespace {
double seconds_of(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}
}  // namespace

int ThreadChoice::step_done(double wall, double cpu) {
  if (all_ == 1) return 1;
  if (!started_) {
    started_ = true;
    wall_ = wall, cpu_ = cpu;
    return now_;
  }
  ++steps_;
  if (now_ < all_) ++steps_alone_;
  const double passed = wall - wall_;
  if (passed < kWindow) return now_;
  choose({passed / static_cast<double>(steps_), passed, wall, cpu - cpu_ < kBusy * now_ * passed});
  wall_ = wall, cpu_ = cpu, steps_ = 0;
  return now_;
}

void ThreadChoice::choose(const Window& window) {
  const double other = std::exchange(other_step_, 0.0);
  if (other > 0) {  // this was a trial
    double& pause = now_ == all_ ? pause_of_all_ : pause_of_one_;
    if (window.step > other) {
      pause = std::min(2 * pause, kLongestPause);
      now_ = now_ == all_ ? 1 : all_;
    } else {
      pause_of_one_ = kPauseOfOne, pause_of_all_ = now_ == all_ ? kPauseOfAll : pause_of_all_;
    }
    until_ = window.end +
             (now_ == all_ ? pause_of_one_ : std::max(pause_of_all_, kRarely * window.length));
    return;
  }
  // All threads are tried again now and then; one where they did not get their cores.
  if (window.end < until_ || (now_ == all_ && !window.busy)) return;
  other_step_ = window.step;
  now_ = now_ == all_ ? 1 : all_;
}

ThreadTeam::ThreadTeam() : threads_(omp_get_max_threads()), choice_(threads_) {}

void ThreadTeam::look() {
  if (choice_.only_one()) return;  // clocks of processor time are calls to the system
  const int threads =
      choice_.step_done(seconds_of(CLOCK_MONOTONIC), seconds_of(CLOCK_PROCESS_CPUTIME_ID));
  if (threads == threads_) return;
  threads_ = threads;
  omp_set_num_threads(threads);
}

}  // namespace brunt
