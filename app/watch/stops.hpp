#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/deck/deck.hpp"
#include "app/loop/clock.hpp"
#include "app/scene/scene.hpp"
#include "io/deck/column_expression.hpp"

namespace brunt {

/// What ends a run before its time: `stop` of the deck.
template <int Dim>
class StopConditions {
 public:
  /// deck  outlives it
  explicit StopConditions(const Deck& deck) : stop_(deck.stop) {}
  /// At time 0. columns  of the history
  void begin(const Scene<Dim>& scene, const std::vector<std::string>& columns);
  /// After a whole step: why the run ends now, or "". row  what the history has of this step, empty
  /// where that is nothing. Collective.
  std::string look(const Scene<Dim>& scene, const Clock& clock, std::span<const Real> row);
  /// What goes over a restart.
  template <class Row, class AnyStops>
  static void visit(Row& row, AnyStops& stops) {
    row(stops.at_rest_since_);
  }

 private:
  bool is_at_rest(const Scene<Dim>& scene, Real time);

  const deck::Stop& stop_;
  std::optional<ColumnExpression> when_;
  Real at_rest_since_ = -1;  // [s]; negative: it moves
  Real start_center_ = 0;    // [m] of the body of stop.beyond
};

}  // namespace brunt
// Tested by tests/verification/stops_test.cpp.
