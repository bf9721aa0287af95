#include "io/file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include "core/errors.hpp"

namespace brunt {

namespace {

[[noreturn]] void fail(const std::string& action, const std::filesystem::path& path, int error) {
  throw MachineError("cannot " + action + " '" + path.string() + "': " + std::strerror(error) +
                     " (errno " + std::to_string(error) + ")");
}

/// Number of bytes that could be written; all of them unless errno says why not.
std::size_t write_all(int descriptor, std::string_view bytes) {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t n = ::write(descriptor, bytes.data() + done, bytes.size() - done);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) break;
    done += static_cast<std::size_t>(n);
  }
  return done;
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

void replace(const std::filesystem::path& path, std::string_view bytes, bool lasting) {
  TemporaryFile temporary;
  std::string name = path.string() + ".tmp-XXXXXX";
  temporary.descriptor = ::mkostemp(name.data(), O_CLOEXEC);
  if (temporary.descriptor < 0) fail("write", path, errno);
  temporary.name = name;
  const mode_t mask = ::umask(0);  // mkostemp gives 0600; the user's umask is what others expect
  ::umask(mask);
  if (::fchmod(temporary.descriptor, 0666 & ~mask) != 0) fail("write", path, errno);
  if (write_all(temporary.descriptor, bytes) != bytes.size()) fail("write", path, errno);
  if (lasting && ::fsync(temporary.descriptor) != 0) fail("write", path, errno);
  if (::close(std::exchange(temporary.descriptor, -1)) != 0) fail("write", path, errno);
  if (::rename(name.c_str(), path.c_str()) != 0) fail("write", path, errno);
  temporary.name.clear();
  if (lasting) sync_folder(folder_of(path));
}

}  // namespace

void write_file_atomically(const std::filesystem::path& path, std::string_view bytes) {
  replace(path, bytes, true);
}

void replace_file(const std::filesystem::path& path, std::string_view bytes) {
  replace(path, bytes, false);
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
    bytes.append(buffer.data(), static_cast<std::size_t>(n));
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
