#pragma once
/// Elements whose temperature at time 0 depends on the place.
#include "fe/element_block.hpp"

namespace brunt {

/// [K] of a node of a block at time 0; points are at the places of time 0.
template <int Dim>
Real start_temperature(const ElementBlock<Dim>& block, const Points<Dim>& points, LocalIndex node);

/// Gives the material points of a block with a temperature_field theirs. Where it conducts they
/// have what steps make of those of the nodes, so that nothing expands before heat has flowed; else
/// that of their own place, which they keep where heat is off. Throws InitialTemperatureError.
template <int Dim>
void begin_temperatures(const Points<Dim>& points, ElementBlock<Dim>& block);

}  // namespace brunt
// Tested by tests/verification/initial_temperature_test.cpp.
