#include "app/output_folder.hpp"

#include <array>

#include "core/errors.hpp"
#include "io/checkpoint.hpp"
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
  if (is_checkpoint_file(path) || path.extension().string().starts_with(".tmp-")) return true;
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

}  // namespace

fs::path output_path(const RunArguments& arguments) {
  if (!arguments.out.empty()) return arguments.out;
  return fs::path(arguments.deck).stem().string() + ".out";
}

bool is_finished(const fs::path& folder, const std::string& deck_hash) {
  if (!fs::exists(folder / "summary.json")) return false;
  try {
    const RunSummary summary = read_summary(folder);
    return summary.status == kDone && summary.deck_hash == deck_hash;
  } catch (const MachineError&) {
    return false;
  }
}

void prepare_output(const fs::path& folder, const RunArguments& arguments, bool goes_on) {
  if (fs::exists(folder)) {
    if (!arguments.force && !arguments.resume) {
      throw DeckError({{{folder.string(), 0, 0},
                        "",
                        "the output folder exists; --force replaces it, --resume goes on with its "
                        "run or skips it where it is done, --out DIR names another"}});
    }
    if (!fs::is_directory(folder)) {
      throw DeckError({{{folder.string(), 0, 0}, "", "is a file, not an output folder"}});
    }
    if (goes_on) {
      std::error_code error;
      fs::remove(folder / "summary.json", error);  // of the run before it went on
      if (error) throw MachineError((folder / "summary.json").string() + ": " + error.message());
    } else {
      clear(folder);
    }
  }
  create_folder(folder);
}

}  // namespace brunt
