#pragma once
#include <filesystem>
#include <string>

#include "app/run_arguments.hpp"

namespace brunt {

/// What is to be done with a run's output folder.
enum class FolderState { fresh, finished };

/// The folder a run writes to.
std::filesystem::path output_path(const RunArguments& arguments);

/// Makes the folder, once the deck is known to be right. An existing one is refused (DeckError)
/// without force or resume; force takes away what an earlier run wrote there and nothing else.
/// finished: resume found a run that is done with the same resolved deck.
FolderState prepare_output(const std::filesystem::path& folder, const RunArguments& arguments,
                           const std::string& deck_hash);

}  // namespace brunt
