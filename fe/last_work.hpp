#pragma once
/// Elements that go, as a block of their own: what their forces at n take in the step under way.
#include "fe/element_step.hpp"
#include "fe/erosion.hpp"

namespace brunt {

/// The one with an id among those that go, by ascending id; it is there.
std::vector<ErodedElement>::iterator place_among(std::vector<ErodedElement>& going, GlobalId id);
bool is_among(const std::vector<ErodedElement>& going, GlobalId id);

/// Those of the elements of a block that go.
template <int Dim>
ElementSet<Dim> set_of(const ElementBlock<Dim>& block, const std::vector<ErodedElement>& going);

/// Copies the rows of elements that are in both. Padding repeats the last element.
template <int Dim>
void copy_state(const ElementBlock<Dim>& from, ElementBlock<Dim>& to);

/// What half of the old forces takes in a step [J], of each element of a block without books, which
/// takes the step; the half of the new ones is taken out again.
template <int Dim>
std::vector<Real> taken_in_step(ElementBlock<Dim>& block, ElementStep<Dim>& step);

}  // namespace brunt
// Tested by tests/unit/fe/erosion_test.cpp.
