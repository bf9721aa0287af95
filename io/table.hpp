#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "io/summary.hpp"

namespace brunt {

/// What `brunt table` is asked for.
struct TableOptions {
  std::vector<std::string> show;  ///< columns instead of the default ones; see column names below
  bool csv = false;               ///< all digits, commas; else aligned text for people
};

/// One run of a table: its folder and its summary, or why there is none.
struct TableRun {
  std::string folder;
  std::optional<RunSummary> summary;
  std::string problem;  ///< "no folder", "no summary" or "broken summary"
};

/// Reads the summaries of folders; one that is missing or broken is a run with a problem.
std::vector<TableRun> read_runs(const std::vector<std::filesystem::path>& folders);

/// A table with one row a run. By default: the parameters that differ, all measures, wall_seconds,
/// drift, status. A key of show is a parameter, a measure, MEASURE.reference, MEASURE.error,
/// MEASURE.exact, MEASURE.time, MEASURE.bound, phases.NAME, a number or text of summary.json
/// (steps, threads, cpu_seconds, reason, ...), or a column of history.csv, of which the last row is
/// shown; a name that is several of these is the first, and parameters.NAME, measures.NAME or
/// history.NAME say which. What a run does not have is an empty cell. Throws DeckError naming
/// --show where no run has the key.
std::string format_table(const std::vector<TableRun>& runs, const TableOptions& options);

}  // namespace brunt
