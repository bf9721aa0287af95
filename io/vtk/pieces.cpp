#include "io/vtk/pieces.hpp"

#include <vtkSmartPointer.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLUtilities.h>

#include "core/errors.hpp"
#include "io/vtk/messages.hpp"

namespace brunt {

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

std::string joining_text(const std::string& type, const std::vector<FramePiece>& pieces) {
  std::string point_arrays, cell_arrays, files;
  for (const auto& piece : pieces) {
    if (point_arrays.empty()) point_arrays = piece.point_arrays;
    if (cell_arrays.empty()) cell_arrays = piece.cell_arrays;
    if (!piece.file.empty()) files += "    <Piece Source=\"" + escaped(piece.file) + "\"/>\n";
  }
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"" + type +
         "\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\" "
         "compressor=\"vtkLZ4DataCompressor\">\n  <" +
         type + " GhostLevel=\"0\">\n    <PPointData>\n" + point_arrays +
         "    </PPointData>\n    <PCellData>\n" + cell_arrays +
         "    </PCellData>\n    <PPoints>\n      <PDataArray type=\"Float64\" Name=\"Points\" "
         "NumberOfComponents=\"3\"/>\n    </PPoints>\n" +
         files + "  </" + type + ">\n</VTKFile>\n";
}

std::vector<std::string> joined_files(const std::string& text, const std::string& name) {
  const auto fail = [&name](const std::string& what) {
    throw MachineError("cannot use '" + name + "': " + what);
  };
  VtkMessages messages;
  const auto root = vtkSmartPointer<vtkXMLDataElement>::Take(
      vtkXMLUtilities::ReadElementFromString(text.c_str()));
  if (!root || root->GetNumberOfNestedElements() != 1) fail("it joins no pieces");
  auto* data = root->GetNestedElement(0);
  std::vector<std::string> files;
  for (int i = 0; i < data->GetNumberOfNestedElements(); ++i) {
    auto* element = data->GetNestedElement(i);
    if (std::string(element->GetName()) != "Piece") continue;
    const char* file = element->GetAttribute("Source");
    if (file == nullptr) fail("one of its pieces has no file");
    files.emplace_back(file);
  }
  return files;
}

}  // namespace brunt
