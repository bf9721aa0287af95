#include "io/vtk/frame_writer.hpp"

#include <cstdio>
#include <set>

#include "core/errors.hpp"
#include "io/file.hpp"
#include "io/run_files.hpp"
#include "io/vtk/vtp_writer.hpp"
#include "io/vtk/vtu_writer.hpp"

namespace brunt {

namespace {

constexpr const char* kSubfolder = "frames";
constexpr const char* kUnder = "frames/";
constexpr const char* kContact = "contact";

/// A file name for any body name: what is no letter, digit, '-', '_' or '.' becomes %XX.
std::string file_name(const std::string& body, std::size_t frame, const std::string& extension) {
  std::string name;
  for (const char c : body) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       c == '-' || c == '_' || c == '.';
    std::array<char, 4> hex;
    std::snprintf(hex.data(), hex.size(), "%%%02X", static_cast<unsigned char>(c));
    name += plain ? std::string(1, c) : std::string(hex.data());
  }
  std::array<char, 24> number;
  std::snprintf(number.data(), number.size(), ".%05zu", frame);
  return std::string(kSubfolder) + "/" + name + number.data() + extension;
}

bool joins(const std::filesystem::path& file) {
  return file.extension() == ".pvtu" || file.extension() == ".pvtp";
}

/// Links or copies a file; true if it is there in the end.
bool bring(const std::filesystem::path& from, const std::filesystem::path& to) {
  namespace fs = std::filesystem;
  std::error_code error;
  if (!fs::is_regular_file(from, error)) return false;
  if (fs::equivalent(from, to, error)) return true;
  fs::remove(to, error);
  fs::create_hard_link(from, to, error);
  if (error) fs::copy_file(from, to, error);
  if (error) throw MachineError("cannot write '" + to.string() + "': " + error.message());
  return true;
}

/// Brings a part of a frame, with its pieces before what joins them; adds to `brought` what came.
/// True if all of it did.
bool bring_part(const std::filesystem::path& from, const std::filesystem::path& to,
                const std::string& file, std::set<std::string>& brought) {
  std::error_code error;
  std::vector<std::string> files;
  if (joins(file)) {
    if (!std::filesystem::is_regular_file(from / file, error)) return false;
    for (const auto& piece : joined_files(read_file(from / file), (from / file).string())) {
      files.push_back(std::string(kSubfolder) + "/" + piece);
    }
  }
  files.push_back(file);
  bool whole = true;
  list_files(to, files);
  for (const auto& each : files) whole = whole && bring(from / each, to / each);
  if (whole) brought.insert(files.begin(), files.end());
  return whole;
}

}  // namespace

FrameWriter::FrameWriter(std::filesystem::path folder) : folder_(std::move(folder)) {
  create_folder(folder_ / kSubfolder);
  write_frame_index(folder_, {});
  remove_run_files(folder_, kUnder);
}

FrameWriter::FrameWriter(std::filesystem::path folder, const std::string& index,
                         const std::filesystem::path& from)
    : folder_(std::move(folder)) {
  create_folder(folder_ / kSubfolder);
  std::set<std::string> kept;
  for (auto& frame : parse_frame_index(index, "frames of the checkpoint")) {
    ++next_;
    bool whole = true;
    std::set<std::string> brought;
    for (const auto& part : frame.parts) {
      whole = bring_part(from, folder_, part.file, brought) && whole;
    }
    if (!whole) continue;
    kept.merge(brought);
    frames_.push_back(std::move(frame));
  }
  write_frame_index(folder_, frames_);
  remove_run_files(folder_, kUnder, kept);
}

FrameWriter::~FrameWriter() {
  std::error_code not_empty;
  std::filesystem::remove(folder_ / kSubfolder, not_empty);
}

void FrameWriter::add(FrameEntry frame) {
  frames_.push_back(std::move(frame));
  ++next_;
  write_frame_index(folder_, frames_);
}

void FrameWriter::write(Real time, const std::vector<BodyView>& bodies,
                        const ContactView* contact) {
  FrameEntry frame{time, {}};
  std::vector<std::string> files;
  for (const auto& body : bodies) {
    files.push_back(file_name(body.body, next_, ".vtu"));
    frame.parts.push_back({body.body, files.back()});
  }
  if (contact != nullptr) {
    files.push_back(file_name(kContact, next_, ".vtp"));
    frame.parts.push_back({kContact, files.back()});
  }
  list_files(folder_, files);
  try {
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      write_vtu(folder_ / files[b], bodies[b], memory_);
    }
    if (contact != nullptr) {
      write_vtp(folder_ / files.back(), *contact, time, false, memory_);
    }
  } catch (const NoNumberError&) {
    std::error_code none;  // of those that are not there
    for (const auto& file : files) std::filesystem::remove(folder_ / file, none);
    throw;
  }
  add(std::move(frame));
}

void FrameWriter::join(Real time, const std::vector<std::string>& bodies,
                       const std::vector<std::vector<FramePiece>>& pieces) {
  FrameEntry frame{time, {}};
  for (std::size_t p = 0; p < pieces.front().size(); ++p) {
    const bool body = p < bodies.size();
    const std::string name = body ? bodies[p] : kContact;
    frame.parts.push_back({name, file_name(name, next_, body ? ".pvtu" : ".pvtp")});
    std::vector<FramePiece> of_part;
    of_part.reserve(pieces.size());
    std::vector<std::string> files{frame.parts.back().file};
    for (const auto& rank : pieces) {
      of_part.push_back(rank.at(p));
      if (!of_part.back().file.empty()) files.push_back(kUnder + of_part.back().file);
    }
    list_files(folder_, files);
    replace_file(folder_ / frame.parts.back().file,
                 joining_text(body ? "PUnstructuredGrid" : "PPolyData", of_part));
  }
  add(std::move(frame));
}

std::vector<FramePiece> write_pieces(const std::filesystem::path& folder, std::size_t number,
                                     int rank, Real time, const std::vector<BodyView>& bodies,
                                     const ContactView* contact, VtkFileMemory& memory) {
  std::vector<FramePiece> pieces;
  pieces.reserve(bodies.size() + 1);
  const std::string of_rank = "." + std::to_string(rank);
  const auto name = [&](const std::string& file) {
    return std::filesystem::path(file).filename().string();
  };
  for (const auto& body : bodies) {
    auto& piece = pieces.emplace_back();
    const bool empty = body.position.empty(), particles = body.corners == 0;
    // The view of a body without points does not say which fields there are, but of particles.
    if (empty && !(particles && !body.point_fields.empty())) continue;
    piece = listed_arrays(body);
    if (empty) continue;
    const std::string file = file_name(body.body, number, of_rank + ".vtu");
    write_vtu(folder / file, body, memory);
    piece.file = name(file);
  }
  if (contact == nullptr) return pieces;
  auto& piece = pieces.emplace_back(listed_arrays(*contact));
  if (contact->position.empty()) return pieces;
  const std::string file = file_name(kContact, number, of_rank + ".vtp");
  write_vtp(folder / file, *contact, time, true, memory);
  piece.file = name(file);
  return pieces;
}

}  // namespace brunt
// Tested by tests/unit/io/vtk_test.cpp.
