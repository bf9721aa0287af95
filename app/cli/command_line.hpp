#pragma once

namespace brunt {

/// The whole program: parses the call, runs a command, turns errors into messages and statuses.
int command_line(int argc, char** argv);

}  // namespace brunt
