#pragma once
#include <filesystem>
#include <memory>

#include "app/monitor.hpp"

namespace brunt {

/// Writes VTK frames into a folder; null where brunt was built without VTK.
std::unique_ptr<FrameSink> make_frame_sink(const std::filesystem::path& folder);

/// Takes frames and drops them: for ranks that only help to gather them. Null where the root's
/// is null.
std::unique_ptr<FrameSink> drop_frames();

}  // namespace brunt
