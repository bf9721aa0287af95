#pragma once
/// The .vtu of a body, written from its view as it stands: VTK's own writer holds the body three
/// times more before the first byte is in the file.
#include <filesystem>

#include "core/view.hpp"
#include "io/vtk/pieces.hpp"
#include "io/vtk/vtk_file.hpp"

namespace brunt {

/// Writes what VTK's writer makes of to_grid(view): raw arrays, packed by LZ4, and of a rank's
/// piece the point array vtkGhostType, which says which points are copies. Fields that wait are
/// made part by part. Throws std::invalid_argument where a field's length does not fit, before
/// anything is written, and MachineError.
void write_vtu(const std::filesystem::path& path, const BodyView& view, VtkFileMemory& memory);

/// The arrays of a piece as the file that joins it lists them.
FramePiece listed_arrays(const BodyView& view);

}  // namespace brunt
