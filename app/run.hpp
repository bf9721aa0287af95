#pragma once
#include "app/run_arguments.hpp"

namespace brunt {

/// `brunt run`: deck to folder. Returns the exit status; throws DeckError and MachineError.
int run_command(const RunArguments& arguments);

/// `brunt check`: reads the deck and builds the scene; prints what is wrong or that it is right.
int check_command(const RunArguments& arguments);

/// `brunt plan`: what will be modelled and why, points, elements, memory, step, steps.
int plan_command(const RunArguments& arguments);

}  // namespace brunt
