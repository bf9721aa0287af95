#pragma once
#include <cstdint>
#include <optional>

#include "core/types.hpp"

namespace brunt {

/// When rows of history are written: at the first step at or after multiples of an interval.
///
/// An interval that the deck names is kept. Without one it is the end over 2000, and a row comes
/// where the last one is a least number of steps ago, or where one of a number of rows that are
/// sure is due: rows are close where steps are many or a row costs next to nothing. Times of the
/// clock and counts of steps decide, so rows are a function of the deck.
class RowTimes {
 public:
  /// every  [s] interval that the deck names; end  [s] of the run
  RowTimes(std::optional<Real> every, Real end);
  /// Of rows whose interval no deck names.  steps  between two; sure  number of rows that come
  /// however few steps there are
  void keep_apart(std::int64_t steps, Real sure);

  /// Has a row come due with this step?
  bool due(Real time, std::int64_t step) const;
  void written(Real time, std::int64_t step);
  /// Goes on at a time, once what a checkpoint keeps is read.  step  of the last row
  void go_on(Real time, std::int64_t step);

  Real last() const { return last_; }               ///< [s] of the last row; before the first -1
  std::int64_t last_step() const { return step_; }  ///< its step

  /// What a checkpoint keeps; the steps of rows stand in them.
  template <class Row, class Times>
  static void visit(Row& row, Times& times) {
    row(times.last_);
  }

 private:
  Real every_, end_;
  bool named_;  // the interval, by the deck
  std::int64_t steps_apart_ = 1;
  Real sure_every_ = 0;      // [s] between rows that are sure; 0: none is
  std::int64_t passed_ = 0;  // multiple of the last row
  Real last_ = -1;
  std::int64_t step_ = 0;
};

}  // namespace brunt
