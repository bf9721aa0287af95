#pragma once
/// The readers of mesh files. A new one: its source pair, its line in kMeshReaders of catalog.cpp,
/// its test (docs/adding.md).
#include <string_view>

#include "io/mesh/mesh_file.hpp"

namespace brunt {

/// One format. Its reader fills what the file has and throws std::runtime_error with file:line.
struct MeshReader {
  std::string_view extension;  ///< with its dot, in lower case
  const char* name;            ///< in messages
  MeshFile (*read)(const std::string& path);
};

/// The reader of a file by the end of its name; null where there is none.
const MeshReader* mesh_reader(std::string_view path);

/// ".msh (Gmsh 2.2 and 4.1), ...", for messages.
std::string mesh_formats();

}  // namespace brunt
