#include "app/report/report.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "app/deck/deck.hpp"
#include "app/report/page.hpp"
#include "core/errors.hpp"
#include "io/file.hpp"
#include "io/run_files.hpp"

namespace brunt {

namespace fs = std::filesystem;

namespace {
constexpr const char* kName = "report.html";
constexpr std::size_t kMostPictures = 8;

/// The title of the deck that a run resolved; the folder's name where it has none.
std::string title_of(const fs::path& folder) {
  std::string title;
  try {
    title = load_deck((folder / "deck.resolved.yaml").string(), {}).deck.title;
  } catch (const std::exception&) {  // an older deck: the page does without
  }
  return title.empty() ? fs::absolute(folder).lexically_normal().filename().string() : title;
}

/// At most eight of the pictures of a folder, evenly from the first to the last.
std::vector<std::pair<std::string, std::string>> pictures_in(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& name : RunFiles(folder).present()) {
    if (name.ends_with(".png")) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  std::vector<std::pair<std::string, std::string>> pictures;
  const std::size_t n = std::min(names.size(), kMostPictures);
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t at = n == 1 ? names.size() - 1 : k * (names.size() - 1) / (n - 1);
    pictures.emplace_back(names[at], read_file(folder / names[at]));
  }
  return pictures;
}

/// Writes the page of a folder; says why where there is none.
bool write_report(const fs::path& folder) {
  std::error_code error;
  if (is_locked(folder) || !fs::exists(folder / "summary.json", error)) {
    std::fprintf(stderr, "%s: holds no run that has ended; `brunt status` says how far it is\n",
                 folder.c_str());
    return false;
  }
  RunReport report;
  report.summary = read_summary(folder);
  report.title = title_of(folder);
  if (fs::exists(folder / "history.csv", error)) {
    report.history = read_history(folder / "history.csv");
  }
  report.deck = read_file(folder / "deck.resolved.yaml");
  report.pictures = pictures_in(folder);
  list_files(folder, {kName});
  replace_file(folder / kName, html_page(report));
  std::printf("%s\n", (folder / kName).c_str());
  return true;
}
}  // namespace

int report_command(const std::vector<std::string>& folders) {
  bool all = true;
  for (const auto& folder : folders) all = write_report(folder) && all;
  return all ? kDone : kDeckWrong;
}

}  // namespace brunt
// Tested by tests/cli/report.sh.
