#include "app/cli/launch_ranks.hpp"

#include <fcntl.h>
#include <omp.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace brunt {

namespace {
/// The command line without what was for this process only.
std::vector<std::string> own_arguments(int argc, char** argv) {
  std::vector<std::string> kept;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--ranks") {
      ++i;
    } else if (!argument.starts_with("--ranks=") && argument != "--oversubscribe") {
      kept.push_back(argument);
    }
  }
  return kept;
}

/// True where something else than this machine says how many processes there may be.
bool has_resource_manager() {
  for (const char* job : {"SLURM_JOB_ID", "PBS_JOBID", "LSB_JOBID", "JOB_ID"}) {
    if (std::getenv(job) != nullptr) return true;
  }
  return false;
}

/// Signals that a launcher passes on.
sigset_t watched_signals() {
  sigset_t set;
  sigemptyset(&set);
  for (const int signal : {SIGUSR1, SIGUSR2, SIGTERM, SIGINT, SIGHUP, SIGCHLD}) {
    struct sigaction now {};
    // Who started the run with nohup wants it to outlive the terminal.
    const bool kept =
        signal != SIGHUP || sigaction(signal, nullptr, &now) != 0 || now.sa_handler != SIG_IGN;
    if (kept) sigaddset(&set, signal);
  }
  return set;
}

/// Becomes mpirun, in a process group of its own: a Ctrl-C at the terminal would go to it too. It
/// goes when this launcher is killed.
[[noreturn]] void become(const std::vector<char*>& command, const sigset_t& mask) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  // Outside the terminal's group nothing may be read from it; ranks read no input.
  const int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC);
  if (nothing >= 0) dup2(nothing, STDIN_FILENO);
  sigprocmask(SIG_SETMASK, &mask, nullptr);
  std::signal(SIGPIPE, SIG_DFL);
  execvp(command[0], command.data());
  std::fprintf(stderr, "brunt: cannot start mpirun: %s; is Open MPI installed (openmpi-bin)?\n",
               std::strerror(errno));
  _exit(kMachineFailed);
}

/// The status of a run from how mpirun ended. `stopped`: it was asked to.
int status_of(int ended, bool stopped) {
  const int status = WIFEXITED(ended) ? WEXITSTATUS(ended) : -1;
  for (const int known : {kDone, kDeckWrong, kPhysicsBroke, kMachineFailed, kStopped}) {
    if (status == known) return status;
  }
  if (stopped) {
    std::fprintf(stderr, "brunt: stopped by a signal before the ranks could write a checkpoint\n");
    return kStopped;
  }
  std::fprintf(stderr, "brunt: mpirun ended with %s %d\n", status < 0 ? "signal" : "status",
               status < 0 ? WTERMSIG(ended) : status);
  return kMachineFailed;
}

/// Starts mpirun and waits for it. What asks for the end reaches the ranks as SIGUSR2: mpirun takes
/// SIGTERM for its own and kills them after a second, before large checkpoints are written. A
/// second one is passed on as it is.
int watch(const std::vector<char*>& command) {
  const sigset_t signals = watched_signals();
  sigset_t before;
  sigprocmask(SIG_BLOCK, &signals, &before);
  const pid_t child = fork();
  if (child == 0) become(command, before);
  if (child < 0) {
    std::fprintf(stderr, "brunt: cannot start mpirun: %s\n", std::strerror(errno));
    return kMachineFailed;
  }
  bool stopped = false;
  while (true) {
    int ended = 0;
    const pid_t done = waitpid(child, &ended, WNOHANG);
    if (done == child) return status_of(ended, stopped);
    if (done < 0 && errno != EINTR) return kMachineFailed;
    int signal = 0;
    if (sigwait(&signals, &signal) != 0 || signal == SIGCHLD) continue;
    const bool ends = signal != SIGUSR1;
    kill(child, !ends ? SIGUSR1 : stopped ? SIGTERM : SIGUSR2);
    stopped = stopped || ends;
  }
}
}  // namespace

int launch_ranks(const RunArguments& arguments, int argc, char** argv) {
  const std::string ranks = std::to_string(arguments.ranks);
  // Open MPI binds each rank to a core by default, all of its threads with it.
  std::vector<std::string> command = {"mpirun", "-n", ranks, "--bind-to", "none"};
  if (!has_resource_manager()) {
    if (!arguments.oversubscribe && arguments.ranks > omp_get_num_procs()) {
      std::fprintf(stderr,
                   "brunt: --ranks %d is more than the %d processors of this machine; "
                   "--oversubscribe runs them all the same, slower\n",
                   arguments.ranks, omp_get_num_procs());
      return kDeckWrong;
    }
    // brunt says itself what went wrong; mpirun would add how it ended the others.
    command.insert(command.end(), {"--quiet", "--use-hwthread-cpus"});
    // Ranks of one machine talk through its memory; Open MPI would look for networks for 0.2 s
    // first.
    command.insert(command.end(), {"--mca", "pml", "ob1", "--mca", "btl", "self,vader"});
  }
  if (arguments.oversubscribe) {
    command.insert(command.end(), {"--oversubscribe", "--mca", "mpi_yield_when_idle", "1"});
  }
  if (arguments.oversubscribe || arguments.ranks * arguments.threads > omp_get_num_procs()) {
    // Threads that wait leave their core to those of other ranks: ten times as fast.
    setenv("OMP_WAIT_POLICY", "passive", 0);
  }
  if (geteuid() == 0) {  // in a container there is often nobody else
    setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", 0);
    setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", 0);
  }
  if (arguments.threads == 0 && std::getenv("OMP_NUM_THREADS") == nullptr) {
    const int each = std::max(1, omp_get_num_procs() / arguments.ranks);
    setenv("OMP_NUM_THREADS", std::to_string(each).c_str(), 0);
  }
  std::array<char, 4096> self{};
  if (readlink("/proc/self/exe", self.data(), self.size() - 1) < 0) {
    std::fprintf(stderr, "brunt: cannot find its own program: %s\n", std::strerror(errno));
    return kMachineFailed;
  }
  command.emplace_back(self.data());
  for (auto& argument : own_arguments(argc, argv)) command.push_back(std::move(argument));
  std::vector<char*> raw;
  raw.reserve(command.size() + 1);
  for (auto& argument : command) raw.push_back(argument.data());
  raw.push_back(nullptr);
  return watch(raw);
}

}  // namespace brunt
