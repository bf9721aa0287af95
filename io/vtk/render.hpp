#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/view.hpp"

namespace brunt {

/// What `brunt render` is asked for.
struct RenderOptions {
  /// Field that colours, with a component after a dot. Empty: eps_p where something flows, else
  /// von_mises, else velocity.magnitude.
  std::string field;
  std::string frames = "all";  ///< "all", "last", or numbers from 0: "0,5,10"
  std::string view = "auto";   ///< auto | oblique | front | side | top; auto: oblique, 2D: front
  std::string title;
  bool contacts = false;                       ///< a black dot at each contact
  int width = 1280;                            ///< [pixel]
  int height = 800;                            ///< [pixel]
  std::optional<std::pair<Real, Real>> range;  ///< of the colours, SI; default: of all frames
};

/// Where frames come from: files, or a test.
struct FrameSource {
  std::vector<Real> times;                                         ///< [s] of each frame
  std::function<std::vector<BodyView>(std::size_t frame)> bodies;  ///< of one frame
  std::function<ContactView(std::size_t frame)> contacts = {};     ///< the same; may be empty
};

/// Writes pictures NAME.00000.png (NAME the field, the number that of the frame) into `out`, with
/// one camera and one range of colours for all, and returns their paths. Throws DeckError where the
/// options are wrong, MachineError where drawing or writing fails.
std::vector<std::filesystem::path> render_frames(const FrameSource& source,
                                                 const std::filesystem::path& out,
                                                 const RenderOptions& options);

/// The same of the frames of an output folder (frames.pvd).
std::vector<std::filesystem::path> render_folder(const std::filesystem::path& folder,
                                                 const std::filesystem::path& out,
                                                 const RenderOptions& options);

}  // namespace brunt
