#pragma once
#include <algorithm>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/step_limit.hpp"

namespace brunt {

/// How many of the steps that this process took were bounded by what: "element" of a body,
/// "contact stiffness" of another. A cost, as the processor time is: a restart counts anew.
class StepBounds {
 public:
  struct Share {
    const char* reason;  ///< that of a StepLimit
    Label body;
    std::int64_t steps;
  };

  void count(const StepLimit& whose) {
    for (auto& share : shares_) {
      if (share.body != whose.body || std::string_view(share.reason) != whose.reason) continue;
      ++share.steps;
      return;
    }
    shares_.push_back({whose.reason, whose.body, 1});
  }
  /// Those that bounded the most steps first.
  std::vector<Share> sorted() const {
    auto shares = shares_;
    std::stable_sort(shares.begin(), shares.end(),
                     [](const Share& a, const Share& b) { return a.steps > b.steps; });
    return shares;
  }

 private:
  std::vector<Share> shares_;
};

}  // namespace brunt
// Tested by tests/unit/app/clock_test.cpp.
