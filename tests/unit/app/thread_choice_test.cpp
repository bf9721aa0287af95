// Threads that lost their cores to other programs wait for each other for milliseconds in every
// loop. A machine of two cores is played through by its laws: a step of one thread takes 1 ms, of
// two on free cores 0.6 ms, of two on busy cores 10 ms, and two that spin get the processor time
// that the machine has for them.
#include "app/ranks/thread_choice.hpp"

#include <gtest/gtest.h>

namespace brunt {
namespace {

class Machine {
 public:
  double wall = 0;
  int threads = 2;

  /// Runs for some seconds of wall time; returns the steps that it got through.
  int run(double seconds, bool busy) {
    const double end = wall + seconds;
    int steps = 0;
    for (; wall < end; ++steps) {
      const double one = busy ? 2e-3 : 1e-3, two = busy ? 10e-3 : 0.6e-3;
      const double step = threads == 1 ? one : two;
      wall += step;
      cpu_ += step * threads * (busy ? 0.5 : 1);
      threads = choice_.step_done(wall, cpu_);
    }
    return steps;
  }

 private:
  ThreadChoice choice_{2};
  double cpu_ = 0;
};

TEST(ThreadChoice, StaysWithAllThreadsOnAFreeMachine) {
  Machine machine;
  EXPECT_NEAR(machine.run(3, false), 3 / 0.6e-3, 1.5);
  EXPECT_EQ(machine.threads, 2);
}

TEST(ThreadChoice, CostsLittleMoreThanOneThreadOnABusyOne) {
  Machine machine;
  // 1.2 times as long as one thread, which gets through 1,500 steps.
  EXPECT_GT(machine.run(3, true), 1500 / 1.1);
}

TEST(ThreadChoice, ComesBackWhenTheMachineIsFree) {
  Machine machine;
  machine.run(10, true);
  machine.run(31, false);  // the longest pause
  EXPECT_EQ(machine.threads, 2);
  EXPECT_GT(machine.run(10, true), 5000 / 1.1);
}

TEST(ThreadChoice, DoesNotMindThreadsThatSleep) {
  // Those that sleep while they wait take little processor time on a free machine too.
  ThreadChoice choice(2);
  double wall = 0, cpu = 0;
  int threads = 2, alone = 0;
  for (int i = 0; i < 100'000; ++i) {
    const double step = threads == 1 ? 1e-3 : 0.6e-3;
    wall += step, cpu += 1.2 * step;
    threads = choice.step_done(wall, cpu);
    alone += threads == 1;
  }
  EXPECT_EQ(choice.steps_alone(), alone);
  EXPECT_LT(alone, 1000);
}

TEST(ThreadChoice, LeavesASingleThreadAlone) {
  ThreadChoice choice(1);
  EXPECT_EQ(choice.step_done(1, 0.1), 1);
  EXPECT_EQ(choice.step_done(2, 0.2), 1);
  EXPECT_EQ(choice.steps_alone(), 0);
}

}  // namespace
}  // namespace brunt
