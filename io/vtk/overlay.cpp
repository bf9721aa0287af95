#include "io/vtk/overlay.hpp"

#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <cmath>
#include <cstdio>

#include "io/number.hpp"

namespace brunt {

namespace {

constexpr Colour kInk = {40, 40, 40};
constexpr int kTextSize = 17;

void add_data(vtkRenderer& renderer, vtkPolyData& data, Real width, Colour colour) {
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(&data);
  vtkNew<vtkActor2D> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(colour[0] / 255.0, colour[1] / 255.0, colour[2] / 255.0);
  actor->GetProperty()->SetLineWidth(static_cast<float>(width));
  renderer.AddActor2D(actor);
}

/// A polygon or a line of four or two corners in pixels of the renderer.
void add_shape(vtkRenderer& renderer, const std::vector<std::array<Real, 2>>& corners, Real width,
               Colour colour) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell(static_cast<vtkIdType>(corners.size()));
  for (const auto& corner : corners) {
    cells->InsertCellPoint(points->InsertNextPoint(corner[0], corner[1], 0));
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  if (corners.size() == 2) {
    data->SetLines(cells);
  } else {
    data->SetPolys(cells);
  }
  add_data(renderer, *data, width, colour);
}

/// The largest 1, 2 or 5 times a power of ten that is not above length.
Real round_length(Real length) {
  const Real power = std::pow(10.0, std::floor(std::log10(length)));
  for (const Real round : {5.0, 2.0}) {
    if (round * power <= length) return round * power;
  }
  return power;
}

/// Name for people: "von Mises stress", "velocity".
std::string spoken(const Colouring& colouring) {
  const auto& field = colouring.field;
  std::string name = field;
  if (field == "eps_p") name = "plastic strain";
  if (field == "von_mises") name = "von Mises stress";
  if (field == "strain_rate") name = "strain rate";
  if (!colouring.component.empty() && colouring.component != "magnitude") {
    name += " " + colouring.component;
  }
  return name;
}

}  // namespace

void Overlay::text(const std::string& text, Real x, Real y, int size, Anchor anchor, bool bold) {
  vtkNew<vtkTextActor> actor;
  actor->SetInput(text.c_str());
  auto* property = actor->GetTextProperty();
  property->SetFontFamilyToArial();
  property->SetFontSize(size * scale_);
  property->SetBold(bold);
  property->SetColor(kInk[0] / 255.0, kInk[1] / 255.0, kInk[2] / 255.0);
  property->SetVerticalJustificationToCentered();
  if (anchor == Anchor::centre) property->SetJustificationToCentered();
  if (anchor == Anchor::right) property->SetJustificationToRight();
  actor->SetPosition(x * scale_, y * scale_);
  renderer_.AddActor2D(actor);
}

void Overlay::line(Real x0, Real y0, Real x1, Real y1, Real width, Colour colour) {
  add_shape(renderer_, {{x0 * scale_, y0 * scale_}, {x1 * scale_, y1 * scale_}}, width * scale_,
            colour);
}

void Overlay::box(Real x0, Real y0, Real x1, Real y1, Colour colour) {
  add_shape(renderer_,
            {{x0 * scale_, y0 * scale_},
             {x1 * scale_, y0 * scale_},
             {x1 * scale_, y1 * scale_},
             {x0 * scale_, y1 * scale_}},
            0, colour);
}

void Overlay::dots(const std::vector<std::array<Real, 2>>& places, Real width, Colour colour) {
  if (places.empty()) return;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> squares;
  for (const auto& [x, y] : places) {
    squares->InsertNextCell(4);
    for (const auto& [right, up] : {std::pair{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}) {
      const vtkIdType corner =
          points->InsertNextPoint((x + right * width) * scale_, (y + up * width) * scale_, 0);
      squares->InsertCellPoint(corner);
    }
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(squares);
  add_data(renderer_, *data, 0, colour);
}

Margins overlay_margins() { return {40, 200, 90, 80}; }

void draw_scalar_bar(Overlay& overlay, int width, int height, const Colouring& colouring,
                     const Interval& range) {
  const Real x = width - 150, bar = 22, low = 0.16 * height, high = 0.80 * height;
  const auto map = colour_map(is_diverging(range));
  const Real step = (high - low) / static_cast<Real>(map.size());
  for (std::size_t i = 0; i < map.size(); ++i) {
    const Real y = low + static_cast<Real>(i) * step;
    overlay.box(x, y, x + bar, y + step + 0.5, map[i]);
  }
  const auto unit =
      display_unit(std::max(std::fabs(range.low), std::fabs(range.high)), unit_of(colouring.field));
  for (const Real value : ticks(range, 8)) {
    const Real y = low + (high - low) * (value - range.low) / (range.high - range.low);
    overlay.line(x + bar, y, x + bar + 6, y, 1.5, kInk);
    overlay.text(rounded(value * unit.factor, 6), x + bar + 12, y, kTextSize, Anchor::left);
  }
  // The title stands over the bar, in one or two lines, with the unit last.
  const Real middle = x + 45;
  if (!unit.unit.empty()) {
    overlay.text(spoken(colouring), middle, high + 48, kTextSize, Anchor::centre);
    overlay.text("[" + unit.unit + "]", middle, high + 24, kTextSize, Anchor::centre);
  } else {
    overlay.text(spoken(colouring), middle, high + 28, kTextSize, Anchor::centre);
  }
}

void draw_length_bar(Overlay& overlay, int width, Real pixel) {
  const Real length = round_length(0.16 * width * pixel);
  const Real half = 0.5 * length / pixel, middle = 0.5 * (width - 160), y = 30;
  overlay.line(middle - half, y, middle + half, y, 2, kInk);
  overlay.line(middle - half, y - 5, middle - half, y + 5, 2, kInk);
  overlay.line(middle + half, y - 5, middle + half, y + 5, 2, kInk);
  const auto unit = display_unit(length, "m");
  overlay.text(rounded(length * unit.factor, 6) + " " + unit.unit, middle, y + 18, kTextSize,
               Anchor::centre);
}

void draw_axes(Overlay& overlay, const ViewAxes& axes) {
  constexpr std::array<Colour, 3> colours = {{{200, 60, 50}, {60, 150, 60}, {50, 90, 200}}};
  const Real x = 58, y = 52, size = 36;
  for (int c = 0; c < 3; ++c) {
    const Real dx = axes.right[c], dy = axes.up[c];
    if (std::hypot(dx, dy) < 0.1) continue;  // it points at the eye
    const auto i = slot_of(c);
    overlay.line(x, y, x + size * dx, y + size * dy, 2.5, colours[i]);
    const Real beyond = 1 + 12 / (size * std::hypot(dx, dy));
    overlay.text(kAxes[i], x + size * dx * beyond, y + size * dy * beyond, 15, Anchor::centre);
  }
}

void draw_heading(Overlay& overlay, int height, const std::string& title, Real time,
                  Real last_time) {
  Real y = height - 34.0;
  if (!title.empty()) {
    overlay.text(title, 30, y, 20, Anchor::left, true);
    y -= 28;
  }
  // The unit is that of the last frame, so that it does not change from picture to picture.
  const auto unit = display_unit(last_time, "s");
  std::array<char, 48> text;
  std::snprintf(text.data(), text.size(), "t = %.4g %s", time * unit.factor, unit.unit.c_str());
  overlay.text(text.data(), 30, y, 19, Anchor::left);
}

}  // namespace brunt
// Tested by tests/unit/io/render_test.cpp.
