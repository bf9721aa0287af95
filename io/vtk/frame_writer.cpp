#include "io/vtk/frame_writer.hpp"

#include <vtkXMLPolyDataWriter.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <cstdio>
#include <set>

#include "core/errors.hpp"
#include "io/file.hpp"
#include "io/vtk/grid.hpp"
#include "io/vtk/messages.hpp"

namespace brunt {

namespace {

constexpr const char* kSubfolder = "frames";

/// A file name for any body name: what is no letter, digit, '-' or '_' becomes %XX.
std::string file_name(const std::string& body, std::size_t frame, const char* extension) {
  std::string name;
  for (const char c : body) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       c == '-' || c == '_';
    std::array<char, 4> hex;
    std::snprintf(hex.data(), hex.size(), "%%%02X", static_cast<unsigned char>(c));
    name += plain ? std::string(1, c) : std::string(hex.data());
  }
  std::array<char, 24> number;
  std::snprintf(number.data(), number.size(), ".%05zu", frame);
  return std::string(kSubfolder) + "/" + name + number.data() + extension;
}

/// The bytes of a VTK file. VTK writes to memory: to a full disk it would report success.
template <class Writer>
std::string bytes_of(vtkDataObject* data, const std::filesystem::path& path) {
  VtkMessages messages;
  auto writer = vtkSmartPointer<Writer>::New();
  writer->SetInputData(data);
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetCompressorTypeToLZ4();
  writer->SetHeaderTypeToUInt64();
  writer->WriteToOutputStringOn();
  const int written = writer->Write();
  if (written != 1 || messages.any()) {
    throw MachineError("cannot write '" + path.string() + "': " + messages.text());
  }
  return writer->GetOutputString();
}

/// Removes the frames in a folder but those kept.
void remove_frames(const std::filesystem::path& folder, const std::set<std::string>& kept = {}) {
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    const auto extension = entry.path().extension();
    if (kept.count(std::string(kSubfolder) + "/" + entry.path().filename().string())) continue;
    if (extension == ".vtu" || extension == ".vtp") std::filesystem::remove(entry.path(), error);
    if (error) throw MachineError("cannot remove '" + entry.path().string() + "'");
  }
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

}  // namespace

FrameWriter::FrameWriter(std::filesystem::path folder) : folder_(std::move(folder)) {
  create_folder(folder_ / kSubfolder);
  write_frame_index(folder_, {});
  remove_frames(folder_ / kSubfolder);
}

FrameWriter::FrameWriter(std::filesystem::path folder, const std::string& index,
                         const std::filesystem::path& from)
    : folder_(std::move(folder)) {
  create_folder(folder_ / kSubfolder);
  std::set<std::string> kept;
  for (auto& frame : parse_frame_index(index, "frames of the checkpoint")) {
    ++next_;
    bool whole = true;
    for (const auto& part : frame.parts)
      whole = bring(from / part.file, folder_ / part.file) && whole;
    if (!whole) continue;
    for (const auto& part : frame.parts) kept.insert(part.file);
    frames_.push_back(std::move(frame));
  }
  write_frame_index(folder_, frames_);
  remove_frames(folder_ / kSubfolder, kept);
}

void FrameWriter::write(Real time, const std::vector<BodyView>& bodies,
                        const ContactView* contact) {
  FrameEntry frame{time, {}};
  for (const auto& body : bodies) {
    frame.parts.push_back({body.body, file_name(body.body, next_, ".vtu")});
    const auto path = folder_ / frame.parts.back().file;
    write_file_atomically(path, bytes_of<vtkXMLUnstructuredGridWriter>(to_grid(body), path));
  }
  if (contact != nullptr) {
    frame.parts.push_back({"contact", file_name("contact", next_, ".vtp")});
    const auto path = folder_ / frame.parts.back().file;
    write_file_atomically(path, bytes_of<vtkXMLPolyDataWriter>(to_contacts(*contact, time), path));
  }
  frames_.push_back(std::move(frame));
  ++next_;
  write_frame_index(folder_, frames_);
}

}  // namespace brunt
