#pragma once
/// A flat drawing of lines, marks and texts, for charts: as SVG here, as PNG in io/vtk.
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/types.hpp"

namespace brunt {

/// Red, green, blue.
using Ink = std::array<std::uint8_t, 3>;

/// Lengths in pixels, x to the right and y down from the upper left corner.
struct Drawing {
  struct Line {
    Real x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    Real width = 1;
    Ink ink{};
  };
  /// A disc, or a ring around white.
  struct Mark {
    Real x = 0, y = 0, radius = 5;
    Ink ink{};
    bool filled = true;
  };
  /// The middle of its height is at y; x is its left end (0), its middle (0.5) or its right end
  /// (1).
  struct Text {
    Real x = 0, y = 0;
    std::string text;
    int size = 14;  ///< of the letters
    Real anchor = 0;
    bool bold = false;
    bool upright = false;  ///< reads from below to above
    Ink ink{};
  };
  int width = 0, height = 0;
  std::vector<Line> lines;
  std::vector<Mark> marks;  ///< above the lines
  std::vector<Text> texts;  ///< above all
};

/// Text as SVG and HTML take it: with <, >, & and quotes by name, without control characters but
/// ends of lines.
std::string escaped_xml(const std::string& text);

/// The drawing as an SVG file.
std::string to_svg(const Drawing& drawing);

/// The width that a text has about, for its room [pixel].
Real text_width(const std::string& text, int size);

}  // namespace brunt
