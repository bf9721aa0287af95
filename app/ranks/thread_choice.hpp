#pragma once
#include <cstdint>

namespace brunt {

/// Chooses between all threads and one while other programs use the cores.
///
/// Threads wait for each other at the end of every loop. Where one of them has lost its core to
/// another program the rest wait for its turn of some milliseconds, in every loop: two threads on
/// two busy cores took ten times as long as one. So the steps of a window of wall time are
/// compared with those of one thread, as soon as the threads got less processor time than their
/// number; the faster way goes on, and the other is tried again after a pause that doubles with
/// each failure. How many threads compute changes no bit of the answer.
class ThreadChoice {
 public:
  /// threads  how many there may be
  explicit ThreadChoice(int threads) : all_(threads), now_(threads) {}

  /// Takes in a whole step; returns how many threads the next one takes.
  /// wall  [s] on the wall, cpu  [s] of processor time of all threads; both since any fixed time
  int step_done(double wall, double cpu);

  bool only_one() const { return all_ == 1; }                ///< nothing to choose
  std::int64_t steps_alone() const { return steps_alone_; }  ///< on one thread instead of all

 private:
  static constexpr double kWindow = 0.02;  // [s]; a turn of the system's scheduler takes 3 to 10 ms
  static constexpr double kBusy = 0.85;    // of a window's processor time
  // [s] before the next trial of one thread, which costs little, and of all; twice as long each
  // time
  static constexpr double kPauseOfOne = 0.1, kPauseOfAll = 2, kLongestPause = 30;
  static constexpr double kRarely = 50;  // windows, at least, before all are tried again

  struct Window {
    double step, length, end;  // [s] of wall time: of one step, of all of them, at the end
    bool busy;                 // the threads did not get their cores
  };
  void choose(const Window& window);

  int all_, now_;
  bool started_ = false;
  double wall_ = 0, cpu_ = 0;  // at the window's begin
  std::int64_t steps_ = 0;     // in the window
  double other_step_ = 0;      // [s] of the other way when it was left, 0: not known
  double pause_of_one_ = kPauseOfOne, pause_of_all_ = kPauseOfAll;
  double until_ = 0;  // [s] no trial before
  std::int64_t steps_alone_ = 0;
};

/// The choice for the threads of this process, by its own clocks.
class ThreadTeam {
 public:
  ThreadTeam();
  /// Between two steps.
  void look();
  std::int64_t steps_alone() const { return choice_.steps_alone(); }

 private:
  int threads_;
  ThreadChoice choice_;
};

}  // namespace brunt
