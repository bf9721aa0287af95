#pragma once
#include "fe/formulation.hpp"

namespace brunt {

/// Tetrahedron; corner 3 sees corners 0, 1, 2 counter-clockwise. Local coordinates are the shape
/// functions of corners 1, 2, 3.
struct Tet4 {
  static constexpr const char* kName = "tet4";
  static constexpr int kDim = 3;
  static constexpr int kCorners = 4;
  static constexpr int kHourglass = 0;
  static constexpr std::array<std::array<int, 3>, 4> kFace = {
      {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  static constexpr std::array<int, 4> kOpposite = {-1, -1, -1, -1};
  static constexpr LocalPlace kCenter = {0.25, 0.25, 0.25};
  /// A height h = 1/|grad N| has an eigenvalue of 4/3 h^-2 at least: the gradients sum to none.
  static constexpr Real kHeightSquare = 4.0 / 3;
  static constexpr Real kDepth = 3;

  static constexpr void shape(const LocalPlace& at, ShapeValues& out) {
    out.value = {1 - at[0] - at[1] - at[2], at[0], at[1], at[2]};
    out.slope = {{{-1, -1, -1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  }
  static constexpr bool snap(LocalPlace& at, Real slack) {
    if (1 - at[0] - at[1] - at[2] < -slack) return false;
    for (Real& N : at) {
      if (N < -slack) return false;
      if (N < slack) N = 0;
    }
    return true;
  }
};

/// One material point; the pressure is that of the mean volume about its nodes (Bonet & Burton
/// 1998), so that it does not lock in volume.
const Formulation<3>& formulation(Tet4);

}  // namespace brunt
