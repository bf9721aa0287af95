#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "core/view.hpp"
#include "io/vtk/frame_index.hpp"

namespace brunt {

/// The bodies of one frame, each whole: pieces of several ranks are merged by their ids to the bits
/// that a lone rank writes. Throws MachineError naming the file that is missing or broken.
std::vector<BodyView> read_frame(const std::filesystem::path& folder, const FrameEntry& frame);

/// The contacts of one frame: particle contacts first; empty where there are none in the frame.
/// Throws MachineError.
ContactView read_contacts(const std::filesystem::path& folder, const FrameEntry& frame);

}  // namespace brunt
