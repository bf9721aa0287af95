#include "app/frames.hpp"

#ifdef BRUNT_VTK
#include "io/vtk/frame_writer.hpp"
#endif

namespace brunt {

#ifdef BRUNT_VTK
namespace {
class VtkFrames final : public FrameSink {
 public:
  explicit VtkFrames(const std::filesystem::path& folder) : writer_(folder) {}
  void write(Real time, const std::vector<BodyView>& bodies, const ContactView* contact) override {
    writer_.write(time, bodies, contact);
  }

 private:
  FrameWriter writer_;
};

class NoFrames final : public FrameSink {
 public:
  void write(Real, const std::vector<BodyView>&, const ContactView*) override {}
};
}  // namespace

std::unique_ptr<FrameSink> make_frame_sink(const std::filesystem::path& folder) {
  return std::make_unique<VtkFrames>(folder);
}
std::unique_ptr<FrameSink> drop_frames() { return std::make_unique<NoFrames>(); }
#else
std::unique_ptr<FrameSink> drop_frames() { return nullptr; }
std::unique_ptr<FrameSink> make_frame_sink(const std::filesystem::path&) { return nullptr; }
#endif

}  // namespace brunt
