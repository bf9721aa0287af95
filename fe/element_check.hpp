#pragma once
#include <optional>
#include <string>

#include "core/errors.hpp"
#include "fe/element_block.hpp"

namespace brunt {

/// What is wrong with an element, which names its Gauss point, from 1, where it has several; none
/// where nothing is. Its value is finite where that of the element's state is.
template <int Dim>
std::optional<PhysicsFailure> element_failure(const ElementBlock<Dim>& block, LocalIndex e,
                                              const Points<Dim>& points,
                                              const Thickness& thickness);

/// What may help where an element of this block is crushed, sheared or turned inside out: what its
/// options leave open, and nothing that is on already.
template <int Dim>
std::string distortion_advice(const ElementBlock<Dim>& block);

/// True where all stresses of an element are numbers: with volume everywhere
/// (Formulation::have_volume) it has not failed.
template <int Dim>
bool has_finite_stress(const ElementBlock<Dim>& block, LocalIndex e);

}  // namespace brunt
