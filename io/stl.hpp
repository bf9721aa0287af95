#pragma once
#include <array>
#include <string>
#include <vector>

#include "core/types.hpp"

namespace brunt {

/// The triangles of an STL file, in its unit of length, with corners that are the same to the last
/// bit made one.
struct StlSurface {
  std::vector<Vec3> nodes;
  std::vector<std::array<int, 3>> triangles;  ///< in the file's order; its normals are not read
  std::size_t degenerate = 0;                 ///< triangles without area, left out
};

/// Reads a text or binary STL file. Throws std::runtime_error with the file's name and the line or
/// triangle where it is wrong.
StlSurface read_stl(const std::string& path);

}  // namespace brunt
