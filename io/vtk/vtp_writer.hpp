#pragma once
/// The .vtp of the contacts, written from their view: VTK's own writer takes milliseconds for a
/// few planes.
#include <filesystem>

#include "core/view.hpp"
#include "io/vtk/vtk_file.hpp"

namespace brunt {

/// Writes what VTK's writer makes of to_contacts(view, time): vertices, lines and polygons in the
/// order of the view among themselves, raw arrays, packed by LZ4. Throws std::invalid_argument
/// where a length does not fit, before anything is written, and MachineError.
void write_vtp(const std::filesystem::path& path, const ContactView& view, Real time,
               VtkFileMemory& memory);

}  // namespace brunt
