#pragma once
#include <cstddef>
#include <vector>

#include "core/view.hpp"

namespace brunt {

/// How fields at a place within a body follow from those of its points and cells: weights of time
/// 0, which stay with the material.
struct Place {
  std::vector<std::size_t> points;  ///< of the view
  std::vector<Real> weights;        ///< [1] of them; their sum is 1
  std::size_t cell = 0;             ///< of the view, where it has cells
  Real point_distance = 0;          ///< [m] outside: of the nearest point, which is then alone
  Real cell_distance = 0;           ///< [m] outside: of the centre of the nearest cell
};

/// The place `at` [m] in a view at time 0. In an element: its shape functions there (inverse of the
/// bi- or trilinear map by Newton's method), and the element. Among particles: moving least squares
/// with linear terms over those within two spacings (Lancaster & Salkauskas 1981). Both are exact
/// for fields that are linear in space. Elsewhere: the nearest point, and the cell whose centre is
/// nearest.
Place find_place(const BodyView& start, const std::vector<Real>& at);

/// Value of a field there, from values of points or cells.
Real value_at(const Place& place, const std::vector<Real>& values, bool of_cells);

}  // namespace brunt
