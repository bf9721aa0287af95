#pragma once
#include "core/elements/product_shape.hpp"

namespace brunt {

/// Hexahedron, corners of the bottom counter-clockwise seen from above, then those of the top.
/// Modes: xi, eta, zeta | eta zeta, zeta xi, xi eta, xi eta zeta | 1.
struct Hex8 {
  static constexpr const char* kName = "hex8";
  static constexpr int kDim = 3;
  static constexpr int kCorners = 8;
  static constexpr int kActive = 6;
  static constexpr int kHourglass = 4;
  static constexpr int kModes = 8;
  static constexpr int kGauss = 8;
  static constexpr std::array<std::array<int, 4>, 6> kFace = {
      {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
  static constexpr std::array<int, 6> kOpposite = {1, 0, 4, 5, 2, 3};
  static constexpr LocalPlace kCenter = {0, 0, 0};
  static constexpr Real kHeightSquare = 0.5;
  static constexpr Real kDepth = 1;  ///< height over a face: V/A
  static constexpr Real kSign[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                                       {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};

  static constexpr std::array<Real, 8> mode_values(const std::array<Real, 3>& at) {
    const Real x = at[0], y = at[1], z = at[2];
    return {x, y, z, y * z, z * x, x * y, x * y * z, 1};
  }
  static constexpr std::array<std::array<Real, 3>, 7> mode_slopes(const std::array<Real, 3>& at) {
    const Real x = at[0], y = at[1], z = at[2];
    return {
        {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, z, y}, {z, 0, x}, {y, x, 0}, {y * z, z * x, x * y}}};
  }
  static constexpr int beside(int I, int j) {
    return j == 2 ? (I + 4) % 8 : I / 4 * 4 + (j == 0 ? I % 4 ^ 1 : 3 - I % 4);
  }

  static constexpr void shape(const LocalPlace& at, ShapeValues& out) {
    product_shape<Hex8>(at, out);
  }
  static constexpr bool snap(LocalPlace& at, Real slack) { return snap_to_box(at, slack, kDim); }
};

}  // namespace brunt
// Tested by tests/unit/fe/kinematics_test.cpp.
