#pragma once
#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace brunt {

/// The file of this program. Throws MachineError.
std::string own_program();

/// Runs of this program as processes of their own.
class Processes {
 public:
  Processes() = default;
  ~Processes();
  Processes(const Processes&) = delete;
  Processes& operator=(const Processes&) = delete;

  /// Starts a command in a process group of its own, so that a Ctrl-C at the terminal comes to it
  /// through stop() alone. It goes when this process is killed.
  /// words    file that takes what it says on stderr; its stdout goes nowhere
  /// threads  of OpenMP; 0: as the environment says
  /// Throws MachineError.
  void start(std::size_t id, const std::vector<std::string>& command,
             const std::filesystem::path& words, int threads);

  struct Ended {
    std::size_t id = 0;
    int status = 0;  ///< of its exit, or 128 and its signal
  };
  /// One that has ended, if there is one.
  std::optional<Ended> take_ended();
  /// Asks all to stop: a run writes a checkpoint first.
  void stop() const;
  std::vector<std::size_t> running() const;

 private:
  struct Child {
    std::size_t id = 0;
    pid_t process = 0;
  };
  std::vector<Child> children_;
};

}  // namespace brunt
