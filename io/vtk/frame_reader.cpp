#include "io/vtk/frame_reader.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <stdexcept>

#include "core/errors.hpp"
#include "io/vtk/grid.hpp"
#include "io/vtk/messages.hpp"

namespace brunt {

namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& what) {
  throw MachineError("cannot read '" + path.string() + "': " + what);
}

/// What the VTK reader makes of a file; it must be there and nothing may be said about it.
template <class Reader>
vtkSmartPointer<Reader> read(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) fail(path, "no such file");
  VtkMessages messages;
  auto reader = vtkSmartPointer<Reader>::New();
  reader->SetFileName(path.c_str());
  reader->Update();
  if (messages.any()) fail(path, messages.text());
  return reader;
}

std::vector<Real> cell_values(vtkPolyData& data, const char* name, int components) {
  auto* array = data.GetCellData()->GetArray(name);
  std::vector<Real> values;
  if (array == nullptr || array->GetNumberOfComponents() != components) return values;
  for (vtkIdType t = 0; t < array->GetNumberOfTuples(); ++t) {
    for (int c = 0; c < components; ++c) values.push_back(array->GetComponent(t, c));
  }
  return values;
}

std::vector<Label> cell_labels(vtkPolyData& data, const char* name) {
  std::vector<Label> labels;
  for (const Real value : cell_values(data, name, 1)) labels.push_back(static_cast<Label>(value));
  return labels;
}

ContactView to_contact_view(vtkPolyData& data) {
  ContactView view;
  vtkIdType n = 0;
  const vtkIdType* corners = nullptr;
  std::array<Real, 3> x;
  for (vtkIdType cell = 0; cell < data.GetNumberOfCells(); ++cell) {
    data.GetCellPoints(cell, n, corners);
    view.polygon_size.push_back(static_cast<int>(n));
    for (vtkIdType c = 0; c < n; ++c) {
      data.GetPoint(corners[c], x.data());
      view.position.insert(view.position.end(), x.begin(), x.end());
    }
  }
  view.normal = cell_values(data, "normal", 3);
  view.pressure = cell_values(data, "pressure", 1);
  view.penetration = cell_values(data, "penetration", 1);
  view.force = cell_values(data, "force", 3);
  view.body_a = cell_labels(data, "body_a");
  view.body_b = cell_labels(data, "body_b");
  return view;
}

}  // namespace

std::vector<BodyView> read_frame(const std::filesystem::path& folder, const FrameEntry& frame) {
  std::vector<BodyView> bodies;
  for (const auto& part : frame.parts) {
    const auto path = folder / part.file;
    if (path.extension() != ".vtu") continue;
    const auto reader = read<vtkXMLUnstructuredGridReader>(path);
    try {
      bodies.push_back(to_view(*reader->GetOutput(), part.name));
    } catch (const std::invalid_argument& error) {
      fail(path, error.what());
    }
    bodies.back().time = frame.time;
  }
  return bodies;
}

ContactView read_contacts(const std::filesystem::path& folder, const FrameEntry& frame) {
  for (const auto& part : frame.parts) {
    const auto path = folder / part.file;
    if (path.extension() != ".vtp") continue;
    return to_contact_view(*read<vtkXMLPolyDataReader>(path)->GetOutput());
  }
  return {};
}

}  // namespace brunt
