#include "app/frames.hpp"

#ifdef BRUNT_VTK
#include <optional>

#include "io/vtk/frame_writer.hpp"
#endif

namespace brunt {

#ifdef BRUNT_VTK
namespace {
/// Takes the folder over at the first frame, or with the frames of a checkpoint.
class VtkFrames final : public FrameSink {
 public:
  explicit VtkFrames(std::filesystem::path folder) : folder_(std::move(folder)) {}
  void write(Real time, const std::vector<BodyView>& bodies, const ContactView* contact) override {
    if (!writer_) writer_.emplace(folder_);
    writer_->write(time, bodies, contact);
  }
  std::string index() const override { return writer_ ? writer_->index() : frame_index_text({}); }
  void resume(const std::string& index, const std::filesystem::path& from) override {
    writer_.emplace(folder_, index, from);
  }

 private:
  std::filesystem::path folder_;
  std::optional<FrameWriter> writer_;
};

class NoFrames final : public FrameSink {
 public:
  void write(Real, const std::vector<BodyView>&, const ContactView*) override {}
  std::string index() const override { return ""; }
  void resume(const std::string&, const std::filesystem::path&) override {}
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
