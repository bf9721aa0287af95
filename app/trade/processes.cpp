#include "app/trade/processes.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>

#include "core/errors.hpp"

namespace brunt {

namespace {
/// Becomes the command; between fork and exec nothing may allocate.
[[noreturn]] void become_run(char* const* command, int words) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  const int nothing = open("/dev/null", O_RDWR | O_CLOEXEC);
  if (nothing >= 0) dup2(nothing, STDIN_FILENO), dup2(nothing, STDOUT_FILENO);
  dup2(words, STDERR_FILENO);
  std::signal(SIGPIPE, SIG_DFL);
  execv(command[0], command);
  _exit(127);
}
}  // namespace

std::string own_program() {
  std::array<char, 4096> self{};
  if (readlink("/proc/self/exe", self.data(), self.size() - 1) < 0) {
    throw MachineError(std::string("cannot find its own program: ") + std::strerror(errno));
  }
  return self.data();
}

Processes::~Processes() {
  stop();
  for (const auto& child : children_) waitpid(child.process, nullptr, 0);
}

void Processes::start(std::size_t id, const std::vector<std::string>& command,
                      const std::filesystem::path& words, int threads) {
  const int file = open(words.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) throw MachineError("cannot write '" + words.string() + "': " + strerror(errno));
  std::vector<std::string> copy = command;
  std::vector<char*> raw;
  raw.reserve(copy.size() + 1);
  for (auto& argument : copy) raw.push_back(argument.data());
  raw.push_back(nullptr);
  if (threads > 0) setenv("OMP_NUM_THREADS", std::to_string(threads).c_str(), 1);
  const pid_t child = fork();
  if (child == 0) become_run(raw.data(), file);
  const int error = errno;
  close(file);
  if (child < 0) throw MachineError(std::string("cannot start a run: ") + std::strerror(error));
  children_.push_back({id, child});
}

std::optional<Processes::Ended> Processes::take_ended() {
  for (auto child = children_.begin(); child != children_.end(); ++child) {
    int ended = 0;
    const pid_t done = waitpid(child->process, &ended, WNOHANG);
    if (done == 0 || (done < 0 && errno == EINTR)) continue;
    const Ended result{child->id, WIFEXITED(ended) ? WEXITSTATUS(ended) : 128 + WTERMSIG(ended)};
    children_.erase(child);
    return result;
  }
  return std::nullopt;
}

void Processes::stop() const {
  for (const auto& child : children_) kill(child.process, SIGTERM);
}

std::vector<std::size_t> Processes::running() const {
  std::vector<std::size_t> ids;
  for (const auto& child : children_) ids.push_back(child.id);
  return ids;
}

}  // namespace brunt
// Tested by tests/cli/trade.sh.
