#include "io/file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <optional>
#include <utility>

#include "core/errors.hpp"

namespace brunt {

namespace {

[[noreturn]] void fail(const std::string& action, const std::filesystem::path& path, int error) {
  throw MachineError("cannot " + action + " '" + path.string() + "': " + std::strerror(error) +
                     " (errno " + std::to_string(error) + ")");
}

/// Number of bytes that could be written; all of them unless errno says why not.
/// at  where, in a file that can be positioned; where none: behind what was written last
std::size_t write_all(int descriptor, std::string_view bytes, std::optional<off_t> at = {}) {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const char* const from = bytes.data() + done;
    const std::size_t left = bytes.size() - done;
    const ssize_t n = at ? ::pwrite(descriptor, from, left, *at + static_cast<off_t>(done))
                         : ::write(descriptor, from, left);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) break;
    done += slot_of(n);
  }
  return done;
}

/// Writes both, one behind the other; false if they could not be written: errno says why.
bool write_both(int descriptor, std::string_view first, std::string_view second) {
  const auto part = [](std::string_view bytes) {
    return iovec{const_cast<char*>(bytes.data()), bytes.size()};
  };
  const std::array<iovec, 2> parts{part(first), part(second)};
  const ssize_t n = ::writev(descriptor, parts.data(), static_cast<int>(parts.size()));
  if (n < 0 && errno != EINTR) return false;
  const std::size_t done = n < 0 ? 0 : slot_of(n), of_first = std::min(done, first.size());
  first.remove_prefix(of_first);
  second.remove_prefix(done - of_first);
  return write_all(descriptor, first) == first.size() &&
         write_all(descriptor, second) == second.size();
}

/// Closes the descriptor and removes the file unless it was released.
struct TemporaryFile {
  std::string name;
  int descriptor = -1;
  ~TemporaryFile() {
    if (descriptor >= 0) ::close(descriptor);
    if (!name.empty()) ::unlink(name.c_str());
  }
};

/// Makes the new name itself durable. Some file systems cannot sync a folder and say EINVAL.
void sync_folder(const std::filesystem::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) fail("open the folder", folder, errno);
  const int error = ::fsync(descriptor) == 0 ? 0 : errno;
  ::close(descriptor);
  if (error != 0 && error != EINVAL) fail("write to the folder", folder, error);
}

std::filesystem::path folder_of(const std::filesystem::path& path) {
  return path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
}

constexpr std::size_t kWaiting = 1 << 18;      // [byte] gathered before they are written
constexpr std::size_t kWorthAWrite = 1 << 14;  // [byte] that are not worth a copy

}  // namespace

ReplacedFile::ReplacedFile(std::filesystem::path path) : path_(std::move(path)) {
  std::string name = path_.string() + ".tmp-XXXXXX";
  descriptor_ = ::mkostemp(name.data(), O_CLOEXEC);
  if (descriptor_ < 0) fail("write", path_, errno);
  temporary_ = name;
  const mode_t mask = ::umask(0);  // mkostemp gives 0600; the user's umask is what others expect
  ::umask(mask);
  if (::fchmod(descriptor_, 0666 & ~mask) == 0) return;
  const int error = errno;  // no destructor follows a constructor that throws
  ::close(descriptor_);
  ::unlink(temporary_.c_str());
  fail("write", path_, error);
}

ReplacedFile::~ReplacedFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void ReplacedFile::flush(std::string_view more) {
  if (!write_both(descriptor_, waiting_, more)) fail("write", path_, errno);
  written_ += waiting_.size() + more.size();
  waiting_.clear();
}

void ReplacedFile::append(std::string_view bytes) {
  if (bytes.size() >= kWorthAWrite) return flush(bytes);
  waiting_ += bytes;
  if (waiting_.size() >= kWaiting) flush();
}

void ReplacedFile::overwrite(std::size_t at, std::string_view bytes) {
  if (at >= written_) {
    waiting_.replace(at - written_, bytes.size(), bytes);
    return;
  }
  flush();
  if (write_all(descriptor_, bytes, static_cast<off_t>(at)) != bytes.size()) {
    fail("write", path_, errno);
  }
}

void ReplacedFile::finish(bool lasting) {
  if (!waiting_.empty() || written_ == 0) flush();
  if (lasting && ::fsync(descriptor_) != 0) fail("write", path_, errno);
  if (::close(std::exchange(descriptor_, -1)) != 0) fail("write", path_, errno);
  if (::rename(temporary_.c_str(), path_.c_str()) != 0) fail("write", path_, errno);
  temporary_.clear();
  if (lasting) sync_folder(folder_of(path_));
}

void write_file_atomically(const std::filesystem::path& path, std::string_view bytes) {
  ReplacedFile file(path);
  file.append(bytes);
  file.finish(true);
}

void replace_file(const std::filesystem::path& path, std::string_view bytes) {
  ReplacedFile file(path);
  file.append(bytes);
  file.finish();
}

std::string read_file(const std::filesystem::path& path) {
  TemporaryFile file;
  file.descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file.descriptor < 0) fail("read", path, errno);
  std::string bytes;
  std::array<char, 65536> buffer;
  while (true) {
    const ssize_t n = ::read(file.descriptor, buffer.data(), buffer.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) fail("read", path, errno);
    if (n == 0) return bytes;
    bytes.append(buffer.data(), slot_of(n));
  }
}

void create_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) fail("make the folder", folder, error.value());
}

LineFile::LineFile(std::filesystem::path path) : path_(std::move(path)) {
  descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (descriptor_ < 0) fail("open", path_, errno);
}

LineFile::~LineFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void LineFile::append(std::string_view lines) {
  struct stat before {};
  if (::fstat(descriptor_, &before) != 0) fail("append to", path_, errno);
  if (write_all(descriptor_, lines) == lines.size()) return;
  const int error = errno;
  if (::ftruncate(descriptor_, before.st_size) != 0) fail("cut back", path_, errno);
  fail("append to", path_, error);
}

void LineFile::flush() {
  // A pipe or a device has nothing to sync and says EINVAL.
  if (::fsync(descriptor_) != 0 && errno != EINVAL) fail("write", path_, errno);
}

}  // namespace brunt
