#pragma once
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/view.hpp"

namespace brunt {

/// What measures read: views of bodies at the moment and at time 0, and the history so far.
struct MeasureSource {
  /// The body of the measure, with the fields that it reads.
  std::function<const BodyView&(const std::string& body)> view;
  /// By body, at time 0: of bodies and with fields that some measure reads of then.
  const std::map<std::string, BodyView>* start = nullptr;
  const std::vector<std::string>* columns = nullptr;     ///< names of history columns
  const std::vector<std::vector<Real>>* rows = nullptr;  ///< history so far
};

}  // namespace brunt
// Tested by tests/unit/app/measures_test.cpp.
