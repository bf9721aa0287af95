#include "io/vtk/frame_index.hpp"

#include <vtkSmartPointer.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLUtilities.h>

#include "core/errors.hpp"
#include "io/file.hpp"
#include "io/number.hpp"
#include "io/vtk/messages.hpp"
#include "io/vtk/pieces.hpp"

namespace brunt {

std::string frame_index_text(const std::vector<FrameEntry>& frames) {
  std::string text =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
      "  <Collection>\n";
  for (const auto& frame : frames) {
    for (std::size_t p = 0; p < frame.parts.size(); ++p) {
      const auto& part = frame.parts[p];
      text += "    <DataSet timestep=\"" + shortest(frame.time);
      text += "\" group=\"\" part=\"" + std::to_string(p);
      text += "\" name=\"" + escaped(part.name);
      text += "\" file=\"" + escaped(part.file);
      text += "\"/>\n";
    }
  }
  return text + "  </Collection>\n</VTKFile>\n";
}

void write_frame_index(const std::filesystem::path& folder, const std::vector<FrameEntry>& frames) {
  replace_file(folder / "frames.pvd", frame_index_text(frames));
}

std::vector<FrameEntry> read_frame_index(const std::filesystem::path& folder) {
  const auto path = folder / "frames.pvd";
  return parse_frame_index(read_file(path), path.string());
}

std::vector<FrameEntry> parse_frame_index(const std::string& text, const std::string& name) {
  const auto fail = [&name](const std::string& what) {
    throw MachineError("cannot use '" + name + "': " + what);
  };
  VtkMessages messages;
  const auto root = vtkSmartPointer<vtkXMLDataElement>::Take(
      vtkXMLUtilities::ReadElementFromString(text.c_str()));
  auto* collection = root ? root->FindNestedElementWithName("Collection") : nullptr;
  if (collection == nullptr) fail("it is no collection of frames");
  std::vector<FrameEntry> frames;
  for (int i = 0; i < collection->GetNumberOfNestedElements(); ++i) {
    auto* element = collection->GetNestedElement(i);
    const char* time = element->GetAttribute("timestep");
    const char* file = element->GetAttribute("file");
    const char* part = element->GetAttribute("name");
    const auto value = time ? parse_real(time) : std::nullopt;
    if (!value || file == nullptr) fail("entry " + std::to_string(i) + " has no time or no file");
    if (frames.empty() || frames.back().time != *value) frames.push_back({*value, {}});
    frames.back().parts.push_back({part ? part : file, file});
  }
  return frames;
}

}  // namespace brunt
// Tested by tests/unit/io/vtk_test.cpp.
