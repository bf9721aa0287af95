#pragma once
/// Elements that are under stress at time 0. docs/theory/materials.md (M46), (M47)
#include "fe/element_block.hpp"

namespace brunt {

/// Gives the elements of a block that are measured, and otherwise at rest, the stress block.stress:
/// state, volumes free of stress, masses and energies. Throws InitialStressError.
template <int Dim>
void begin_under_stress(const Points<Dim>& points, ElementBlock<Dim>& block);

/// Sets the ratio [1] of the volume about each node of such a block, whose pressure is of volumes
/// about nodes, to that free of stress: the pressure is exact at the nodes.
template <int Dim>
void find_node_ratios(const Points<Dim>& points, const ElementBlock<Dim>& block,
                      std::vector<Real>& ratio);

}  // namespace brunt
// Tested by tests/verification/initial_stress_test.cpp.
