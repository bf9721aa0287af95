#pragma once
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

#include "app/deck/deck.hpp"
#include "io/checkpoint.hpp"

namespace brunt {

/// A checkpoint that was read whole and fits the deck.
struct RestartPoint {
  std::filesystem::path manifest;
  CheckpointHeader header;
  std::unique_ptr<StateTables> state;
  std::map<std::string, std::string> texts;
  std::filesystem::path folder() const {
    return manifest.has_parent_path() ? manifest.parent_path() : std::filesystem::path(".");
  }
};

/// Where a run goes on: the latest good checkpoint of those it may use.
class Restart {
 public:
  using Report = std::function<void(const std::string&)>;
  /// manifests  the one to use first, then those to fall back to
  /// report  takes each that is refused, and why
  Restart(std::vector<std::filesystem::path> manifests, const LoadedDeck& loaded, Report report);

  /// Reads the next good one; false where there is none. Throws DeckError where the deck is not
  /// that of the checkpoint, with all that differs, or ends before it.
  bool next();
  /// The one that was read last.
  const RestartPoint& point() const { return *point_; }
  /// True if it lies in this folder.
  bool lies_in(const std::filesystem::path& folder) const;
  /// The one that was to be used first: those after it in its folder are of steps that are taken
  /// anew.
  const std::filesystem::path& first() const { return first_; }
  /// Reports that the last one did not fit, after all.
  void refuse(const std::string& reason);

 private:
  std::filesystem::path first_;
  std::vector<std::filesystem::path> manifests_;  // the next one last
  const LoadedDeck& loaded_;
  Report report_;
  std::optional<RestartPoint> point_;
};

}  // namespace brunt
