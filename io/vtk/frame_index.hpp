#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "core/types.hpp"

namespace brunt {

/// One frame that frames.pvd names.
struct FrameEntry {
  struct Part {
    std::string name;  ///< of the body, or "contact"
    std::string file;  ///< relative to the folder
  };
  Real time = 0;  ///< [s]
  std::vector<Part> parts;
};

/// The text of frames.pvd.
std::string frame_index_text(const std::vector<FrameEntry>& frames);

/// What such a text names, by time. Throws MachineError naming `name` where it is broken.
std::vector<FrameEntry> parse_frame_index(const std::string& text, const std::string& name);

/// Replaces folder/frames.pvd, which ParaView opens: each part is a block with its name. Throws
/// MachineError.
void write_frame_index(const std::filesystem::path& folder, const std::vector<FrameEntry>& frames);

/// What folder/frames.pvd names, by time. Throws MachineError where it is missing or broken.
std::vector<FrameEntry> read_frame_index(const std::filesystem::path& folder);

}  // namespace brunt
