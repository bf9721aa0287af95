#pragma once
#include "core/step_vote.hpp"

namespace brunt {

/// Time, step and what bounds the step. Nothing but `end` shortens a step.
class Clock {
 public:
  Clock(Real end, Real safety, Real max_step) : end_(end), safety_(safety), max_step_(max_step) {}

  bool finished() const { return stopped_ || time_ >= end_; }
  Real time() const { return time_; }  ///< [s]
  Real end() const { return end_; }    ///< [s]
  Real dt() const { return dt_; }      ///< [s] of the last step
  std::int64_t step() const { return step_; }
  const StepVote& whose() const { return whose_; }
  void stop() { stopped_ = true; }

  /// The step [s] to take: safety times the smallest vote, max_step, what is left to `end`.
  Real limit(const StepVote& vote) {
    whose_ = vote;
    Real dt = safety_ * vote.step;
    if (dt > max_step_) dt = max_step_, whose_ = {max_step_, "max_step", 0, 0};
    const Real left = end_ - time_;
    if (dt >= left) {
      dt = left;
      last_ = true;
    }
    return dt;
  }
  void advance(Real dt) {
    dt_ = dt;
    time_ = last_ ? end_ : time_ + dt;
    ++step_;
  }

 private:
  Real end_, safety_, max_step_;
  Real time_ = 0, dt_ = 0;
  std::int64_t step_ = 0;
  bool last_ = false, stopped_ = false;
  StepVote whose_;
};

}  // namespace brunt
