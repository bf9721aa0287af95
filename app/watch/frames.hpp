#pragma once
#include <filesystem>
#include <memory>

#include "app/watch/monitor.hpp"

namespace brunt {

/// Writes VTK frames into a folder: a lone rank whole ones, several ranks their pieces, which the
/// root joins. Null where brunt was built without VTK. ranks outlives it.
std::unique_ptr<FrameSink> make_frame_sink(const std::filesystem::path& folder,
                                           const Communicator& ranks);

}  // namespace brunt
