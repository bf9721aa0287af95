#pragma once
#include "io/mesh/mesh_file.hpp"

namespace brunt {

/// Reads an unstructured grid of VTK (.vtu): ASCII, base64 or appended, plain or packed by zlib.
/// Points and cells are numbered from 0, as ParaView shows them. Each value of a cell or point
/// array of whole numbers with no more than 256 of them is a set: "NAME VALUE". Throws
/// std::runtime_error.
MeshFile read_vtu(const std::string& path);

}  // namespace brunt
