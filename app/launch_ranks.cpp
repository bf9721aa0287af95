#include "app/launch_ranks.hpp"

#include <omp.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
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
  execvp(raw[0], raw.data());
  std::fprintf(stderr, "brunt: cannot start mpirun: %s; is Open MPI installed (openmpi-bin)?\n",
               std::strerror(errno));
  return kMachineFailed;
}

}  // namespace brunt
