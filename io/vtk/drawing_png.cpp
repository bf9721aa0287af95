#include "io/vtk/drawing_png.hpp"

#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <cmath>

#include "core/errors.hpp"
#include "io/vtk/messages.hpp"
#include "io/vtk/offscreen.hpp"
#include "io/vtk/picture_bytes.hpp"

namespace brunt {

namespace {
/// Of the finished picture over the drawing: sharp where it is printed.
constexpr int kEnlarged = 2;
constexpr Real kPixels = kEnlarged * kOversampling;  // of the renderer, a pixel of the drawing

void set_ink(vtkProperty2D& property, const Ink& ink) {
  property.SetColor(ink[0] / 255.0, ink[1] / 255.0, ink[2] / 255.0);
}

/// Draws on a renderer whose y goes up.
class Board {
 public:
  Board(vtkRenderer& renderer, int height) : renderer_(renderer), height_(height) {}

  void polygon(const std::vector<std::array<Real, 2>>& corners, const Ink& ink) {
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> cells;
    cells->InsertNextCell(static_cast<vtkIdType>(corners.size()));
    for (const auto& [x, y] : corners) {
      cells->InsertCellPoint(points->InsertNextPoint(x * kPixels, (height_ - y) * kPixels, 0));
    }
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetPolys(cells);
    vtkNew<vtkPolyDataMapper2D> mapper;
    mapper->SetInputData(data);
    vtkNew<vtkActor2D> actor;
    actor->SetMapper(mapper);
    set_ink(*actor->GetProperty(), ink);
    renderer_.AddActor2D(actor);
  }

  /// A line is a rectangle: not every driver draws lines as wide as asked.
  void line(const Drawing::Line& line) {
    const Real length = std::hypot(line.x1 - line.x0, line.y1 - line.y0);
    if (length == 0) return;
    const Real x = 0.5 * line.width * (line.y1 - line.y0) / length;
    const Real y = -0.5 * line.width * (line.x1 - line.x0) / length;
    polygon({{line.x0 + x, line.y0 + y},
             {line.x1 + x, line.y1 + y},
             {line.x1 - x, line.y1 - y},
             {line.x0 - x, line.y0 - y}},
            line.ink);
  }

  void disc(Real x, Real y, Real radius, const Ink& ink) {
    constexpr int kCorners = 32;
    std::vector<std::array<Real, 2>> corners;
    for (int k = 0; k < kCorners; ++k) {
      const Real angle = 2 * kPi * k / kCorners;
      corners.push_back({x + radius * std::cos(angle), y + radius * std::sin(angle)});
    }
    polygon(corners, ink);
  }

  void text(const Drawing::Text& text) {
    vtkNew<vtkTextActor> actor;
    actor->SetInput(text.text.c_str());
    auto* property = actor->GetTextProperty();
    property->SetFontFamilyToArial();
    constexpr Real kLetters = 0.82;  // size of this library's letters over that of browsers
    property->SetFontSize(static_cast<int>(std::lround(text.size * kPixels * kLetters)));
    property->SetBold(text.bold);
    property->SetColor(text.ink[0] / 255.0, text.ink[1] / 255.0, text.ink[2] / 255.0);
    property->SetVerticalJustificationToCentered();
    if (text.anchor > 0.25) property->SetJustificationToCentered();
    if (text.anchor > 0.75) property->SetJustificationToRight();
    if (text.upright) property->SetOrientation(90);
    actor->SetPosition(text.x * kPixels, (height_ - text.y) * kPixels);
    renderer_.AddActor2D(actor);
  }

 private:
  vtkRenderer& renderer_;
  int height_;
};
}  // namespace

std::string to_png(const Drawing& drawing) {
  VtkMessages messages;
  const int width = kEnlarged * drawing.width, height = kEnlarged * drawing.height;
  OffscreenWindow offscreen(width * kOversampling, height * kOversampling);
  offscreen.window().SetMultiSamples(0);
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1, 1, 1);
  Board board(*renderer, drawing.height);
  for (const auto& line : drawing.lines) board.line(line);
  for (const auto& mark : drawing.marks) {
    board.disc(mark.x, mark.y, mark.radius + 1, mark.ink);
    if (!mark.filled) board.disc(mark.x, mark.y, mark.radius - 1, {255, 255, 255});
  }
  for (const auto& text : drawing.texts) board.text(text);
  offscreen.window().AddRenderer(renderer);
  return picture_bytes(offscreen.window(), width, height, messages);
}

}  // namespace brunt
// Tested by tests/unit/io/drawing_test.cpp.
