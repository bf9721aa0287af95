#pragma once
#include <array>
#include <cstdint>

#include "io/vtk/colouring.hpp"

namespace brunt {

/// Red, green, blue.
using Colour = std::array<std::uint8_t, 3>;

/// 256 colours: from pale to dark for numbers of one sign; blue, white, red about zero for numbers
/// of both. Both change lightness evenly, so that they can be read in print and by the
/// colour-blind.
std::array<Colour, 256> colour_map(bool diverging);

/// True where a range holds enough of both signs for the diverging map.
bool is_diverging(const Interval& range);

/// What the colours span: zero is in the middle of a diverging map, and with `from_zero` at the end
/// of another where it is near; never of no width.
Interval colour_range(const Interval& range, bool from_zero);

}  // namespace brunt
