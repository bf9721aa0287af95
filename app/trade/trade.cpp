#include "app/trade/trade.hpp"

#include <cstdio>
#include <filesystem>

#include "app/loop/signals.hpp"
#include "app/trade/chart.hpp"
#include "app/trade/report.hpp"
#include "app/trade/results.hpp"
#include "app/trade/study.hpp"
#include "app/trade/variants.hpp"
#include "io/file.hpp"
#ifdef BRUNT_VTK
#include "io/vtk/drawing_png.hpp"
#endif

namespace brunt {

namespace fs = std::filesystem;

namespace {
std::optional<Against> against_of(const std::string& word) {
  for (const Against against : {Against::exact, Against::finest, Against::reference}) {
    if (word == against_word(against)) return against;
  }
  return std::nullopt;
}

/// A picture that cannot be drawn is a warning: the drawing is there as SVG.
void write_png(const fs::path& path, [[maybe_unused]] const Drawing& drawing) {
#ifdef BRUNT_VTK
  try {
    write_file_atomically(path, to_png(drawing));
  } catch (const MachineError& error) {
    std::fprintf(stderr, "warning: %s: %s\n", path.c_str(), error.what());
  }
#else
  std::fprintf(stderr, "warning: %s is not drawn: this brunt was built without VTK\n",
               path.c_str());
#endif
}

/// The deck's measures, without which nothing is traded.
void require_measures(const std::vector<Variant>& variants, const std::string& deck) {
  if (!variants.front().loaded.deck.measures.empty()) return;
  throw DeckError({{{deck, 0, 0},
                    "measures",
                    "the deck has none: a trade is of their errors against what runs cost"}});
}

int status_of_study(const StudyResult& study) {
  if (study.stopped) return kStopped;
  for (const auto& runs : study.runs) {
    if (!runs.done) return kPhysicsBroke;
  }
  return kDone;
}

void warn_of_runs(const Trade& trade) {
  for (const auto& row : trade.rows) {
    if (!row.runs.done) {
      std::fprintf(stderr, "warning: %s did not run to its end: %s\n", row.label.c_str(),
                   row.runs.problem.c_str());
    } else if (!row.runs.same) {
      std::fprintf(stderr, "warning: %s: its repeats gave different answers\n", row.label.c_str());
    }
  }
}
}  // namespace

int trade_command(const TradeArguments& arguments) {
  const auto varies = read_varies(arguments.vary);
  const auto variants =
      make_variants(arguments.deck, arguments.overrides, varies,
                    arguments.one_at_a_time ? Design::one_at_a_time : Design::grid);
  require_measures(variants, arguments.deck);
  StudyOptions options;
  options.deck = arguments.deck;
  options.out = arguments.out;
  if (options.out.empty()) options.out = fs::path(arguments.deck).stem().string() + ".trade";
  options.repeat = arguments.repeat;
  options.jobs = arguments.jobs;
  options.threads = arguments.threads;
  options.force = arguments.force;
  options.quiet = arguments.quiet;
  // A run that is killed goes on from where it was half a minute ago; no bit changes.
  options.checkpoint = "30 s";
  listen_to_signals();
  const StudyResult study = run_study(variants, options);
  if (study.stopped) {
    std::fprintf(stderr,
                 "brunt: stopped; the same call goes on from there, what is done is not run "
                 "again\n");
    return kStopped;
  }
  const Trade trade = evaluate_trade(variants, varies, study, against_of(arguments.against));
  const std::string json = trade_json(trade);
  write_file_atomically(options.out / "trade.json", json);
  write_file_atomically(options.out / "trade.csv", trade_csv(trade));
  if (trade.finest) {
    const Drawing chart = trade_chart(trade);
    write_file_atomically(options.out / "trade.svg", to_svg(chart));
    write_png(options.out / "trade.png", chart);
  }
  std::fputs(arguments.json ? json.c_str() : trade_text(trade).c_str(), stdout);
  warn_of_runs(trade);
  if (!arguments.quiet) {
    std::fprintf(stderr, "%s holds trade.csv, trade.json, trade.svg and trade.png\n",
                 options.out.c_str());
  }
  return status_of_study(study);
}

}  // namespace brunt
// Tested by tests/cli/trade.sh.
