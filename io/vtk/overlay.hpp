#pragma once
/// Text, rectangles and lines over a picture, in pixels from its lower left corner; for io/vtk
/// only.
#include <vtkRenderer.h>

#include <array>
#include <string>
#include <vector>

#include "io/vtk/camera.hpp"
#include "io/vtk/colour_map.hpp"

namespace brunt {

/// How a text hangs at its place.
enum class Anchor { left, centre, right };

/// Draws over a renderer's picture. Sizes are in pixels of the finished picture; scale is how many
/// pixels of the renderer one of them is.
class Overlay {
 public:
  Overlay(vtkRenderer& renderer, int scale) : renderer_(renderer), scale_(scale) {}

  /// The middle of the text's height is at y.
  void text(const std::string& text, Real x, Real y, int size, Anchor anchor, bool bold = false);
  void line(Real x0, Real y0, Real x1, Real y1, Real width, Colour colour);
  /// A rectangle of one colour.
  void box(Real x0, Real y0, Real x1, Real y1, Colour colour);
  /// Squares of that width about places.
  void dots(const std::vector<std::array<Real, 2>>& places, Real width, Colour colour);

 private:
  vtkRenderer& renderer_;
  int scale_;
};

/// Fixed places of the overlay [pixel].
Margins overlay_margins();

/// The colours with round numbers beside them, at the right edge; title above.
void draw_scalar_bar(Overlay& overlay, int width, int height, const Colouring& colouring,
                     const Interval& range);

/// A bar of a round length at the lower edge.
void draw_length_bar(Overlay& overlay, int width, Real pixel);

/// The three (flat: two) axes in the lower left corner.
void draw_axes(Overlay& overlay, const ViewAxes& axes);

/// "t = 12.4 µs" and a title in the upper left corner.
void draw_heading(Overlay& overlay, int height, const std::string& title, Real time,
                  Real last_time);

}  // namespace brunt
