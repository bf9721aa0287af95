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

  /// Goes on after a restart with the frames of an index, which lie in the folder `from`: those of
  /// another folder are linked or copied, those that are not there any more left out. Others in
  /// `folder` are removed. Throws MachineError.
  FrameWriter(std::filesystem::path folder, const std::string& index,
              const std::filesystem::path& from);

  /// The present text of frames.pvd.
  std::string index() const { return frame_index_text(frames_); }

  /// Writes one frame. contact may be null; a scene gives it always or never, so that the parts are
  /// the same in all frames. Throws MachineError with the name of the file; the frames before stay.
  void write(Real time, const std::vector<BodyView>& bodies, const ContactView* contact);

  std::size_t n_frames() const { return frames_.size(); }

 private:
  std::filesystem::path folder_;
  std::vector<FrameEntry> frames_;
  std::size_t next_ = 0;  // number of the next frame in names of files
};

}  // namespace brunt
