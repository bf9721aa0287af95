#pragma once
/// One picture of one instant; for io/vtk only.
#include <vtkRenderer.h>

#include <string>
#include <vector>

#include "core/view.hpp"
#include "io/vtk/camera.hpp"
#include "io/vtk/colour_map.hpp"
#include "io/vtk/offscreen.hpp"

namespace brunt {

/// What stays the same in all pictures of a run.
struct PictureStyle {
  int width = 1280;  ///< [pixel]
  int height = 800;  ///< [pixel]
  Camera camera;
  Colouring colouring;
  Interval range;  ///< of the colours, SI; empty: nothing is coloured
  std::string title;
  Real last_time = 0;       ///< [s] of the run: chooses the unit of the time
  bool all_deform = false;  ///< no field tells which bodies do
};

/// Draws pictures with one style, at twice the size and averaged down.
class Painter {
 public:
  /// Throws MachineError where there is nothing to draw with.
  explicit Painter(PictureStyle style);

  /// The bytes of a PNG file. Throws MachineError where OpenGL fails.
  /// contacts  a black dot each, over all bodies
  std::string paint(const std::vector<BodyView>& bodies, Real time,
                    const ContactView& contacts = {});

 private:
  PictureStyle style_;
  OffscreenWindow offscreen_;
};

}  // namespace brunt
