#include "app/pictures.hpp"

#include <cstdio>

#include "app/run_arguments.hpp"
#include "core/errors.hpp"
#ifdef BRUNT_VTK
#include "io/vtk/render.hpp"
#endif

namespace brunt {

#ifdef BRUNT_VTK
int render_command(const PictureArguments& arguments) {
  RenderOptions options;
  options.field = arguments.field;
  options.frames = arguments.frames;
  options.view = arguments.view;
  options.title = arguments.title;
  const auto out = arguments.out.empty() ? arguments.folder : arguments.out;
  for (const auto& path : render_folder(arguments.folder, out, options)) {
    std::printf("%s\n", path.c_str());
  }
  return kDone;
}
#else
int render_command(const PictureArguments&) {
  throw MachineError("this brunt was built without VTK: configure with -DBRUNT_VTK=ON");
}
#endif

}  // namespace brunt
