#include "io/vtk/grid.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <optional>
#include <stdexcept>

namespace brunt {

namespace {

constexpr std::array kTensorNames = {"XX", "YY", "ZZ", "XY", "YZ", "ZX"};
constexpr std::array kVectorNames = {"X", "Y", "Z"};
constexpr std::array kWholeFields = {"id", "piece", "rank"};
}  // namespace

bool is_whole_field(const std::string& name) {
  return std::find(kWholeFields.begin(), kWholeFields.end(), name) != kWholeFields.end();
}

const char* component_name(int components, int component) {
  const auto c = slot_of(component);
  return components == 6 ? kTensorNames[c] : kVectorNames[c];
}

unsigned char vtk_cell_type(int corners, int dimension) {
  switch (corners) {
    case 1:
      return VTK_VERTEX;
    case 2:
      return VTK_LINE;
    case 3:
      return VTK_TRIANGLE;
    case 4:
      return dimension == 3 ? VTK_TETRA : VTK_QUAD;
    case 6:
      return VTK_WEDGE;
    case 8:
      return VTK_HEXAHEDRON;
    default:
      throw std::invalid_argument("view: cells of " + std::to_string(corners) + " corners");
  }
}

void misfit(const std::string& what) {
  throw std::invalid_argument("view: " + what + " has the wrong length");
}

std::vector<std::size_t> polydata_order(const ContactView& view) {
  std::array<std::vector<std::size_t>, 3> orders;
  for (std::size_t i = 0; i < view.polygon_size.size(); ++i) {
    orders[std::clamp(view.polygon_size[i], 1, 3) - 1].push_back(i);
  }
  std::vector<std::size_t> order;
  for (const auto& part : orders) order.insert(order.end(), part.begin(), part.end());
  return order;
}

Field reordered(const std::string& name, int components, const std::vector<Real>& values,
                const std::vector<std::size_t>& order) {
  const auto n = slot_of(components);
  if (values.size() != order.size() * n) misfit("contact field " + name);
  Field field{name, components, {}};
  for (const std::size_t i : order) {
    for (std::size_t c = 0; c < n; ++c) field.values.push_back(values[i * n + c]);
  }
  return field;
}

namespace {

vtkSmartPointer<vtkDataArray> to_array(const Field& field, std::size_t n) {
  const auto components = slot_of(field.components);
  if (field.values.size() != n * components) misfit("field " + field.name);
  vtkSmartPointer<vtkDataArray> array;
  if (is_whole_field(field.name)) {
    array = vtkSmartPointer<vtkIdTypeArray>::New();
  } else {
    array = vtkSmartPointer<vtkFloatArray>::New();
  }
  array->SetName(field.name.c_str());
  array->SetNumberOfComponents(field.components);
  for (int c = 0; c < field.components && field.components > 1; ++c) {
    array->SetComponentName(c, component_name(field.components, c));
  }
  array->SetNumberOfTuples(static_cast<vtkIdType>(n));
  if (auto* singles = vtkFloatArray::SafeDownCast(array)) {
    std::transform(field.values.begin(), field.values.end(), singles->GetPointer(0), single_of);
  } else {
    auto* whole = static_cast<vtkIdTypeArray*>(array.Get())->GetPointer(0);
    std::transform(field.values.begin(), field.values.end(), whole,
                   [](Real value) { return static_cast<vtkIdType>(value); });
  }
  return array;
}

/// In double, as the time: they may be far from the origin.
vtkSmartPointer<vtkDoubleArray> to_doubles(const char* name, int components,
                                           const std::vector<Real>& values) {
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()) / components);
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  return array;
}

vtkSmartPointer<vtkPoints> to_points(const std::vector<Real>& position) {
  if (position.size() % 3 != 0) misfit("position");
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetData(to_doubles("Points", 3, position));
  return points;
}

void set_time(vtkDataObject& object, Real time) {
  object.GetFieldData()->AddArray(to_doubles("TimeValue", 1, {time}));
}

/// Cells of `corners` each, with triangles among quads; particles are one vertex a point.
void set_cells(const BodyView& view, std::size_t n_points, vtkUnstructuredGrid& grid) {
  std::vector<std::int64_t> connectivity = view.connectivity;
  if (view.corners == 0) {
    connectivity.resize(n_points);
    std::iota(connectivity.begin(), connectivity.end(), 0);
  }
  const auto corners = slot_of(std::max(view.corners, 1));
  if (connectivity.size() % corners != 0) misfit("connectivity");
  auto types = vtkSmartPointer<vtkUnsignedCharArray>::New();
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->AllocateExact(static_cast<vtkIdType>(connectivity.size() / corners),
                       static_cast<vtkIdType>(connectivity.size()));
  for (std::size_t first = 0; first < connectivity.size(); first += corners) {
    std::array<vtkIdType, 8> cell{};
    int n = 0;
    for (std::size_t c = first; c < first + corners; ++c) {
      const auto point = connectivity[c];
      const bool fourth = corners == 4 && view.cell_dimension != 3 && c == first + 3;
      if (fourth && (point < 0 || point == connectivity[c - 1])) continue;  // a triangle
      if (point < 0 || point >= static_cast<std::int64_t>(n_points)) misfit("connectivity");
      cell[n++] = point;
    }
    cells->InsertNextCell(n, cell.data());
    types->InsertNextValue(vtk_cell_type(n, view.cell_dimension));
  }
  grid.SetCells(types, cells);
}

Field to_field(vtkDataArray& array) {
  Field field{array.GetName() ? array.GetName() : "", array.GetNumberOfComponents(), {}};
  const auto components = slot_of(field.components);
  field.values.resize(slot_of(array.GetNumberOfTuples()) * components);
  for (vtkIdType t = 0; t < array.GetNumberOfTuples(); ++t) {
    array.GetTuple(t, field.values.data() + slot_of(t) * components);
  }
  return field;
}

std::vector<Field> to_fields(vtkFieldData& data) {
  std::vector<Field> fields;
  for (int a = 0; a < data.GetNumberOfArrays(); ++a) {
    if (auto* array = data.GetArray(a)) fields.push_back(to_field(*array));
  }
  return fields;
}

/// Takes a field out of a list; nothing where it is not there.
std::optional<Field> take_field(std::vector<Field>& fields, const char* name) {
  const auto at = std::find_if(fields.begin(), fields.end(),
                               [name](const Field& field) { return field.name == name; });
  if (at == fields.end()) return std::nullopt;
  std::optional<Field> field = std::move(*at);
  fields.erase(at);
  return field;
}

bool is_volume(int type) {
  return type == VTK_TETRA || type == VTK_WEDGE || type == VTK_HEXAHEDRON;
}

int corners_of(vtkUnstructuredGrid& grid) {
  vtkIdType most = 0;
  for (vtkIdType c = 0; c < grid.GetNumberOfCells(); ++c) {
    const auto n = grid.GetCells()->GetCellSize(c);
    const int dimension = is_volume(grid.GetCellType(c)) ? 3 : 2;
    if (n > 8 || vtk_cell_type(static_cast<int>(n), dimension) != grid.GetCellType(c)) {
      throw std::invalid_argument("cell " + std::to_string(c) + " is none that brunt writes");
    }
    most = std::max(most, n);
  }
  return most == 1 ? 0 : static_cast<int>(most);
}

}  // namespace

vtkSmartPointer<vtkUnstructuredGrid> to_grid(const BodyView& view) {
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(to_points(view.position));
  const auto n_points = slot_of(grid->GetNumberOfPoints());
  set_cells(view, n_points, *grid);
  const auto n_cells = slot_of(grid->GetNumberOfCells());
  for (const auto& field : view.point_fields) {
    grid->GetPointData()->AddArray(to_array(field, n_points));
  }
  for (const auto& field : view.cell_fields) {
    grid->GetCellData()->AddArray(to_array(field, n_cells));
  }
  const bool no_particles = view.corners == 0 && n_points == 0 && !view.point_fields.empty();
  if (!view.point_radius.empty() || no_particles) {
    grid->GetPointData()->AddArray(to_array({"radius", 1, view.point_radius}, n_points));
  }
  set_time(*grid, view.time);
  return grid;
}

BodyView to_view(vtkUnstructuredGrid& grid, const std::string& body) {
  BodyView view;
  view.body = body;
  if (auto* time = grid.GetFieldData()->GetArray("TimeValue")) view.time = time->GetComponent(0, 0);
  if (grid.GetNumberOfPoints() > 0) view.position = to_field(*grid.GetPoints()->GetData()).values;
  view.corners = corners_of(grid);
  if (grid.GetNumberOfCells() > 0 && is_volume(grid.GetCellType(0))) view.cell_dimension = 3;
  view.point_fields = to_fields(*grid.GetPointData());
  view.cell_fields = to_fields(*grid.GetCellData());
  if (const auto ghosts = take_field(view.point_fields, vtkDataSetAttributes::GhostArrayName())) {
    for (const Real type : ghosts->values) view.point_owned.push_back(type == 0);
  }
  if (auto radius = take_field(view.point_fields, "radius")) {
    view.point_radius = std::move(radius->values);
  }
  if (view.corners == 0) return view;
  for (vtkIdType c = 0; c < grid.GetNumberOfCells(); ++c) {
    vtkIdType n = 0;
    const vtkIdType* points = nullptr;
    grid.GetCells()->GetCellAtId(c, n, points);
    for (vtkIdType k = 0; k < view.corners; ++k) {
      view.connectivity.push_back(k < n ? points[k] : -1);
    }
  }
  return view;
}

}  // namespace brunt
// Tested by tests/unit/io/vtk_test.cpp.
