#include "io/vtk/offscreen.hpp"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <vtkCallbackCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkObjectFactory.h>
#include <vtk_glew.h>

#include <array>
#include <cstdlib>

#include "core/errors.hpp"

namespace brunt {

/// The EGL context; current from its making to its end.
struct OffscreenWindow::Context {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;

  Context() = default;
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;
  ~Context() {
    if (display == EGL_NO_DISPLAY) return;
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
    eglTerminate(display);
  }

  bool is_current() const { return eglGetCurrentContext() == context; }
  bool make_current() const {
    return eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_TRUE;
  }

  /// True where a context of desktop OpenGL 3.2 or later is there and current.
  bool open() {
    display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr)) {
      display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
      if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr)) {
        display = EGL_NO_DISPLAY;
        return false;
      }
    }
    if (!eglBindAPI(EGL_OPENGL_API)) return false;
    const std::array<EGLint, 5> wanted = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                                          EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint n = 0;
    if (!eglChooseConfig(display, wanted.data(), &config, 1, &n) || n == 0) return false;
    const std::array<EGLint, 5> version = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION,
                                           2, EGL_NONE};
    context = eglCreateContext(display, config, EGL_NO_CONTEXT, version.data());
    return context != EGL_NO_CONTEXT && make_current();
  }
};

namespace {

/// A window on a context that is none of GLX. GLEW loads all of OpenGL first and only then misses
/// an X display, which VTK 9.1 takes for a failure; here it is none.
class SurfacelessWindow : public vtkGenericOpenGLRenderWindow {
 public:
  static SurfacelessWindow* New();
  void OpenGLInitContext() override {
    ContextCreationTime.Modified();
    if (Initialized) return;
    const GLenum result = glewInit();
    GlewInitValid = result == GLEW_OK || result == GLEW_ERROR_NO_GLX_DISPLAY;
    if (!GlewInitValid || !GLEW_VERSION_3_2) {
      vtkErrorMacro("no OpenGL 3.2 (GLEW says " << result << ")");
      return;
    }
    Initialized = true;
    std::array<GLfloat, 2> widths = {1, 1};
    glGetFloatv(GL_ALIASED_LINE_WIDTH_RANGE, widths.data());
    MaximumHardwareLineWidth = widths[1];
  }
};
vtkStandardNewMacro(SurfacelessWindow);

template <class Context>
vtkSmartPointer<vtkRenderWindow> window_of(Context& context) {
  auto window = vtkSmartPointer<SurfacelessWindow>::New();
  auto make_current = vtkSmartPointer<vtkCallbackCommand>::New();
  make_current->SetClientData(&context);
  make_current->SetCallback([](vtkObject*, unsigned long, void* client, void*) {
    static_cast<Context*>(client)->make_current();
  });
  auto is_current = vtkSmartPointer<vtkCallbackCommand>::New();
  is_current->SetClientData(&context);
  is_current->SetCallback([](vtkObject*, unsigned long, void* client, void* answer) {
    *static_cast<bool*>(answer) = static_cast<Context*>(client)->is_current();
  });
  window->AddObserver(vtkCommand::WindowMakeCurrentEvent, make_current);
  window->AddObserver(vtkCommand::WindowIsCurrentEvent, is_current);
  window->SetFrameBlitModeToNoBlit();  // there is no surface to copy the picture to
  window->SetReadyForRendering(true);
  return window;
}

}  // namespace

OffscreenWindow::OffscreenWindow(int width, int height) : context_(std::make_unique<Context>()) {
  if (context_->open()) {
    window_ = window_of(*context_);
  } else if (std::getenv("DISPLAY") != nullptr) {
    context_.reset();
    window_ = vtkSmartPointer<vtkRenderWindow>::New();
    window_->SetOffScreenRendering(1);
  } else {
    throw MachineError(
        "cannot draw pictures: no OpenGL through EGL and no display; install Mesa's EGL and DRI "
        "drivers, or run under xvfb-run");
  }
  window_->SetShowWindow(false);
  window_->SetSize(width, height);
}

OffscreenWindow::~OffscreenWindow() { window_->Finalize(); }

vtkRenderWindow& OffscreenWindow::window() { return *window_; }

}  // namespace brunt
// Tested by tests/unit/io/render_test.cpp.
