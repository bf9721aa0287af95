#include "io/vtk/vtu_mesh.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <stdexcept>

#include "io/vtk/messages.hpp"

namespace brunt {

namespace {
std::optional<CellKind> vtu_kind(int type) {
  using enum CellKind;
  switch (type) {
    case VTK_VERTEX:
      return point1;
    case VTK_LINE:
      return line2;
    case VTK_TRIANGLE:
      return tri3;
    case VTK_QUAD:
    case VTK_PIXEL:
      return quad4;
    case VTK_TETRA:
      return tet4;
    case VTK_PYRAMID:
      return pyramid5;
    case VTK_WEDGE:
      return wedge6;
    case VTK_HEXAHEDRON:
    case VTK_VOXEL:
      return hex8;
    case VTK_QUADRATIC_EDGE:
    case VTK_LAGRANGE_CURVE:
      return higher1;
    case VTK_QUADRATIC_TRIANGLE:
    case VTK_QUADRATIC_QUAD:
    case VTK_BIQUADRATIC_QUAD:
    case VTK_LAGRANGE_TRIANGLE:
    case VTK_LAGRANGE_QUADRILATERAL:
      return higher2;
    case VTK_QUADRATIC_TETRA:
    case VTK_QUADRATIC_HEXAHEDRON:
    case VTK_QUADRATIC_WEDGE:
    case VTK_QUADRATIC_PYRAMID:
    case VTK_TRIQUADRATIC_HEXAHEDRON:
    case VTK_LAGRANGE_TETRAHEDRON:
    case VTK_LAGRANGE_HEXAHEDRON:
    case VTK_LAGRANGE_WEDGE:
      return higher3;
    default:
      return std::nullopt;
  }
}

/// The things of each value of an array; none where it is no array of few whole numbers.
std::map<std::int64_t, std::vector<int>> by_value(vtkDataArray& array, std::size_t count) {
  constexpr std::size_t kMost = 256;
  std::map<std::int64_t, std::vector<int>> things;
  const auto n = static_cast<std::size_t>(array.GetNumberOfTuples());
  if (array.GetNumberOfComponents() != 1 || n != count) return things;
  for (std::size_t i = 0; i < n; ++i) {
    const Real value = array.GetComponent(static_cast<vtkIdType>(i), 0);
    if (!(std::fabs(value) < 1e15) || value != std::floor(value)) return {};
    things[static_cast<std::int64_t>(value)].push_back(static_cast<int>(i));
    if (things.size() > kMost) return {};
  }
  return things;
}

void add_cells(vtkUnstructuredGrid& grid, MeshFile& mesh) {
  vtkNew<vtkIdList> ids;
  const vtkIdType n_points = grid.GetNumberOfPoints();
  for (vtkIdType c = 0; c < grid.GetNumberOfCells(); ++c) {
    const std::string name = "cell " + std::to_string(c);
    const int type = grid.GetCellType(c);
    const auto kind = vtu_kind(type);
    if (!kind) {
      throw std::runtime_error(mesh.path + ": " + name + " is of VTK's type " +
                               std::to_string(type) + ", which is not known");
    }
    grid.GetCells()->GetCellAtId(c, ids);
    std::array<std::int64_t, 8> corner{};
    const auto corners = static_cast<std::size_t>(info(*kind).corners);
    if (corners > 0 && static_cast<std::size_t>(ids->GetNumberOfIds()) != corners) {
      throw std::runtime_error(mesh.path + ": " + name + " has " +
                               std::to_string(ids->GetNumberOfIds()) + " corners, and its type " +
                               std::to_string(corners));
    }
    for (std::size_t k = 0; k < corners; ++k) corner[k] = ids->GetId(static_cast<vtkIdType>(k));
    for (std::size_t k = 0; k < corners; ++k) {
      if (corner[k] >= 0 && corner[k] < n_points) continue;
      throw std::runtime_error(mesh.path + ": " + name + " has point " + std::to_string(corner[k]) +
                               ", and there are " + std::to_string(n_points));
    }
    // Pixels and voxels run along the axes, not round.
    if (type == VTK_PIXEL || type == VTK_VOXEL) std::swap(corner[2], corner[3]);
    if (type == VTK_VOXEL) std::swap(corner[6], corner[7]);
    mesh.add_cell(*kind, c, {corner.data(), corners});
  }
}
}  // namespace

MeshFile read_vtu(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) {
    throw std::runtime_error(path + ": there is no such file");
  }
  const VtkMessages messages;
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  if (messages.any()) throw std::runtime_error(path + ": " + messages.text());
  vtkUnstructuredGrid& grid = *reader->GetOutput();
  MeshFile mesh;
  mesh.path = path;
  for (vtkIdType i = 0; i < grid.GetNumberOfPoints(); ++i) {
    const double* x = grid.GetPoint(i);
    mesh.add_node(i, Vec3(x[0], x[1], x[2]));
  }
  if (mesh.nodes.empty()) throw std::runtime_error(path + ": there is no point in it");
  if (grid.GetNumberOfCells() == 0) throw std::runtime_error(path + ": there is no cell in it");
  add_cells(grid, mesh);
  mesh.resolve_corners();
  const auto add_sets = [&](vtkDataSetAttributes& data, std::size_t count, bool of_cells) {
    for (int a = 0; a < data.GetNumberOfArrays(); ++a) {
      vtkDataArray* array = data.GetArray(a);
      if (array == nullptr || array->GetName() == nullptr) continue;
      for (auto& [value, things] : by_value(*array, count)) {
        MeshSet& set = mesh.set(std::string(array->GetName()) + " " + std::to_string(value));
        (of_cells ? set.cells : set.nodes) = std::move(things);
      }
    }
  };
  add_sets(*grid.GetCellData(), mesh.n_cells(), true);
  add_sets(*grid.GetPointData(), mesh.nodes.size(), false);
  return mesh;
}

}  // namespace brunt
