#include "io/mesh/catalog.hpp"

#include <algorithm>
#include <cctype>

#include "io/mesh/abaqus.hpp"
#include "io/mesh/gmsh.hpp"
#include "io/mesh/ls_dyna.hpp"
#include "io/vtk/vtu_mesh.hpp"

namespace brunt {

namespace {
constexpr MeshReader kMeshReaders[] = {
    {".msh", "Gmsh 2.2 and 4.1", &read_gmsh},
    {".inp", "Abaqus", &read_abaqus},
    {".k", "LS-DYNA", &read_ls_dyna},
    {".key", "LS-DYNA", &read_ls_dyna},
#ifdef BRUNT_VTK
    {".vtu", "VTK", &read_vtu},
#endif
};
}  // namespace

const MeshReader* mesh_reader(std::string_view path) {
  std::string lower(path);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const MeshReader& reader : kMeshReaders) {
    const std::string_view end = reader.extension;
    if (lower.size() > end.size() &&
        std::string_view(lower).substr(lower.size() - end.size()) == end) {
      return &reader;
    }
  }
  return nullptr;
}

std::string mesh_formats() {
  std::string text;
  for (const MeshReader& reader : kMeshReaders) {
    text += (text.empty() ? "" : ", ") + std::string(reader.extension) + " (" + reader.name + ")";
  }
  return text;
}

}  // namespace brunt
// Tested by tests/unit/io/gmsh_test.cpp.
