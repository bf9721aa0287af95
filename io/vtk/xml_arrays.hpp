#pragma once
#include <string>
#include <vector>

#include "core/types.hpp"

namespace brunt {

/// An array of a VTK XML file.
struct XmlArray {
  std::string section;  ///< "Points", "Cells", "CellData", "PointData"
  std::string name;
  int components = 1;
  std::vector<Real> values;
};

/// Reads the arrays of a serial VTK XML file of one piece: ASCII, base64 or appended (raw, base64),
/// plain or packed by zlib. VTK's own reader crashes on files that are damaged. Throws
/// std::runtime_error with the file's name.
///   VTK file formats, "XML file formats"
std::vector<XmlArray> read_xml_arrays(const std::string& path);

}  // namespace brunt
// Tested by tests/unit/io/vtu_mesh_test.cpp.
