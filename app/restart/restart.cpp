#include "app/restart/restart.hpp"

#include <utility>

#include "app/deck/difference.hpp"
#include "io/number.hpp"

namespace brunt {

namespace fs = std::filesystem;

namespace {
void check_deck(const RestartPoint& point, const LoadedDeck& loaded) {
  const auto deck = point.texts.find("deck");
  if (deck == point.texts.end()) throw StateError("the text 'deck' is missing");
  std::vector<DeckProblem> problems;
  const SourcePlace place{point.manifest.string(), 0, 0};
  for (const auto& difference : deck_differences(deck->second, loaded.resolved)) {
    problems.push_back({place, "", "is of another deck: " + difference});
  }
  const auto later = [&](const char* key, Real value) {
    if (loaded.deck.time.real(value) > point.header.time) return;
    problems.push_back(loaded.places.problem(
        key, "expects a time after that of the checkpoint, " + shortest(point.header.time) + " s"));
  };
  later("time.end", loaded.deck.time.end);
  if (loaded.deck.time.until) later("time.until", *loaded.deck.time.until);
  if (!problems.empty()) throw DeckError(problems);
}
}  // namespace

Restart::Restart(std::vector<fs::path> manifests, const LoadedDeck& loaded, Report report)
    : first_(manifests.empty() ? fs::path() : manifests.front()),
      manifests_(manifests.rbegin(), manifests.rend()),
      loaded_(loaded),
      report_(std::move(report)) {}

bool Restart::next() {
  while (!manifests_.empty()) {
    const fs::path manifest = manifests_.back();
    manifests_.pop_back();
    try {
      Checkpoint read = read_checkpoint(manifest);
      point_.emplace(RestartPoint{manifest, read.header,
                                  std::make_unique<StateTables>(std::move(read.content.tables)),
                                  std::move(read.content.texts)});
      check_deck(*point_, loaded_);
      return true;
    } catch (const CheckpointError& error) {
      report_(error.what());
    } catch (const StateError& error) {
      report_(CheckpointError(manifest, error.what()).what());
    }
  }
  return false;
}

bool Restart::lies_in(const fs::path& folder) const {
  std::error_code error;
  return fs::equivalent(point_->folder(), folder, error);
}

void Restart::refuse(const std::string& reason) {
  report_(CheckpointError(point_->manifest, reason).what());
}

}  // namespace brunt
