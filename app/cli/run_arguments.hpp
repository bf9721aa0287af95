#pragma once
#include <optional>
#include <string>
#include <vector>

#include "io/summary.hpp"

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
  bool rehearse = true;              ///< by `plan`: runs with larger sizes, for the steps
  int refine = 0;                    ///< sizes that are run in all; 0: the deck's alone
  std::string refine_key;            ///< what they differ in; empty: found
  std::string restart;               ///< a checkpoint or a folder of them; empty: none
};

}  // namespace brunt
