#include "io/vtk/camera.hpp"

#include <algorithm>
#include <stdexcept>

namespace brunt {

namespace {

/// The picture of an eye in this direction with z up.
ViewAxes looking_from(const Vec3& toward) {
  ViewAxes axes;
  axes.toward = toward.normalized();
  axes.right = Vec3::UnitZ().cross(axes.toward).normalized();
  axes.up = axes.toward.cross(axes.right);
  return axes;
}

Interval clipped(const Interval& range, const Interval& to, Real beyond) {
  return {std::max(range.low, to.low - beyond), std::min(range.high, to.high + beyond)};
}

void join(Interval& range, const Interval& other) {
  if (other.empty()) return;
  range.take(other.low);
  range.take(other.high);
}

}  // namespace

ViewAxes view_axes(const std::string& name, bool flat) {
  ViewAxes plane{Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
  if (name.empty() || name == "auto") return flat ? plane : looking_from({0.55, -1, 0.5});
  if (name == "oblique") return looking_from({0.55, -1, 0.5});
  if (name == "front") return flat ? plane : looking_from({0, -1, 0});
  if (name == "side") return looking_from({1, 0, 0});
  if (name == "top") return plane;
  throw std::invalid_argument("no view '" + name + "'; there are: oblique, front, side, top");
}

bool is_flat(const std::vector<BodyView>& bodies) {
  for (const auto& body : bodies) {
    for (std::size_t i = 2; i < body.position.size(); i += 3) {
      if (body.position[i] != 0) return false;
    }
  }
  return true;
}

void Coverage::take(const BodyView& view) {
  Frame2& frame = deforms(view) ? deforming_ : rigid_;
  for (std::size_t i = 0; i + 2 < view.position.size(); i += 3) {
    const Vec3 x(view.position[i], view.position[i + 1], view.position[i + 2]);
    const Real radius = view.point_radius.empty() ? 0 : view.point_radius[i / 3];
    const Real right = axes_.right.dot(x), up = axes_.up.dot(x);
    frame.right.take(right - radius);
    frame.right.take(right + radius);
    frame.up.take(up - radius);
    frame.up.take(up + radius);
  }
}

Frame2 Coverage::frame() const {
  if (deforming_.empty()) return rigid_;
  Frame2 frame = deforming_;
  const Real beyond = std::max(frame.width(), frame.height());
  join(frame.right, clipped(rigid_.right, deforming_.right, beyond));
  join(frame.up, clipped(rigid_.up, deforming_.up, beyond));
  return frame;
}

Camera fit(const ViewAxes& axes, const Frame2& frame, int width, int height,
           const Margins& margins) {
  Camera camera{axes, 0, 0, 1};
  if (frame.empty()) return camera;
  const int room_x = std::max(width - margins.left - margins.right, 1);
  const int room_y = std::max(height - margins.bottom - margins.top, 1);
  const Real pixel = std::max(frame.width() / room_x, frame.height() / room_y);
  if (pixel > 0) camera.pixel = pixel;
  // The middle of the room is not the middle of the picture.
  camera.center_right = 0.5 * (frame.right.low + frame.right.high) +
                        0.5 * (margins.right - margins.left) * camera.pixel;
  camera.center_up =
      0.5 * (frame.up.low + frame.up.high) + 0.5 * (margins.top - margins.bottom) * camera.pixel;
  return camera;
}

}  // namespace brunt
// Tested by tests/unit/io/render_test.cpp.
