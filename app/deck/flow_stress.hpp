#pragma once
#include "app/deck/materials.hpp"

namespace brunt::deck {

/// Flow stress [Pa] of slow straining at room temperature, without pressure; infinite where the
/// material does not yield.
/// strain  [1] plastic
Real slow_flow_stress(const StrengthLaw& law, Real strain);

}  // namespace brunt::deck
// Tested by tests/unit/app/forecast_test.cpp.
