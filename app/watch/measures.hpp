#pragma once
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "app/deck/deck.hpp"
#include "app/deck/measure_source.hpp"

namespace brunt {

/// The value of one measure of the deck.
struct MeasureValue {
  std::string name;
  Real value = 0;  ///< SI
  std::string unit;
  std::optional<Real> reference, exact;
  Real time = std::numeric_limits<Real>::quiet_NaN();  ///< [s] real, when it was taken
};

/// What a measure reads of a body; nothing of expressions and of columns of the history.
struct MeasureReads {
  std::string body;
  WantedFields fields;
  bool at_start = false;  ///< at time 0 too
};
std::optional<MeasureReads> reads_of(const deck::Measure& measure);

/// Evaluates one measure; an expression reads the values found before it.
/// Throws std::invalid_argument where body, field or column do not exist.
Real evaluate_measure(const deck::Measure& measure, const MeasureSource& source,
                      const std::vector<MeasureValue>& before);

}  // namespace brunt
