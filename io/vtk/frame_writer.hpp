#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "core/view.hpp"
#include "io/vtk/frame_index.hpp"

namespace brunt {

/// Writes frames for ParaView: in folder/frames one .vtu a body and frame and one .vtp of contacts
/// (appended raw, lz4), and folder/frames.pvd, which names them with their times and bodies. Each
/// file is whole or not there; frames.pvd names only files that are whole.
class FrameWriter {
 public:
  /// Starts anew: frames that are there already are removed. Throws MachineError.
  explicit FrameWriter(std::filesystem::path folder);

  /// Goes on after a restart: keeps the frames up to time `until` [s]. Throws MachineError.
  FrameWriter(std::filesystem::path folder, Real until);

  /// Writes one frame. contact may be null; a scene gives it always or never, so that the parts are
  /// the same in all frames. Throws MachineError with the name of the file; the frames before stay.
  void write(Real time, const std::vector<BodyView>& bodies, const ContactView* contact);

  std::size_t n_frames() const { return frames_.size(); }

 private:
  std::filesystem::path folder_;
  std::vector<FrameEntry> frames_;
};

}  // namespace brunt
