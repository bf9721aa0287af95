#pragma once
#include "core/schema.hpp"

namespace brunt {

/// What bodies that overlap at time 0 feel of it (docs/theory/contact.md (C36)): once they have
/// opened, or at once.
enum class InitialOverlap : int { track, press };

/// [m] of an overlap of time 0 of which contact takes no notice; what is no more than `rounding` is
/// none.
inline Real ignored_overlap(InitialOverlap law, Real overlap, Real rounding) {
  return law == InitialOverlap::press || overlap <= rounding ? 0.0 : overlap;
}

inline void describe(Schema& s, InitialOverlap& law) {
  static constexpr const char* kWords[] = {"track", "press"};
  s.choice({"initial_overlap",
            "bodies that overlap at time 0 feel it once they have opened (track) or at once "
            "(press)"},
           law, kWords);
}

}  // namespace brunt
// Tested by tests/unit/contact/first_touch_test.cpp.
