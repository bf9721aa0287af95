#pragma once
/// Mass that lengthens the step: elements whose stable step is short get so much of it that their
/// step is the wanted one, once, at time 0. docs/theory/elements.md section 10.
#include "core/solid.hpp"
#include "fe/element_step.hpp"

namespace brunt {

/// Makes elements of a block heavier whose stable step, at rest and without stress, is shorter than
/// its options' least_step: by (least_step/step)^2, since the step goes with the root of the mass.
/// Heat is stored in the mass of the material alone.
/// step  at the positions of time 0, without velocities; of any dt
template <int Dim>
void scale_masses(ElementBlock<Dim>& block, const ElementStep<Dim>& step);

/// Of the elements of a body that are counted here.
template <int Dim>
AddedMass added_mass(const std::vector<ElementBlock<Dim>>& blocks, Label body);

}  // namespace brunt
// Tested by tests/unit/fe/mass_scaling_test.cpp.
