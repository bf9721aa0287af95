#pragma once
#include <cstdint>
#include <optional>

#include "core/types.hpp"

namespace brunt {

/// For how many steps an evaluation of conduction acts (docs/decisions/236-heat-every-auto.md).
///
///   if (windows.is_due(step, dt, longest)) windows.begin(step, dt, longest);
///   windows.advance(dt);
///   ... all steps up to the next that is due take what was evaluated in this one
class HeatWindows {
 public:
  /// given  steps of each window; none: as many as a hundredth of heat's step holds
  explicit HeatWindows(std::optional<int> given = {}) : given_(given), steps_(given.value_or(1)) {}

  /// True where windows may have more than one step.
  bool may_last() const { return !given_ || *given_ > 1; }
  bool is_chosen() const { return !given_; }
  /// Steps that heat's longest step is divided by to bound that of motion. Windows that are chosen
  /// end before they are too long instead.
  int bounding_steps() const { return given_.value_or(1); }
  /// True in the step that begins a window: of dt [s], the longest stable one of heat being
  /// `longest` [s] by now.
  bool is_due(std::int64_t step, Real dt, Real longest) const;
  /// Steps of a window that begins in `step` [1].
  /// dt       [s] of that step
  /// longest  [s] stable step of heat, of all ranks
  int length(std::int64_t step, Real dt, Real longest) const;
  /// Begins the window of a step that is due.
  void begin(std::int64_t step, Real dt, Real longest);
  void advance(Real dt) { elapsed_ += dt; }
  /// From `step` on windows that are chosen are as short again as at time 0: something changed.
  void restart(std::int64_t step) {
    if (is_chosen()) next_ = restarted_ = step;
  }
  int steps() const { return steps_; }  ///< of the present window
  /// Windows that this process has begun, and the largest of them over heat's longest stable step.
  std::int64_t evaluations() const { return evaluations_; }
  Real largest_part() const { return largest_part_; }

  template <class Row, class AnyWindows>
  static void visit(Row& row, AnyWindows& windows) {
    row(windows.steps_), row(windows.next_), row(windows.elapsed_);
    row(windows.restarted_);
  }

 private:
  std::optional<int> given_;
  int steps_;                   // those that are given bound the first step too
  std::int64_t next_ = 0;       ///< the step in which the next window begins
  Real elapsed_ = 0;            ///< [s] of the present window
  std::int64_t restarted_ = 0;  ///< the step from which on their lengths are counted
  std::int64_t evaluations_ = 0;
  Real largest_part_ = 0;
};

}  // namespace brunt
// Tested by tests/unit/app/heat_windows_test.cpp.
