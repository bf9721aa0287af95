#pragma once
#include "app/trade/results.hpp"
#include "io/drawing.hpp"

namespace brunt {

/// Error over processor time, log-log, one panel a measure and one of all: discs joined by steps
/// are the front, rings are dominated, bars are the spread of the time.
Drawing trade_chart(const Trade& trade);

/// Round numbers of a logarithmic axis, 1, 2 and 5 times powers of ten or the powers alone.
std::vector<Real> log_ticks(Real low, Real high);

}  // namespace brunt
