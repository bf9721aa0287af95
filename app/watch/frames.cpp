#include "app/watch/frames.hpp"

#ifdef BRUNT_VTK
#include <optional>

#include "app/ranks/agreed.hpp"
#include "app/watch/frame_check.hpp"
#include "io/vtk/frame_writer.hpp"
#endif

namespace brunt {

#ifdef BRUNT_VTK
namespace {
Bytes packed(const std::vector<FramePiece>& pieces) {
  Packer packer;
  for (const auto& piece : pieces) packer << piece.file << piece.point_arrays << piece.cell_arrays;
  return packer.take();
}

std::vector<FramePiece> pieces_in(const Bytes& bytes) {
  std::vector<FramePiece> pieces;
  Unpacker from(bytes);
  while (!from.done()) {
    auto& piece = pieces.emplace_back();
    from >> piece.file >> piece.point_arrays >> piece.cell_arrays;
  }
  return pieces;
}

/// Takes the folder over at the first frame, or with the frames of a checkpoint.
class VtkFrames final : public FrameSink {
 public:
  VtkFrames(std::filesystem::path folder, const Communicator& ranks)
      : folder_(std::move(folder)), ranks_(ranks) {}

  void write(Real time, const std::vector<BodyView>& bodies, const ContactView* contact) override {
    if (ranks_.alone()) return write_alone(time, bodies, contact);
    const std::size_t number = next();
    const auto written = agreed(ranks_, [&] {
      return packed(write_pieces(folder_, number, ranks_.rank(), time, bodies, contact, memory_));
    });
    agreed(ranks_, [&] {
      if (ranks_.is_root()) join(time, bodies, written);
    });
  }

  std::string index() const override { return writer_ ? writer_->index() : frame_index_text({}); }

  void resume(const std::string& index, const std::filesystem::path& from) override {
    if (ranks_.is_root()) writer_.emplace(folder_, index, from);
  }

 private:
  void write_alone(Real time, const std::vector<BodyView>& bodies, const ContactView* contact) {
    try {
      writer().write(time, bodies, contact);
    } catch (const NoNumberError& error) {
      refuse_frame(error.body, error.field);
    }
  }

  FrameWriter& writer() {
    if (!writer_) writer_.emplace(folder_);
    return *writer_;
  }

  /// The number of the next frame, once the root has the folder ready for pieces.
  std::size_t next() {
    const auto answers = agreed(
        ranks_, [&] { return ranks_.is_root() ? (Packer() << writer().next()).take() : Bytes{}; });
    std::size_t number = 0;
    Unpacker(answers.front()) >> number;
    return number;
  }

  void join(Real time, const std::vector<BodyView>& bodies, const std::vector<Bytes>& written) {
    std::vector<std::string> names;
    names.reserve(bodies.size());
    for (const auto& body : bodies) names.push_back(body.body);
    std::vector<std::vector<FramePiece>> pieces;
    pieces.reserve(written.size());
    for (const Bytes& bytes : written) pieces.push_back(pieces_in(bytes));
    writer().join(time, names, pieces);
  }

  std::filesystem::path folder_;
  const Communicator& ranks_;
  std::optional<FrameWriter> writer_;  // of the root
  VtkFileMemory memory_;               // of the pieces of this rank
};
}  // namespace

std::unique_ptr<FrameSink> make_frame_sink(const std::filesystem::path& folder,
                                           const Communicator& ranks) {
  return std::make_unique<VtkFrames>(folder, ranks);
}
#else
std::unique_ptr<FrameSink> make_frame_sink(const std::filesystem::path&, const Communicator&) {
  return nullptr;
}
#endif

}  // namespace brunt
