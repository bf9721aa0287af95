#pragma once
#include <bit>
#include <cstddef>
#include <string>
#include <vector>

#include "core/view.hpp"

namespace brunt {

/// How fields at a place within a body follow from those of its points and cells: weights of time
/// 0, which stay with the material.
struct Place {
  std::vector<std::size_t> points;  ///< of the view
  std::vector<Real> weights;        ///< [1] of them; their sum is 1
  /// Axes across which each is reflected, a bit each: near planes of symmetry particles have
  /// images.
  std::vector<unsigned> reflected;
  std::size_t cell = 0;     ///< of the view, where it has cells
  Real point_distance = 0;  ///< [m] outside: of the nearest point, which is then alone
  Real cell_distance = 0;   ///< [m] outside: of the centre of the nearest cell
};

/// The place `at` [m] in a view at time 0. In an element: its shape functions there (inverse of the
/// bi- or trilinear map by Newton's method), and the element. Among particles: moving least squares
/// with linear terms over those within two spacings (Lancaster & Salkauskas 1981), and over their
/// images. Both are exact
/// for fields that are linear in space. Elsewhere: the nearest point, and the cell whose centre is
/// nearest.
Place find_place(const BodyView& start, const std::vector<Real>& at);

/// Axes across which a field such as "velocity.x" or "stress.xy" changes its sign in a mirror, a
/// bit each.
unsigned odd_axes(const std::string& field);

/// 1 or -1 of a field in a mirror image.
inline Real sign_in_image(unsigned odd, unsigned reflected) {
  return std::popcount(odd & reflected) % 2 == 0 ? 1 : -1;
}

/// Value of a field there, from values of points or cells.
/// odd  odd_axes of the field
Real value_at(const Place& place, const std::vector<Real>& values, bool of_cells, unsigned odd = 0);

}  // namespace brunt
