#pragma once
/// Shape functions of elements, and those that are products of (1 +- xi_j)/2.
#include <array>

#include "core/types.hpp"

namespace brunt {

inline constexpr int kMostCorners = 8;  ///< of an element of any kind
inline constexpr int kMostFaces = 6;

using LocalPlace = std::array<Real, 3>;  ///< xi; in 2D the third is not read
/// N_I and d N_I/d xi_j at a place, of as many corners as the element has.
struct ShapeValues {
  std::array<Real, kMostCorners> value{};
  std::array<std::array<Real, 3>, kMostCorners> slope{};
};

template <class Element>
constexpr void product_shape(const LocalPlace& at, ShapeValues& out) {
  for (std::size_t I = 0; I < Element::kCorners; ++I) {
    out.value[I] = 1;
    out.slope[I] = {1, 1, 1};
    for (std::size_t k = 0; k < Element::kDim; ++k) {
      const Real factor = 0.5 * (1 + Element::kSign[I][k] * at[k]);
      out.value[I] *= factor;
      for (std::size_t j = 0; j < Element::kDim; ++j) {
        out.slope[I][j] *= j == k ? 0.5 * Element::kSign[I][k] : factor;
      }
    }
  }
}

/// False where the place lies outside of [-1, 1]^dim by more than slack; what lies within slack of
/// a face is moved onto it.
constexpr bool snap_to_box(LocalPlace& at, Real slack, int dim) {
  for (std::size_t j = 0; j < slot_of(dim); ++j) {
    const Real beyond = (at[j] < 0 ? -at[j] : at[j]) - 1;
    if (beyond > slack) return false;
    if (beyond > -slack) at[j] = at[j] > 0 ? 1 : -1;
  }
  return true;
}

}  // namespace brunt
// Tested by tests/unit/fe/kinematics_test.cpp.
