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

/// Replaces folder/frames.pvd, which ParaView opens: each part is a block with its name. Throws
/// MachineError.
void write_frame_index(const std::filesystem::path& folder, const std::vector<FrameEntry>& frames);

/// What folder/frames.pvd names, by time. Throws MachineError where it is missing or broken.
std::vector<FrameEntry> read_frame_index(const std::filesystem::path& folder);

}  // namespace brunt
