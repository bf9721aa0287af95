#pragma once
#include <memory>
#include <string>

namespace brunt {

/// While it lives, what VTK has to say is kept here instead of going to stderr or a window. The
/// window of messages is global in VTK: one of these at a time, on the main thread.
class VtkMessages {
 public:
  VtkMessages();
  ~VtkMessages();
  VtkMessages(const VtkMessages&) = delete;
  VtkMessages& operator=(const VtkMessages&) = delete;

  bool any() const { return !text().empty(); }
  /// All that was said, in one line.
  std::string text() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace brunt
