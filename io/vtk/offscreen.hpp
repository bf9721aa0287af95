#pragma once
#include <vtkRenderWindow.h>
#include <vtkSmartPointer.h>

#include <memory>

namespace brunt {

/// A window to draw into where there is no display: an own EGL context without a surface, else a
/// hidden window of the X display. For io/vtk only.
class OffscreenWindow {
 public:
  /// Throws MachineError where neither can be had.
  OffscreenWindow(int width, int height);
  ~OffscreenWindow();
  OffscreenWindow(const OffscreenWindow&) = delete;
  OffscreenWindow& operator=(const OffscreenWindow&) = delete;

  vtkRenderWindow& window();

 private:
  struct Context;
  std::unique_ptr<Context> context_;
  vtkSmartPointer<vtkRenderWindow> window_;
};

}  // namespace brunt
