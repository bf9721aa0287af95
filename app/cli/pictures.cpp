#include "app/cli/pictures.hpp"

#include <cstdio>

#include "app/cli/run_arguments.hpp"
#include "core/errors.hpp"
#ifdef BRUNT_VTK
#include "io/vtk/render.hpp"
#endif

namespace brunt {

#ifdef BRUNT_VTK
bool can_draw() { return true; }

std::vector<std::filesystem::path> draw_run(const std::filesystem::path& folder,
                                            const std::string& title) {
  RenderOptions options;
  options.title = title;
  return render_folder(folder, folder, options);
}

int render_command(const PictureArguments& arguments) {
  std::error_code error;
  if (!std::filesystem::exists(std::filesystem::path(arguments.folder) / "frames.pvd", error)) {
    throw DeckError({{{arguments.folder, 0, 0},
                      "",
                      "has no frames.pvd: name the folder that a run wrote, such as bars.out"}});
  }
  RenderOptions options;
  options.field = arguments.field;
  options.frames = arguments.frames;
  options.view = arguments.view;
  options.title = arguments.title;
  options.contacts = arguments.contacts;
  const auto out = arguments.out.empty() ? arguments.folder : arguments.out;
  for (const auto& path : render_folder(arguments.folder, out, options)) {
    std::printf("%s\n", path.c_str());
  }
  return kDone;
}
#else
bool can_draw() { return false; }

std::vector<std::filesystem::path> draw_run(const std::filesystem::path&, const std::string&) {
  return {};
}

int render_command(const PictureArguments&) {
  throw MachineError("this brunt was built without VTK: configure with -DBRUNT_VTK=ON");
}
#endif

}  // namespace brunt
