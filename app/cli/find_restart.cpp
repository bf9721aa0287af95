#include "app/cli/find_restart.hpp"

#include <cstdio>

#include "app/deck/difference.hpp"
#include "app/deck/findings.hpp"
#include "io/file.hpp"
#include "io/number.hpp"

namespace brunt {

namespace fs = std::filesystem;

namespace {
[[noreturn]] void refuse_call(const fs::path& file, const std::string& message) {
  throw DeckError({{{file.string(), 0, 0}, "", message}});
}

/// Manifests that a name stands for, the one to use first first.
std::vector<fs::path> manifests_for(const fs::path& file) {
  std::error_code error;
  if (!fs::exists(file, error)) refuse_call(file, "there is no such checkpoint");
  if (fs::is_directory(file, error)) {
    auto manifests = checkpoints_in(file);
    if (manifests.empty()) refuse_call(file, "there is no checkpoint in this folder");
    return manifests;
  }
  if (!is_checkpoint_file(file)) {
    refuse_call(file, "is no checkpoint: expects a folder or checkpoint-STEP.manifest");
  }
  const fs::path chosen = manifest_of(file);
  const auto all = checkpoints_in(chosen.parent_path().empty() ? "." : chosen.parent_path());
  std::vector<fs::path> manifests = {chosen};
  for (const auto& other : all) {
    if (other.filename() < chosen.filename()) manifests.push_back(other);
  }
  return manifests;
}

/// Where a run left no checkpoint, the deck that it began with says whose folder it is.
void check_resolved(const fs::path& folder, const LoadedDeck& loaded) {
  const fs::path file = folder / "deck.resolved.yaml";
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return;
  std::vector<DeckProblem> problems;
  for (const auto& difference : deck_differences(read_file(file), loaded.resolved, "folder")) {
    problems.push_back({{file.string(), 0, 0}, "", "is of another deck: " + difference});
  }
  if (!problems.empty()) throw DeckError(problems);
}

[[noreturn]] void refuse_changed(std::vector<DeckProblem> problems) {
  problems.push_back({problems.front().place, "",
                      "--resume goes on with the run of this folder alone; --force too begins it "
                      "anew where the deck has changed"});
  throw DeckError(std::move(problems));
}
}  // namespace

std::unique_ptr<Restart> find_restart(const RunArguments& arguments, const fs::path& folder,
                                      const LoadedDeck& loaded, const Restart::Report& report) {
  if (arguments.resume) {
    try {
      auto own = std::make_unique<Restart>(checkpoints_in(folder), loaded, report);
      if (own->next()) return own;
      check_resolved(folder, loaded);
    } catch (const DeckError& error) {
      if (!arguments.force) refuse_changed(error.problems());
      for (const auto& problem : error.problems()) report(problem.text());
    }
  }
  if (arguments.restart.empty()) return nullptr;
  auto asked = std::make_unique<Restart>(manifests_for(arguments.restart), loaded, report);
  if (asked->next()) return asked;
  throw MachineError("'" + arguments.restart + "' holds no checkpoint that is good");
}

void say_restart(const Restart& restart, const fs::path& folder, bool quiet, spdlog::logger& log) {
  const auto& point = restart.point();
  log.info("goes on from {}, t = {} s", point.manifest.string(), point.header.time);
  if (quiet) return;
  std::fprintf(stderr, "goes on from %s, t = %s; writes to %s\n", point.manifest.c_str(),
               deck::time_text(point.header.time).c_str(), folder.c_str());
}

int verify_command(const std::string& file) {
  auto manifests = manifests_for(file);
  std::error_code unread;
  if (!fs::is_directory(file, unread)) manifests.resize(1);
  int status = kDone;
  for (const auto& manifest : manifests) {
    try {
      const Checkpoint read = read_checkpoint(manifest);
      const StateTables state(read.content.tables);  // no row twice
      std::printf(
          "%s: good; t = %s s, step %llu, %llu rank%s, brunt %s, deck %s\n", manifest.c_str(),
          shortest(read.header.time).c_str(), static_cast<unsigned long long>(read.header.step),
          static_cast<unsigned long long>(read.header.ranks), read.header.ranks == 1 ? "" : "s",
          read.header.program.c_str(), read.header.deck_hash.c_str());
    } catch (const CheckpointError& error) {
      std::fprintf(stderr, "brunt: %s\n", error.what());
      status = kMachineFailed;
    } catch (const StateError& error) {
      std::fprintf(stderr, "brunt: %s\n", CheckpointError(manifest, error.what()).what());
      status = kMachineFailed;
    }
  }
  return status;
}

}  // namespace brunt
