#pragma once
#include "app/cli/run_arguments.hpp"

namespace brunt {

/// Starts `brunt run` again on arguments.ranks processes by mpirun and waits for its end: threads
/// are not bound to cores, ranks share cores only where that was asked for. Signals that ask for
/// the end reach the ranks, which write a checkpoint. Returns the run's status, 4 where mpirun
/// cannot be started.
int launch_ranks(const RunArguments& arguments, int argc, char** argv);

}  // namespace brunt
