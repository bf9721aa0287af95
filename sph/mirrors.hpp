#pragma once
/// Planes of symmetry of particles: what their sums see beyond a plane is the mirror image of what
/// lies before it. docs/theory/sph.md, section 14.
#include <array>
#include <cstddef>
#include <vector>

#include "core/types.hpp"
#include "sph/records.hpp"

namespace brunt {

/// Axes across which something is reflected, a bit each.
using MirrorAxes = unsigned;

constexpr bool is_across(MirrorAxes axes, int axis) { return ((axes >> axis) & 1U) != 0; }

/// Which planes there are, one across an axis at most, and which sums of particles lie on them.
template <int Dim>
struct Mirrors {
  struct Sum {
    Label sum = 0;
    Real side = 0;  ///< 1: it lies above the plane, -1: below
    auto operator<=>(const Sum&) const = default;
  };
  struct Plane {
    Real at = 0;            ///< [m] its place, from the origin of the positions
    std::vector<Sum> sums;  ///< that lie on it, ascending
  };
  std::array<Plane, Dim> plane;

  bool any() const;
  /// The planes that a sum lies on.
  MirrorAxes across(Label sum) const;
  /// [m] from the plane across an axis, on the side of the sum; `sum` lies on it.
  Real distance(const Vec<Dim>& x, int axis, Label sum) const;
  Vec<Dim> reflected(Vec<Dim> x, MirrorAxes axes) const {
    for (int c = 0; c < Dim; ++c) {
      if (is_across(axes, c)) x[c] = 2 * plane[slot_of(c)].at - x[c];
    }
    return x;
  }
};

/// The image of a particle.
struct MirrorImage {
  LocalIndex of = 0;  ///< place of the particle
  MirrorAxes axes = 0;
};

/// Components of a vector that lie across the planes change their sign.
template <int Dim>
void reflect_vector(MirrorAxes axes, Real* vector) {
  for (int c = 0; c < Dim; ++c) {
    if (is_across(axes, c)) vector[c] = -vector[c];
  }
}

/// R m R of a matrix, by rows.
template <int Dim>
void reflect_matrix(MirrorAxes axes, Real* matrix) {
  for (int a = 0; a < Dim; ++a) {
    for (int b = 0; b < Dim; ++b) {
      if (is_across(axes, a) != is_across(axes, b)) matrix[Dim * a + b] = -matrix[Dim * a + b];
    }
  }
}

/// The same of a symmetric one, as records have it.
template <int Dim>
void reflect_symmetric(MirrorAxes axes, Real* tensor) {
  for (int a = 0; a < Dim; ++a) {
    for (int b = a + 1; b < Dim; ++b) {
      Real& shear = tensor[symmetric_place<Dim>(a, b)];
      if (is_across(axes, a) != is_across(axes, b)) shear = -shear;
    }
  }
}

}  // namespace brunt
// Tested by tests/unit/sph/mirrors_test.cpp.
