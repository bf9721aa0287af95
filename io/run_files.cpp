#include "io/run_files.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <string_view>
#include <thread>

#include "core/errors.hpp"
#include "io/checkpoint.hpp"
#include "io/file.hpp"

namespace brunt {

namespace fs = std::filesystem;

namespace {
constexpr std::string_view kHeading =
    "# Files that brunt has made here. --force and --resume take away these and nothing else.\n";
constexpr std::string_view kCheckpoints = "checkpoint-*";
constexpr std::string_view kFrames = "frames/";
/// Pieces that ranks write, each its own: the list has one line for all of them.
constexpr std::string_view kPieces = "frames/*.RANK.*";
constexpr std::array kOfEveryRun = {"deck.resolved.yaml", "log.txt", "history.csv", "summary.json",
                                    "frames.pvd"};

bool is_plain(const fs::path& path) {
  std::error_code error;
  return fs::symlink_status(path, error).type() == fs::file_type::regular;
}

bool all_digits(std::string_view text, std::size_t at_least) {
  const auto digit = [](char c) { return c >= '0' && c <= '9'; };
  return text.size() >= at_least && std::all_of(text.begin(), text.end(), digit);
}

/// What stands behind the last dot, taken off the text; the text itself stays where there is none.
std::string_view take_ending(std::string_view& text) {
  const auto dot = text.rfind('.');
  if (dot == std::string_view::npos) return {};
  const auto ending = text.substr(dot + 1);
  text = text.substr(0, dot);
  return ending;
}

/// "bar.00012.vtu", "bar.00012.3.vtu": what the frames of a run are called.
bool is_frame_name(std::string_view name) {
  const auto type = take_ending(name);
  const bool piece = type == "vtu" || type == "vtp";
  if (!piece && type != "pvtu" && type != "pvtp") return false;
  auto number = take_ending(name);
  if (piece && all_digits(number, 1) && number.size() < 5) number = take_ending(name);
  return all_digits(number, 5) && !name.empty() && name.find('.') == std::string_view::npos;
}

/// "bar.00012.3.vtu": what a rank writes of a frame.
bool is_piece_name(std::string_view name) {
  if (!is_frame_name(name)) return false;
  take_ending(name);
  const auto rank = take_ending(name);
  return all_digits(rank, 1) && rank.size() < 5;
}

bool is_own_name(const std::string& name) {
  if (name.starts_with(kFrames)) return is_frame_name(std::string_view(name).substr(7));
  return std::find(kOfEveryRun.begin(), kOfEveryRun.end(), name) != kOfEveryRun.end() ||
         is_checkpoint_file(name);
}

/// The name of which a temporary is left; others stay as they are.
std::string without_temporary(const std::string& name) {
  constexpr std::size_t kLength = 11;  // .tmp-XXXXXX
  if (name.size() <= kLength || name.compare(name.size() - kLength, 5, ".tmp-") != 0) return name;
  return name.substr(0, name.size() - kLength);
}

std::string to_lines(const std::vector<std::string>& names) {
  std::string lines;
  for (const auto& name : names) lines += name + "\n";
  return lines;
}

bool has_heading(const fs::path& file) {
  std::string begin(kHeading.size(), '\0');
  std::ifstream stream(file, std::ios::binary);
  return is_plain(file) && stream.read(begin.data(), std::ssize(begin)) && begin == kHeading;
}
}  // namespace

void list_files(const fs::path& folder, const std::vector<std::string>& names) {
  const fs::path list = folder / kRunFiles;
  if (has_heading(list)) LineFile(list).append(to_lines(names));
}

void begin_list(const fs::path& folder, const std::vector<std::string>& names) {
  const fs::path list = folder / kRunFiles;
  std::error_code error;
  fs::resize_file(list, 0, error);
  if (error) throw MachineError("cannot write '" + list.string() + "': " + error.message());
  std::string lines(kHeading);
  lines += to_lines({kOfEveryRun.begin(), kOfEveryRun.end()});
  lines.append(kCheckpoints).push_back('\n');
  lines.append(kPieces).push_back('\n');
  LineFile(list).append(lines + to_lines(names));
}

RunFiles::RunFiles(fs::path folder) : folder_(std::move(folder)) {
  const fs::path list = folder_ / kRunFiles;
  if (is_plain(list)) {
    const std::string text = read_file(list);
    std::string_view rest(text);
    if (rest.starts_with(kHeading)) {
      listed_.emplace();
      rest.remove_prefix(kHeading.size());
      for (auto end = rest.find('\n'); end != std::string_view::npos; end = rest.find('\n')) {
        listed_->emplace(rest.substr(0, end));
        rest.remove_prefix(end + 1);
      }
      return;
    }
  }
  old_run_ = is_plain(folder_ / "deck.resolved.yaml") || is_plain(folder_ / "frames.pvd");
}

bool RunFiles::own(const std::string& name) const {
  if (!is_plain(folder_ / name)) return false;
  const std::string meant = without_temporary(name);
  if (!listed_) return old_run_ && is_own_name(meant);
  return listed_->contains(meant) ||
         (listed_->contains(std::string(kCheckpoints)) && is_checkpoint_file(meant)) ||
         (listed_->contains(std::string(kPieces)) && meant.starts_with(kFrames) &&
          is_piece_name(std::string_view(meant).substr(kFrames.size())));
}

std::vector<std::string> RunFiles::present() const {
  std::vector<std::string> names;
  std::error_code error;
  for (const std::string_view part : {std::string_view(), kFrames}) {
    const fs::path inside = part.empty() ? folder_ : folder_ / "frames";
    if (!part.empty() && fs::symlink_status(inside, error).type() != fs::file_type::directory) {
      continue;
    }
    auto entry = fs::directory_iterator(inside, error);
    for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
      std::string name = std::string(part) + entry->path().filename().string();
      if (own(name)) names.push_back(std::move(name));
    }
    if (error) throw MachineError("cannot read '" + inside.string() + "': " + error.message());
  }
  return names;
}

std::vector<std::string> in_the_way(const fs::path& folder) {
  const RunFiles files(folder);
  std::vector<std::string> foreign;
  const auto type = [&](const char* name) {
    std::error_code error;
    return fs::symlink_status(folder / name, error).type();
  };
  for (const char* name : kOfEveryRun) {
    if (type(name) != fs::file_type::not_found && !files.own(name)) foreign.emplace_back(name);
  }
  const auto frames = type("frames"), list = type(kRunFiles);
  if (frames != fs::file_type::not_found && frames != fs::file_type::directory) {
    foreign.emplace_back("frames");
  }
  // An empty one is of a run that ended before it began its list.
  std::error_code error;
  const bool begun = list == fs::file_type::regular &&
                     (fs::is_empty(folder / kRunFiles, error) || has_heading(folder / kRunFiles));
  if (list != fs::file_type::not_found && !begun) foreign.emplace_back(kRunFiles);
  return foreign;
}

void remove_run_files(const fs::path& folder, const std::string& under,
                      const std::set<std::string>& kept) {
  for (const auto& name : RunFiles(folder).present()) {
    if (!name.starts_with(under) || kept.contains(name)) continue;
    std::error_code error;
    fs::remove(folder / name, error);
    if (error) {
      throw MachineError("cannot remove '" + (folder / name).string() + "': " + error.message());
    }
  }
}

namespace {
constexpr int kAttempts = 5;
}  // namespace

FolderLock::FolderLock(const fs::path& folder) {
  const fs::path file = folder / kRunFiles;
  descriptor_ = ::open(file.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666);
  if (descriptor_ < 0) {
    throw MachineError("cannot open '" + file.string() + "': " + std::strerror(errno));
  }
  // Who only asks whether a run is there (is_locked) holds it for some microseconds.
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    if (attempt > 0) std::this_thread::sleep_for(std::chrono::milliseconds(20));
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0) return;
    if (errno != EWOULDBLOCK) break;
  }
  const int error = errno;
  if (error == EWOULDBLOCK) {
    ::close(descriptor_);
    throw DeckError({{{folder.string(), 0, 0},
                      "",
                      "another run is writing to this folder: wait for its end, or --out DIR names "
                      "another"}});
  }
  std::fprintf(stderr, "warning: %s cannot be locked (%s): let no other run write to this folder\n",
               file.c_str(), std::strerror(error));
}

FolderLock::~FolderLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

bool is_locked(const fs::path& folder) {
  const int descriptor =
      ::open((folder / kRunFiles).c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0) return false;
  const bool locked = ::flock(descriptor, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  ::close(descriptor);
  return locked;
}

}  // namespace brunt
// Tested by tests/cli/folder.sh.
