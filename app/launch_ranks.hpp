#pragma once
#include "app/run_arguments.hpp"

namespace brunt {

/// Starts `brunt run` again on arguments.ranks processes by mpirun and becomes it: threads are not
/// bound to cores, ranks share cores only where that was asked for. Returns a status where mpirun
/// cannot be started.
int launch_ranks(const RunArguments& arguments, int argc, char** argv);

}  // namespace brunt
