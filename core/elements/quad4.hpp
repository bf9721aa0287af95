#pragma once
#include "core/elements/product_shape.hpp"

namespace brunt {

/// Quadrilateral, corners counter-clockwise. Modes: xi, eta | xi eta | 1.
struct Quad4 {
  static constexpr const char* kName = "quad4";
  static constexpr int kDim = 2;
  static constexpr int kCorners = 4;
  static constexpr int kActive = 2;     ///< leading modes whose E does not vanish (fe/shape.hpp)
  static constexpr int kHourglass = 1;  ///< modes after the first Dim that are not constant
  static constexpr int kModes = 4;      ///< all, the constant one last
  static constexpr int kGauss = 4;
  /// Corners of each face such that its normal points outwards (see Facet).
  static constexpr std::array<std::array<int, 2>, 4> kFace = {{{0, 1}, {1, 2}, {2, 3}, {3, 0}}};
  static constexpr std::array<int, 4> kOpposite = {2, 3, 0, 1};  ///< the face across from each
  static constexpr LocalPlace kCenter = {0, 0, 0};
  /// Square of the least height times the largest eigenvalue of sum grad N_I (x) grad N_I, of the
  /// mean gradients.
  static constexpr Real kHeightSquare = 1;
  static constexpr Real kDepth = 1;  ///< height over a face: A/length
  /// Local coordinates of the corners.
  static constexpr Real kSign[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};

  static constexpr std::array<Real, 4> mode_values(const std::array<Real, 2>& at) {
    return {at[0], at[1], at[0] * at[1], 1};
  }
  /// d phi_m / d xi_j at a local place, [mode][j]; the constant mode is left out.
  static constexpr std::array<std::array<Real, 2>, 3> mode_slopes(const std::array<Real, 2>& at) {
    return {{{1, 0}, {0, 1}, {at[1], at[0]}}};
  }
  /// The corner beside I along the local axis j.
  static constexpr int beside(int I, int j) { return j == 0 ? I ^ 1 : 3 - I; }

  static constexpr void shape(const LocalPlace& at, ShapeValues& out) {
    product_shape<Quad4>(at, out);
  }
  static constexpr bool snap(LocalPlace& at, Real slack) { return snap_to_box(at, slack, kDim); }
};

}  // namespace brunt
// Tested by tests/unit/fe/kinematics_test.cpp.
