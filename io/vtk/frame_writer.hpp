#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "core/view.hpp"
#include "io/vtk/frame_index.hpp"
#include "io/vtk/pieces.hpp"
#include "io/vtk/vtk_file.hpp"

namespace brunt {

/// Writes frames for ParaView: in folder/frames one .vtu a body and frame and one .vtp of contacts
/// (appended raw, lz4), and folder/frames.pvd, which names them with their times and bodies. Each
/// file is whole or not there; frames.pvd names only files that are whole. Of several ranks each
/// writes such files as its pieces (write_pieces), and the one with the writer joins them.
class FrameWriter {
 public:
  /// Starts anew: frames that are there already are removed. Throws MachineError.
  explicit FrameWriter(std::filesystem::path folder);

  /// Goes on after a restart with the frames of an index, which lie in the folder `from`: those of
  /// another folder are linked or copied, those that are not there any more left out. Others in
  /// `folder` are removed. Throws MachineError.
  FrameWriter(std::filesystem::path folder, const std::string& index,
              const std::filesystem::path& from);

  /// Takes the folder of frames away again where it is empty, as after a first one that was
  /// refused.
  ~FrameWriter();
  FrameWriter(const FrameWriter&) = delete;
  FrameWriter& operator=(const FrameWriter&) = delete;

  /// The present text of frames.pvd.
  std::string index() const { return frame_index_text(frames_); }

  /// Writes one frame. contact may be null; a scene gives it always or never, so that the parts are
  /// the same in all frames. Throws MachineError with the name of the file, and NoNumberError, of
  /// which nothing is left; the frames before stay.
  void write(Real time, const std::vector<BodyView>& bodies, const ContactView* contact);

  /// Makes one frame of the pieces that all ranks have written of frame number next(): a .pvtu a
  /// body, of the names in their order, and a .pvtp of contacts where the pieces are one more than
  /// the names. pieces: of each rank. Throws MachineError as write does.
  void join(Real time, const std::vector<std::string>& bodies,
            const std::vector<std::vector<FramePiece>>& pieces);

  /// The number that the next frame carries in names of files.
  std::size_t next() const { return next_; }
  std::size_t n_frames() const { return frames_.size(); }

 private:
  void add(FrameEntry frame);

  std::filesystem::path folder_;
  std::vector<FrameEntry> frames_;
  std::size_t next_ = 0;
  VtkFileMemory memory_;
};

/// Writes what one rank has of frame `number`, a file a body and one of the contacts where contact
/// is not null, into folder/frames, which is there; nothing is written of what the rank has not.
/// The field `id` tells points, and cells, from each other. Ranks with points of a body give the
/// same fields, VTK's reader wants all of them in each piece. Throws MachineError with the name of
/// the file. memory  of this rank, from frame to frame
std::vector<FramePiece> write_pieces(const std::filesystem::path& folder, std::size_t number,
                                     int rank, Real time, const std::vector<BodyView>& bodies,
                                     const ContactView* contact, VtkFileMemory& memory);

}  // namespace brunt
