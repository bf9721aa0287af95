#pragma once
#include <string_view>

#include "core/types.hpp"

namespace brunt {

/// A bound on the time step, with whose it is and why. The smallest wins; ties go to the smaller
/// entity id, so that the winner's name does not depend on order.
struct StepLimit {
  Real step = kInfinity;    ///< [s]
  const char* reason = "";  ///< "element", "particle", "contact stiffness", "contact speed", ...
  Label body = 0;
  GlobalId entity = 0;

  /// True for bounds of elements, particles, their heat and their springs, which are much the same
  /// from step to step; those of speeds and spins may be anything.
  bool of_material() const {
    const std::string_view why = reason;
    return why == "element" || why == "particle" || why == "heat of point" ||
           why == "contact stiffness";
  }
  bool before(const StepLimit& other) const {
    return step < other.step || (step == other.step && entity < other.entity);
  }
  void take(const StepLimit& other) {
    if (other.before(*this)) *this = other;
  }
};

}  // namespace brunt
// Tested by tests/unit/app/clock_test.cpp.
