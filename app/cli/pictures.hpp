#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace brunt {

struct PictureArguments {
  std::string folder;
  std::string field;           ///< empty: chosen by what the bodies have
  std::string out;             ///< empty: folder
  std::string frames = "all";  ///< "all", "last" or numbers: "0,5,10"
  std::string view = "auto";   ///< auto, oblique, front, side, top
  std::string title;
  bool contacts = false;  ///< black dots where contacts carry force
};

/// `brunt render`: PNG pictures of the frames of an output folder, without a display.
int render_command(const PictureArguments& arguments);

/// True where brunt was built with what draws.
bool can_draw();
/// Pictures of all frames of an output folder, into it; their paths in order.
std::vector<std::filesystem::path> draw_run(const std::filesystem::path& folder,
                                            const std::string& title);

}  // namespace brunt
