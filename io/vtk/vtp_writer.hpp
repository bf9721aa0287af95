#pragma once
/// The .vtp of the contacts, written from their view: VTK's own writer takes milliseconds for a
/// few planes.
#include <filesystem>

#include "core/view.hpp"
#include "io/vtk/pieces.hpp"
#include "io/vtk/vtk_file.hpp"

namespace brunt {

/// Writes what VTK's writer would make of the contacts: vertices, lines (planes in 2D) and polygons
/// in the order of the view among themselves, with normal, pressure, penetration, bonded,
/// max_closure, force, body_a and body_b of each; raw arrays, packed by LZ4. Throws
/// std::invalid_argument where a length does not fit, before anything is written, and MachineError.
/// piece  of one rank: with the cell array "key" besides, by which pieces are merged
void write_vtp(const std::filesystem::path& path, const ContactView& view, Real time, bool piece,
               VtkFileMemory& memory);

/// The arrays of a piece as the file that joins it lists them.
FramePiece listed_arrays(const ContactView& view);

}  // namespace brunt
