#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "app/trade/front.hpp"
#include "app/trade/variants.hpp"
#include "io/summary.hpp"

namespace brunt {

/// How the runs of a study are started.
struct StudyOptions {
  std::string deck;
  std::filesystem::path out;       ///< a folder of each run in it
  std::filesystem::path words;     ///< folder of what they say on stderr; empty: `out`
  int repeat = 3;                  ///< runs of each variant, of which the cost is taken
  int jobs = 1;                    ///< runs at the same time
  int threads = 1;                 ///< of each; 0: as it is chosen without
  bool force = false;              ///< begins runs of another deck anew
  bool resume = true;              ///< goes on with what was interrupted, skips what is done
  std::vector<std::string> flags;  ///< of each run besides
  std::string checkpoint;  ///< time between checkpoints where the deck has none; empty: as it is
  bool quiet = false;      ///< no progress
  std::string title = "trade";
};

/// What the runs of one variant came to.
struct VariantRuns {
  RunSummary summary;      ///< of the first
  bool done = false;       ///< it ran to its end; else:
  std::string problem;     ///< why not
  Repeated processor;      ///< [s] of all runs that went from start to end in one go
  Repeated memory;         ///< [byte] the same
  bool whole_cost = true;  ///< false: no run went in one go, the cost is scaled from a part
  bool same = true;        ///< all repeats gave the same answer, to the last bit
};

struct StudyResult {
  std::vector<VariantRuns> runs;  ///< of each variant
  bool stopped = false;           ///< by a signal: what has run goes on with the next call
};

/// Runs the variants as processes, each in DIR/FOLDER (repeats in DIR/FOLDER.2, ...), with
/// --resume: what is done is not run again, and what was interrupted goes on. Repeats take turns:
/// all variants once, then all again, so that a machine that is slow for a while is so for all.
StudyResult run_study(const std::vector<Variant>& variants, const StudyOptions& options);

}  // namespace brunt
