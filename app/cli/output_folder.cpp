#include "app/cli/output_folder.hpp"

#include "core/errors.hpp"
#include "io/file.hpp"
#include "io/summary.hpp"

namespace brunt {

namespace fs = std::filesystem;

namespace {
[[noreturn]] void refuse(const fs::path& path, const std::string& message) {
  throw DeckError({{{path.string(), 0, 0}, "", message}});
}

/// The type of what a path names, links followed. Throws MachineError where nobody may look.
fs::file_type type_of(const fs::path& path) {
  std::error_code error;
  const auto type = fs::status(path, error).type();
  if (type != fs::file_type::none) return type;
  throw MachineError("cannot use '" + path.string() + "': " + error.message());
}

/// True where a checkpoint, or a folder of them, is of this folder.
bool lies_in(const fs::path& checkpoint, const fs::path& folder) {
  std::error_code error;
  const bool whole = fs::is_directory(checkpoint, error);
  const fs::path parent = checkpoint.has_parent_path() ? checkpoint.parent_path() : ".";
  return fs::equivalent(whole ? checkpoint : parent, folder, error);
}

/// What stands in the way of a run, and what would take it out of there.
std::string exists_text(const fs::path& folder, const std::string& restart) {
  if (restart.empty()) {
    return "the output folder exists; --force replaces it, --resume goes on with its run or skips "
           "it where it is done, --out DIR names another";
  }
  if (lies_in(restart, folder)) {
    return "the output folder holds the run that --restart goes on from; --out DIR leaves it as it "
           "is and writes the whole run to another, --force goes on in it and replaces what was "
           "written after the checkpoint";
  }
  return "the output folder exists, and --restart writes the whole run there; --out DIR names "
         "another, --force replaces what this one holds";
}
}  // namespace

fs::path output_path(const RunArguments& arguments) {
  if (!arguments.out.empty()) return arguments.out;
  return fs::path(arguments.deck).stem().string() + ".out";
}

bool is_finished(const fs::path& folder, const std::string& deck_hash) {
  std::error_code error;
  if (!fs::exists(folder / "summary.json", error)) return false;
  try {
    const RunSummary summary = read_summary(folder);
    return summary.status == kDone && summary.deck_hash == deck_hash;
  } catch (const MachineError&) {
    return false;
  }
}

OutputFolder::OutputFolder(fs::path folder, const RunArguments& arguments)
    : folder_(std::move(folder)) {
  const auto type = type_of(folder_);
  if (type == fs::file_type::not_found) return;
  if (type != fs::file_type::directory) refuse(folder_, "is a file, not an output folder");
  if (!arguments.force && !arguments.resume) {
    refuse(folder_, exists_text(folder_, arguments.restart));
  }
  take();
}

/// Locks the folder, unless something in it would have to make room that is of no run.
void OutputFolder::take() {
  const auto foreign = in_the_way(folder_);
  if (!foreign.empty()) {
    refuse(folder_ / foreign.front(),
           "is in the way: no run of brunt made it; move it, or --out DIR names another folder");
  }
  lock_.emplace(folder_);
}

void OutputFolder::prepare(bool goes_on) {
  if (!lock_) {
    create_folder(folder_);
    take();
    // Made by another run since this one looked, which is over by now.
    if (RunFiles(folder_).has_list())
      refuse(folder_, "another run has just written to this folder");
  }
  if (!goes_on) {
    remove_run_files(folder_);
    return begin_list(folder_, {});
  }
  const RunFiles files(folder_);
  if (!files.has_list()) begin_list(folder_, files.present());  // of a brunt that kept none
  std::error_code error;
  fs::remove(folder_ / "summary.json", error);  // of the run before it went on
  if (error) throw MachineError((folder_ / "summary.json").string() + ": " + error.message());
}

}  // namespace brunt
