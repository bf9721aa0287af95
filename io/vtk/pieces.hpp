#pragma once
/// The small files that join the pieces of a part of a frame, for ParaView: .pvtu and .pvtp.
#include <string>
#include <vector>

namespace brunt {

/// What one rank has written of one part of a frame.
struct FramePiece {
  std::string file;          ///< in the folder of frames; empty: the rank has nothing of the part
  std::string point_arrays;  ///< as the joining file lists them; empty: not known here
  std::string cell_arrays;
};

/// The text of a .pvtu (type "PUnstructuredGrid") or .pvtp ("PPolyData"): the pieces that have a
/// file. Arrays are listed as the first piece that knows them has them.
std::string joining_text(const std::string& type, const std::vector<FramePiece>& pieces);

/// The files that such a text names. Throws MachineError naming `name` where it is broken.
std::vector<std::string> joined_files(const std::string& text, const std::string& name);

/// Text as it stands in an attribute of XML.
std::string escaped(const std::string& text);

}  // namespace brunt
