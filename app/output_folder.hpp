#pragma once
#include <filesystem>
#include <string>

#include "app/run_arguments.hpp"

namespace brunt {

/// The folder a run writes to.
std::filesystem::path output_path(const RunArguments& arguments);

/// True where the folder holds a summary of a run that is done with the same resolved deck.
bool is_finished(const std::filesystem::path& folder, const std::string& deck_hash);

/// Makes the folder, once the deck is known to be right. An existing one is refused (DeckError)
/// without force or resume; force takes away what an earlier run wrote there and nothing else.
/// goes_on  the run goes on from a checkpoint in this folder: history, frames and checkpoints stay
void prepare_output(const std::filesystem::path& folder, const RunArguments& arguments,
                    bool goes_on);

}  // namespace brunt
