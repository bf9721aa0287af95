#include "io/vtk/frame_reader.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkXMLPPolyDataReader.h>
#include <vtkXMLPUnstructuredGridReader.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "core/errors.hpp"
#include "core/merge_views.hpp"
#include "io/file.hpp"
#include "io/vtk/grid.hpp"
#include "io/vtk/messages.hpp"
#include "io/vtk/pieces.hpp"

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

/// All pieces that a file joins, each after the other.
template <class Reader>
vtkSmartPointer<Reader> read_joined(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) fail(path, "no such file");
  for (const auto& file : joined_files(read_file(path), path.string())) {
    const auto piece = path.parent_path() / file;
    if (!std::filesystem::is_regular_file(piece, error)) fail(piece, "no such file");
  }
  return read<Reader>(path);
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
  view.bonded = cell_values(data, "bonded", 1);
  view.max_closure = cell_values(data, "max_closure", 1);
  view.force = cell_values(data, "force", 3);
  view.body_a = cell_labels(data, "body_a");
  view.body_b = cell_labels(data, "body_b");
  const auto keys = cell_values(data, "key", 4);
  for (std::size_t k = 0; k < keys.size(); k += 4) {
    auto& key = view.key.emplace_back();
    for (std::size_t c = 0; c < 4; ++c) key[c] = static_cast<GlobalId>(keys[k + c]);
  }
  return view;
}

void append(std::vector<Real>& to, const std::vector<Real>& from, std::size_t first,
            std::size_t count) {
  const auto at = from.begin() + static_cast<std::ptrdiff_t>(first);
  to.insert(to.end(), at, at + static_cast<std::ptrdiff_t>(count));
}

/// Contacts of several pieces in the order in which a lone rank writes them: points, lines,
/// polygons, each by their keys.
ContactView in_order(const ContactView& all) {
  std::vector<std::size_t> order(all.key.size()), first(all.key.size() + 1, 0);
  std::iota(order.begin(), order.end(), 0);
  for (std::size_t i = 0; i < order.size(); ++i) {
    first[i + 1] = first[i] + slot_of(all.polygon_size[i]);
  }
  const auto place = [&all](std::size_t i) {
    return std::pair(std::min(all.polygon_size[i], 3), all.key[i]);
  };
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return place(a) < place(b); });
  ContactView view;
  for (const std::size_t i : order) {
    append(view.position, all.position, 3 * first[i], 3 * (first[i + 1] - first[i]));
    view.polygon_size.push_back(all.polygon_size[i]);
    append(view.normal, all.normal, 3 * i, 3);
    append(view.pressure, all.pressure, i, 1);
    append(view.penetration, all.penetration, i, 1);
    append(view.bonded, all.bonded, i, 1);
    append(view.max_closure, all.max_closure, i, 1);
    append(view.force, all.force, 3 * i, 3);
    view.body_a.push_back(all.body_a[i]);
    view.body_b.push_back(all.body_b[i]);
  }
  return view;
}

/// The whole body that a .vtu holds or a .pvtu joins.
BodyView read_body(const std::filesystem::path& path, const std::string& name) {
  try {
    if (path.extension() == ".vtu") {
      return to_view(*read<vtkXMLUnstructuredGridReader>(path)->GetOutput(), name);
    }
    const auto pieces =
        to_view(*read_joined<vtkXMLPUnstructuredGridReader>(path)->GetOutput(), name);
    return merge_views({pieces});
  } catch (const std::invalid_argument& error) {
    fail(path, error.what());
  }
}

bool is_body(const std::filesystem::path& path) {
  return path.extension() == ".vtu" || path.extension() == ".pvtu";
}

}  // namespace

std::vector<BodyView> read_frame(const std::filesystem::path& folder, const FrameEntry& frame) {
  std::vector<BodyView> bodies;
  for (const auto& part : frame.parts) {
    const auto path = folder / part.file;
    if (!is_body(path)) continue;
    bodies.push_back(read_body(path, part.name));
    bodies.back().time = frame.time;
  }
  return bodies;
}

ContactView read_contacts(const std::filesystem::path& folder, const FrameEntry& frame) {
  for (const auto& part : frame.parts) {
    const auto path = folder / part.file;
    if (path.extension() == ".vtp") {
      return to_contact_view(*read<vtkXMLPolyDataReader>(path)->GetOutput());
    }
    if (path.extension() == ".pvtp") {
      return in_order(to_contact_view(*read_joined<vtkXMLPPolyDataReader>(path)->GetOutput()));
    }
  }
  return {};
}

}  // namespace brunt
// Tested by tests/unit/io/vtk_test.cpp.
