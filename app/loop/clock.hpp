#pragma once
#include <algorithm>
#include <optional>

#include "app/loop/step_bounds.hpp"
#include "core/state.hpp"
#include "core/step_limit.hpp"

namespace brunt {

/// Time, step and what bounds the step. Nothing but `end` shortens a step, or makes it longer, by
/// what rounding of the time would leave for one more.
class Clock {
 public:
  /// min_step [s]: a shorter step limit stops the run; none: kCollapsed of the first step that
  /// elements or particles bound, and 1e-9 of the end where none do.
  /// process_speed  seconds of the process in one that is stepped
  Clock(Real end, Real safety, Real max_step, std::optional<Real> min_step = {},
        Real process_speed = 1)
      : end_(end),
        safety_(safety),
        max_step_(max_step),
        min_step_(min_step),
        process_speed_(process_speed) {}

  bool finished() const { return stopped_ || time_ >= end_; }
  Real time() const { return time_; }  ///< [s]
  Real end() const { return end_; }    ///< [s]
  Real dt() const { return dt_; }      ///< [s] of the last step
  /// A time of the process [s], of one that is stepped: what is reported and written.
  Real real(Real stepped) const { return process_speed_ * stepped; }
  Real real_time() const { return real(time_); }  ///< [s]
  std::int64_t step() const { return step_; }
  const StepLimit& whose() const { return whose_; }
  void stop() { stopped_ = true; }
  /// The first step [s] that elements or particles bound, of which the plan of steps is made; 0:
  /// none did yet. Contacts and spins may not bound the first step, or bound no other.
  Real planned_step() const { return planned_step_; }
  /// The step limit [s] below which the step has collapsed.
  Real least_step() const {
    return min_step_.value_or(planned_step_ > 0 ? kCollapsed * planned_step_ : 1e-9 * end_);
  }

  /// The step [s] to take: safety times the smallest step limit or max_step, held while they allow
  /// hardly more; or what is left to `end`.
  Real limit(const StepLimit& step_limit) {
    const Real dt = unshortened(step_limit);
    whose_ = step_limit;
    if (planned_step_ == 0 && step_limit.of_material()) planned_step_ = dt;
    if (safety_ * step_limit.step > max_step_) whose_ = {max_step_, "max_step", 0, 0};
    if (!ends(dt)) return held_ = dt;
    last_ = true, shortened_ = end_ - time_ < 0.99 * dt;
    return end_ - time_;
  }
  /// True if the last step was the one that `end` shortened, by more than a hundredth. What a
  /// change of the step leaves in the kinetic energy is that of no other.
  bool shortened() const { return shortened_; }
  /// True if a step under this step limit would be shortened by `end`.
  bool shortens(const StepLimit& step_limit) const { return ends(unshortened(step_limit)); }
  /// The step [s] under this step limit if there were no `end`. One that follows limits which swing
  /// with the strain feeds the fastest motions of undamped bodies
  /// (docs/decisions/251-held-step.md).
  Real unshortened(const StepLimit& step_limit) const {
    const Real most = std::min(safety_ * step_limit.step, max_step_);
    return held_ <= most && most < kWorthGrowing * held_ ? held_ : most;
  }
  void advance(Real dt) {
    bounds_.count(whose_);
    dt_ = dt;
    time_ = last_ ? end_ : time_ + dt;
    ++step_;
  }

  /// What bounded the steps of this process.
  const StepBounds& bounds() const { return bounds_; }

  /// Time, step and whose the step was, in the one row of the table "clock".
  void save_state(std::vector<StateTable>& tables) const {
    save_row(
        "clock", [&](auto& row) { visit(row, *this); }, tables);
  }
  /// `end`, safety and the longest step stay as they are. Throws StateError.
  void load_state(const StateTables& tables) {
    load_row(
        "clock", [&](auto& row) { visit(row, *this); }, tables);
    last_ = stopped_ = shortened_ = false;
    whose_.reason = "before the restart";
  }

 private:
  template <class Row, class AnyClock>
  static void visit(Row& row, AnyClock& clock) {
    row(clock.time_), row(clock.dt_), row(clock.step_);
    row(clock.planned_step_), row(clock.held_);
    row(clock.whose_.step), row(clock.whose_.body), row(clock.whose_.entity);
  }

  /// True if a step dt [s] is the last: no more is left to `end`, but for what rounding leaves out
  /// of a sum of N steps, up to N^2 1e-16/2 of one. A step of that gives rates of rounding.
  bool ends(Real dt) const { return dt >= (1 - 1e-6) * (end_ - time_); }

  static constexpr Real kCollapsed = 1e-3;
  static constexpr Real kWorthGrowing = 1.02;

  Real end_, safety_, max_step_;
  std::optional<Real> min_step_;
  Real process_speed_ = 1;
  Real planned_step_ = 0, held_ = 0;
  Real time_ = 0, dt_ = 0;
  std::int64_t step_ = 0;
  bool last_ = false, stopped_ = false, shortened_ = false;
  StepLimit whose_;
  StepBounds bounds_;
};

}  // namespace brunt
