#pragma once
#include <cstdint>
#include <optional>

#include "core/types.hpp"

namespace brunt {

/// Number of the multiple of `every` at or before time; rounding may not lose a row.
std::int64_t multiples(Real time, Real every);

/// When frames are written: at multiples of an interval.
///
/// An interval that the deck names is kept. Without one the end is divided by 80, and a frame comes
/// at each of these multiples, at each second or at each fourth: the closest that leave the least
/// number of steps between two frames, and 20 frames at least however few steps there are. Times of
/// the clock and counts of steps decide, so frames are a function of the deck.
class FrameTimes {
 public:
  /// every  [s] interval that the deck names; end  [s] of the run
  FrameTimes(std::optional<Real> every, Real end);
  /// Of frames whose interval no deck names.
  void keep_apart(std::int64_t steps) { steps_apart_ = steps; }

  /// Has a frame come due with this step?
  bool due(Real time, std::int64_t step) const;
  /// The same, once a step: its frame, if it was due, is taken as written.
  bool pass(Real time, std::int64_t step);
  /// Goes on at a time and step. saved  what a checkpoint has; of another interval, or none: as
  /// after a frame there
  void go_on(const std::optional<FrameTimes>& saved, Real time, std::int64_t step);

  /// What a checkpoint keeps.
  template <class Row, class Times>
  static void visit(Row& row, Times& times) {
    row(times.every_), row(times.passed_), row(times.frame_), row(times.frame_step_);
  }

 private:
  Real every_;
  bool named_;  // the interval, by the deck
  std::int64_t steps_apart_ = 1;
  std::int64_t passed_ = 0;      // multiple that was passed last
  std::int64_t frame_ = 0;       // of the last frame
  std::int64_t frame_step_ = 0;  // step of the last frame
};

}  // namespace brunt
