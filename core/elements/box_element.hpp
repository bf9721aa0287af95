#pragma once
#include <type_traits>

#include "core/elements/hex8.hpp"
#include "core/elements/quad4.hpp"

namespace brunt {

/// The element that is a product of lines: what meshes are made of, and what modal kernels compute.
template <int Dim>
using Shape = std::conditional_t<Dim == 2, Quad4, Hex8>;

/// The places of the 2^Dim Gauss points, in the order of the corners; their weights are 1.
template <int Dim>
constexpr std::array<Real, Dim> gauss_place(int g) {
  constexpr Real kAbscissa = 0.57735026918962576451;
  std::array<Real, Dim> at{};
  for (int j = 0; j < Dim; ++j) at[j] = kAbscissa * Shape<Dim>::kSign[g][j];
  return at;
}

}  // namespace brunt
// Tested by tests/unit/fe/kinematics_test.cpp.
