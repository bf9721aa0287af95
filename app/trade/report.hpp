#pragma once
#include <string>

#include "app/trade/results.hpp"

namespace brunt {

/// Costs, then errors, fronts and convergence of each measure, for the terminal.
std::string trade_text(const Trade& trade);
/// One line a variant and measure, all digits.
std::string trade_csv(const Trade& trade);
/// All of it, all digits.
std::string trade_json(const Trade& trade);

/// "order 1.9 over size; Richardson's estimate 17.2 mm; bound 0.3 %".
std::string convergence_text(const Convergence& convergence, Real finest, const std::string& unit);

/// "+1.2 %"; an absolute error with its unit.
std::string error_text(const SignedError& error, const std::string& unit);

}  // namespace brunt
