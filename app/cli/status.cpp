#include "app/cli/status.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>

#include "app/deck/deck.hpp"
#include "app/deck/findings.hpp"
#include "core/errors.hpp"
#include "io/checkpoint.hpp"
#include "io/run_files.hpp"
#include "io/summary.hpp"

namespace brunt {

namespace fs = std::filesystem;

namespace {
/// How far a run is, by the last whole row of its history.
struct LastRow {
  Real time = 0;  ///< [s]
  std::string step;
  std::string drift;
  Real age = 0;  ///< [s] of wall time since the file was written
};

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}

/// The last whole line of a file that may be long, or "". Its end is read alone.
std::string last_line(std::ifstream& file) {
  file.seekg(0, std::ios::end);
  const std::streamoff size = file.tellg();
  for (std::streamoff part = 1 << 14;; part *= 4) {
    const std::streamoff from = std::max<std::streamoff>(0, size - part);
    std::string text(slot_of(size - from), '\0');
    file.seekg(from);
    file.read(text.data(), size - from);
    text.resize(slot_of(file.gcount()));
    file.clear();
    const auto end = text.rfind('\n');
    if (end == std::string::npos && from > 0) continue;
    if (end == std::string::npos || end == 0) return "";
    const auto before = text.rfind('\n', end - 1);
    if (before != std::string::npos) return text.substr(before + 1, end - before - 1);
    if (from == 0) return "";  // the names of the columns alone
  }
}

std::optional<LastRow> last_row_of(const fs::path& folder) {
  const fs::path path = folder / "history.csv";
  std::ifstream file(path, std::ios::binary);
  std::string names;
  if (!file || !std::getline(file, names)) return std::nullopt;
  const auto columns = cells_of(names), cells = cells_of(last_line(file));
  if (cells.size() != columns.size()) return std::nullopt;
  LastRow row;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    if (columns[c] == "time") row.time = std::strtod(cells[c].c_str(), nullptr);
    if (columns[c] == "step") row.step = cells[c];
    if (columns[c] == "energy.drift") row.drift = cells[c];
  }
  std::error_code error;
  const auto written = fs::last_write_time(path, error);
  if (!error) {
    const auto age = fs::file_time_type::clock::now() - written;
    row.age = std::chrono::duration<Real>(age).count();
  }
  return row;
}

/// [s] at which the run ends by its deck.
std::optional<Real> end_of(const fs::path& folder) {
  try {
    const auto& time = load_deck((folder / "deck.resolved.yaml").string(), {}).deck.time;
    return time.real(time.end);
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

std::string age_text(Real seconds) {
  char text[40];
  if (seconds < 100) {
    std::snprintf(text, sizeof text, "%.0f s", std::max(seconds, 0.0));
  } else if (seconds < 6000) {
    std::snprintf(text, sizeof text, "%.0f min", seconds / 60);
  } else {
    std::snprintf(text, sizeof text, "%.1f h", seconds / 3600);
  }
  return text;
}

std::string progress_of(const fs::path& folder) {
  const auto row = last_row_of(folder);
  if (!row) return "no row in history.csv yet";
  std::string text;
  const auto end = end_of(folder);
  if (end && *end > 0) {
    char share[20];
    std::snprintf(share, sizeof share, "%.1f %%  ", 100 * row->time / *end);
    text = share;
  }
  text += deck::time_text(row->time) + (end ? " of " + deck::time_text(*end) : "") + "  step " +
          row->step;
  char drift[40];
  std::snprintf(drift, sizeof drift, "  drift %.1g", std::strtod(row->drift.c_str(), nullptr));
  return text + drift + "  last row " + age_text(row->age) + " ago";
}

std::string checkpoint_of(const fs::path& folder) {
  const auto manifests = checkpoints_in(folder);
  return manifests.empty() ? "no checkpoint" : "latest " + manifests.front().filename().string();
}

/// The line of a folder; "" where it holds no run.
std::string line_of(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error)) return "";
  if (is_locked(folder)) return "running   " + progress_of(folder);
  if (fs::exists(folder / "summary.json", error)) {
    RunSummary summary;
    try {
      summary = read_summary(folder);
    } catch (const MachineError& failure) {
      return std::string("broken    ") + failure.what();
    }
    std::string word = status_word(summary.status);
    word.resize(std::max<std::size_t>(word.size() + 2, 10), ' ');
    return word + progress_of(folder) + (summary.reason.empty() ? "" : "  " + summary.reason);
  }
  if (!RunFiles(folder).has_list() && !fs::exists(folder / "history.csv", error)) return "";
  return "cut off   " + progress_of(folder) + "  " + checkpoint_of(folder) +
         ": brunt run DECK --resume goes on";
}
}  // namespace

int status_command(const std::vector<std::string>& folders) {
  std::size_t width = 0;
  for (const auto& folder : folders) width = std::max(width, folder.size());
  int status = kDone;
  for (const auto& folder : folders) {
    std::string line = line_of(folder);
    if (line.empty()) status = kDeckWrong, line = "holds no run";
    std::printf("%-*s  %s\n", static_cast<int>(width), folder.c_str(), line.c_str());
  }
  return status;
}

}  // namespace brunt
// Tested by tests/cli/status.sh.
