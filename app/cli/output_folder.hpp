#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "app/cli/run_arguments.hpp"
#include "io/run_files.hpp"

namespace brunt {

/// The folder a run writes to.
std::filesystem::path output_path(const RunArguments& arguments);

/// True where the folder holds a summary of a run that is done with the same resolved deck.
bool is_finished(const std::filesystem::path& folder, const std::string& deck_hash);

/// The folder a run writes to, as the root of all ranks holds it: locked from the first look at
/// what stands in it to the end of the run.
class OutputFolder {
 public:
  /// Locks a folder that exists. Throws DeckError where neither force nor resume was asked for,
  /// where another run holds it, and where a file in it that no run made would be replaced.
  OutputFolder(std::filesystem::path folder, const RunArguments& arguments);
  /// Makes and locks one that did not, once the deck is known to be right, and takes away what an
  /// earlier run made there and nothing else.
  /// goes_on  from a checkpoint in this folder: history, frames and checkpoints stay
  void prepare(bool goes_on);

 private:
  void take();

  std::filesystem::path folder_;
  std::optional<FolderLock> lock_;
};

}  // namespace brunt
