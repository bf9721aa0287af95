#pragma once
#include <string>

namespace brunt {

struct PictureArguments {
  std::string folder;
  std::string field;           ///< empty: chosen by what the bodies have
  std::string out;             ///< empty: folder
  std::string frames = "all";  ///< "all", "last" or numbers: "0,5,10"
  std::string view = "auto";   ///< auto, oblique, front, side, top
  std::string title;
};

/// `brunt render`: PNG pictures of the frames of an output folder, without a display.
int render_command(const PictureArguments& arguments);

}  // namespace brunt
