#pragma once
#include <vtkRenderWindow.h>

#include <string>

#include "io/vtk/messages.hpp"

namespace brunt {

/// Pictures are drawn so many times as large and averaged down. For io/vtk only.
inline constexpr int kOversampling = 2;

/// Renders a window of kOversampling times the size; the bytes of a PNG file.
/// messages  what VTK has complained of so far
/// Throws MachineError where OpenGL fails.
std::string picture_bytes(vtkRenderWindow& window, int width, int height,
                          const VtkMessages& messages);

}  // namespace brunt
