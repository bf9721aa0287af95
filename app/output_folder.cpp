#include "app/output_folder.hpp"

#include <array>

#include "core/errors.hpp"
#include "io/file.hpp"
#include "io/summary.hpp"

namespace brunt {

namespace fs = std::filesystem;

namespace {
/// True for names that a run of brunt writes into its folder.
bool written_by_brunt(const fs::path& path) {
  static constexpr std::array names = {"deck.resolved.yaml", "log.txt", "history.csv",
                                       "summary.json", "frames.pvd"};
  static constexpr std::array endings = {".vtu", ".vtp", ".png"};
  const std::string name = path.filename().string();
  for (const char* known : names) {
    if (name == known) return true;
  }
  for (const char* ending : endings) {
    if (path.extension() == ending) return true;
  }
  return false;
}

void clear(const fs::path& folder) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.is_regular_file() && written_by_brunt(entry.path())) {
      fs::remove(entry.path(), error);
      if (error) throw MachineError(entry.path().string() + ": " + error.message());
    }
  }
}

/// True where the folder holds a summary of a run that is done with the same deck.
bool is_finished(const fs::path& folder, const std::string& deck_hash) {
  if (!fs::exists(folder / "summary.json")) return false;
  try {
    const RunSummary summary = read_summary(folder);
    return summary.status == kDone && summary.deck_hash == deck_hash;
  } catch (const MachineError&) {
    return false;
  }
}
}  // namespace

fs::path output_path(const RunArguments& arguments) {
  if (!arguments.out.empty()) return arguments.out;
  return fs::path(arguments.deck).stem().string() + ".out";
}

FolderState prepare_output(const fs::path& folder, const RunArguments& arguments,
                           const std::string& deck_hash) {
  if (fs::exists(folder)) {
    if (arguments.resume && is_finished(folder, deck_hash)) return FolderState::finished;
    if (!arguments.force && !arguments.resume) {
      throw DeckError({{{folder.string(), 0, 0},
                        "",
                        "the output folder exists; --force replaces it, --resume skips a run that "
                        "is done, --out DIR names another"}});
    }
    if (!fs::is_directory(folder)) {
      throw DeckError({{{folder.string(), 0, 0}, "", "is a file, not an output folder"}});
    }
    clear(folder);
  }
  create_folder(folder);
  return FolderState::fresh;
}

}  // namespace brunt
