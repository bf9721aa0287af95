#pragma once
#include <spdlog/logger.h>

#include <filesystem>
#include <memory>
#include <string>

#include "app/cli/run_arguments.hpp"
#include "app/restart/restart.hpp"

namespace brunt {

/// What the command line asks for: the latest of the folder with --resume, then --restart FILE (a
/// manifest, a part or a folder) and those before it. None: the run starts at time 0. Throws
/// DeckError where the file is not there or the deck differs; MachineError where --restart finds
/// none that is good.
std::unique_ptr<Restart> find_restart(const RunArguments& arguments,
                                      const std::filesystem::path& folder, const LoadedDeck& loaded,
                                      const Restart::Report& report);

/// Where a run goes on and where it writes, on the log and, unless quiet, on stderr.
void say_restart(const Restart& restart, const std::filesystem::path& folder, bool quiet,
                 spdlog::logger& log);

/// `brunt verify FILE`: reads checkpoints whole and says what they hold or what is wrong. 0: all of
/// them are good, and there is one.
int verify_command(const std::string& file);

}  // namespace brunt
