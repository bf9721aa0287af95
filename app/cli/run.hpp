#pragma once
#include "app/cli/run_arguments.hpp"
#include "core/parallel/communicator.hpp"

namespace brunt {

/// `brunt run`: deck to folder, by all ranks. Returns the exit status, the same on all ranks;
/// throws DeckError and MachineError, perhaps on one rank only.
int run_command(const RunArguments& arguments, const Communicator& ranks);

/// `brunt check`: reads the deck and builds the scene; prints what is wrong or that it is right.
int check_command(const RunArguments& arguments);

/// `brunt plan`: what will be modelled and why, points, elements, memory, step, steps.
int plan_command(const RunArguments& arguments);

}  // namespace brunt
