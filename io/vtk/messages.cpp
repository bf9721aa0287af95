#include "io/vtk/messages.hpp"

#include <vtkLogger.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

namespace brunt {

namespace {

/// Keeps the text and prints nothing.
class KeepingWindow : public vtkOutputWindow {
 public:
  static KeepingWindow* New();
  void DisplayText(const char* text) override {
    if (text == nullptr) return;
    for (const char* c = text; *c != '\0'; ++c) {
      const bool space = *c == '\n' || *c == ' ' || *c == '\t';
      if (space && (kept.empty() || kept.back() == ' ')) continue;
      kept += space ? ' ' : *c;
    }
  }

  std::string kept;

 private:
  KeepingWindow() = default;
};
vtkStandardNewMacro(KeepingWindow);

}  // namespace

struct VtkMessages::Implementation {
  vtkSmartPointer<vtkOutputWindow> before = vtkOutputWindow::GetInstance();
  vtkSmartPointer<KeepingWindow> window = vtkSmartPointer<KeepingWindow>::New();
};

VtkMessages::VtkMessages() : implementation_(std::make_unique<Implementation>()) {
  vtkOutputWindow::SetInstance(implementation_->window);
  // VTK's logger prints beside the window of messages, and cannot be asked what it printed before.
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
}

VtkMessages::~VtkMessages() { vtkOutputWindow::SetInstance(implementation_->before); }

std::string VtkMessages::text() const { return implementation_->window->kept; }

}  // namespace brunt
// Tested by tests/unit/io/vtk_test.cpp.
