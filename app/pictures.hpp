#pragma once
#include <string>

namespace brunt {

struct PictureArguments {
  std::string folder;
  std::string field;  ///< empty: chosen by what the bodies have
  std::string out;    ///< empty: folder
  bool last = false;
};

/// `brunt render`: PNG pictures of the frames of an output folder, without a display.
int render_command(const PictureArguments& arguments);

}  // namespace brunt
