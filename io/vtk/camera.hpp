#pragma once
/// Where a picture is taken from: parallel projection, the same for all frames. No VTK.
#include <string>
#include <vector>

#include "core/view.hpp"
#include "io/vtk/colouring.hpp"

namespace brunt {

/// Directions of a picture; orthonormal, right x up = toward (the eye).
struct ViewAxes {
  Vec3 right, up, toward;
};

/// "front" (x to the right, y up; 2D), or for 3D with z up "oblique", "front" (x right), "side"
/// (y right), "top" (x right, y up). Throws std::invalid_argument for another name.
ViewAxes view_axes(const std::string& name, bool flat);

/// True where all bodies lie in the plane z = 0.
bool is_flat(const std::vector<BodyView>& bodies);

/// A rectangle in the plane of the picture [m].
struct Frame2 {
  Interval right, up;
  bool empty() const { return right.empty(); }
  Real width() const { return right.high - right.low; }
  Real height() const { return up.high - up.low; }
};

/// What a run covers of the plane of the picture: deforming bodies whole, rigid ones as far as they
/// are near these.
class Coverage {
 public:
  explicit Coverage(const ViewAxes& axes) : axes_(axes) {}
  void take(const BodyView& view);
  Frame2 frame() const;

 private:
  ViewAxes axes_;
  Frame2 deforming_, rigid_;
};

/// Margins around the bodies, for text [pixel].
struct Margins {
  int left = 0, right = 0, bottom = 0, top = 0;
};

/// Scale and place of the picture.
struct Camera {
  ViewAxes axes;
  Real center_right = 0, center_up = 0;  ///< [m] middle of the picture
  Real pixel = 1;                        ///< [m] a pixel
};

/// Fits the frame into what the margins leave of width x height pixels.
Camera fit(const ViewAxes& axes, const Frame2& frame, int width, int height,
           const Margins& margins);

}  // namespace brunt
