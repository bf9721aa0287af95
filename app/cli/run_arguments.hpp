#pragma once
#include <optional>
#include <string>
#include <vector>

namespace brunt {

/// What the command line says about a run.
struct RunArguments {
  std::string deck;
  std::vector<std::string> overrides;  ///< "KEY=VALUE" in order
  std::string out;                     ///< empty: <deck>.out beside where brunt was started
  bool force = false;
  bool resume = false;
  bool quiet = false;
  bool json = false;
  int threads = 0;                   ///< 0: OMP_NUM_THREADS, else all cores
  int ranks = 1;                     ///< processes that brunt starts by mpirun
  bool oversubscribe = false;        ///< more ranks than cores
  std::optional<std::string> until;  ///< overrides time.until
  std::string restart;               ///< a checkpoint or a folder of them; empty: none
};

/// Exit statuses (docs/guide/running.md).
enum ExitStatus : int {
  kDone = 0,
  kDeckWrong = 2,
  kPhysicsBroke = 3,
  kMachineFailed = 4,
  kStopped = 5,
};

}  // namespace brunt
