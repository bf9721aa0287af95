#pragma once
/// brunt's plain views as VTK data sets and back; for io/vtk only.
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <limits>

#include "core/view.hpp"

namespace brunt {

/// The body with all its fields: particles as vertices, cells by their number of corners (a quad
/// whose fourth corner is -1 or repeats the third is a triangle). Adds the point array "radius" [m]
/// for particles and the field data "TimeValue" [s]. Tensors have named components. Throws
/// std::invalid_argument where a field's length does not fit.
vtkSmartPointer<vtkUnstructuredGrid> to_grid(const BodyView& view);

/// Contacts in the order of the cell data of a polydata: vertices, lines (planes in 2D), polygons.
std::vector<std::size_t> polydata_order(const ContactView& view);
/// Values of contacts in that order. Throws std::invalid_argument where their number does not fit.
Field reordered(const std::string& name, int components, const std::vector<Real>& values,
                const std::vector<std::size_t>& order);
[[noreturn]] void misfit(const std::string& what);

/// VTK's type of a cell. dimension  3: four corners are a tetrahedron; else a quad. Throws
/// std::invalid_argument where there is none.
unsigned char vtk_cell_type(int corners, int dimension);
/// True where a field holds whole numbers: written as such.
bool is_whole_field(const std::string& name);
/// A number as frames have it: single, the largest there is where it is larger.
inline float single_of(Real value) {
  constexpr Real kMost = std::numeric_limits<float>::max();
  return static_cast<float>(std::clamp(value, -kMost, kMost));  // of not-a-number itself
}
/// "X", "YZ": of a vector or a tensor.
const char* component_name(int components, int component);

/// The view of which a .vtu was written: masses and volumes are not in it. Throws
/// std::invalid_argument where the grid holds other cells than to_grid makes.
BodyView to_view(vtkUnstructuredGrid& grid, const std::string& body);

}  // namespace brunt
// Tested by tests/unit/io/vtk_test.cpp.
