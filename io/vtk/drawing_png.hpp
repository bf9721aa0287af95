#pragma once
#include <string>

#include "io/drawing.hpp"

namespace brunt {

/// The drawing as the bytes of a PNG file, at twice its size.
/// Throws MachineError where there is nothing to draw with.
std::string to_png(const Drawing& drawing);

}  // namespace brunt
