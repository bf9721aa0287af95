#pragma once
#include <string>
#include <vector>

namespace brunt {

/// `brunt status DIR...`: a line each of how far a run is or how it ended. Reads only, while runs
/// write. 0; kDeckWrong where a folder holds no run.
int status_command(const std::vector<std::string>& folders);

}  // namespace brunt
