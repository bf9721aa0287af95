#include "app/cli/command_line.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>
#include <thread>

#include "app/cli/find_restart.hpp"
#include "app/cli/launch_ranks.hpp"
#include "app/cli/output_folder.hpp"
#include "app/cli/pictures.hpp"
#include "app/cli/reference.hpp"
#include "app/cli/run.hpp"
#include "app/cli/status.hpp"
#include "app/deck/deck.hpp"
#include "app/report/report.hpp"
#include "app/trade/refine.hpp"
#include "app/trade/trade.hpp"
#include "core/errors.hpp"
#include "io/deck/suggest.hpp"
#include "io/table.hpp"

namespace brunt {

namespace {
void add_deck(CLI::App* command, RunArguments& arguments) {
  command->add_option("DECK", arguments.deck, "the deck, a YAML file")
      ->required()
      ->option_text(" ");
  command
      ->add_option("--set", arguments.overrides,
                   "overrides a key: --set 'bodies.bar.velocity=[0, 0, -200 m/s]'; again for more")
      ->option_text("KEY=VALUE")
      ->allow_extra_args(false);
}

CLI::App* add_plan(CLI::App& app, RunArguments& arguments) {
  auto* plan = app.add_subcommand("plan", "says what will be modelled and what it costs");
  add_deck(plan, arguments);
  plan->add_flag_callback(
      "--no-rehearsal", [&] { arguments.rehearse = false; },
      "takes no time for runs with larger elements: a range of steps where they flatten");
  return plan;
}

/// Refuses what a variable without a value leaves in a script: --out "", and --out= before another
/// option, which would be taken for the value.
CLI::Validator value_given() {
  const auto problem = [](const std::string& text) -> std::string {
    if (text.empty()) return "is empty";
    return text.starts_with("--") ? "has no value but the option '" + text + "'" : "";
  };
  return {problem, "", "a value"};
}

CLI::App* add_run(CLI::App& app, RunArguments& arguments) {
  auto* run = app.add_subcommand("run", "runs a deck");
  add_deck(run, arguments);
  run->add_option("--out", arguments.out, "output folder; default: the deck's name and .out")
      ->option_text("DIR")
      ->check(value_given());
  run->add_flag("--force", arguments.force, "replaces what an earlier run wrote there");
  run->add_flag("--resume", arguments.resume,
                "goes on from the latest good checkpoint; skips a run that is done");
  run->add_option("--threads", arguments.threads, "threads; default: OMP_NUM_THREADS or all cores")
      ->option_text("N")
      ->check(CLI::Range(1, 4096));
  run->add_option("--ranks", arguments.ranks, "processes: brunt starts mpirun itself")
      ->option_text("N")
      ->check(CLI::Range(1, 1 << 20));
  run->add_flag("--oversubscribe", arguments.oversubscribe, "lets ranks share cores");
  run->add_option("--until", arguments.until, "stops at this time with a checkpoint: '20 us'")
      ->option_text("TIME");
  run->add_option("--restart", arguments.restart,
                  "goes on from a checkpoint, with a longer end or other output; writes to --out")
      ->option_text("MANIFEST|DIR")
      ->check(value_given());
  auto* refine =
      run->add_flag("--refine{3}", arguments.refine,
                    "runs other sizes too, --refine=2 or 3 in all: an error bar for every measure")
          ->check(CLI::Range(2, 5));
  run->add_option("--refine-key", arguments.refine_key,
                  "what they differ in: parameters.size, bodies.bar.cells; default: found")
      ->option_text("KEY")
      ->needs(refine);
  run->add_flag("--quiet", arguments.quiet, "no progress, no closing words");
  run->add_flag("--json", arguments.json, "prints summary.json to stdout");
  return run;
}

int refine_run(const RunArguments& run) {
  RefineArguments refine;
  refine.deck = run.deck, refine.overrides = run.overrides, refine.key = run.refine_key;
  refine.out = (output_path(run) / "").parent_path();  // without a slash at its end
  refine.sizes = run.refine;
  refine.force = run.force, refine.resume = run.resume;
  refine.quiet = run.quiet, refine.json = run.json;
  refine.threads = run.threads;
  if (run.until || !run.restart.empty()) {
    const std::string option = run.until ? "--until" : "--restart";
    throw DeckError({{{option, 0, 0}, "", "does not go with --refine, which needs whole runs"}});
  }
  if (run.ranks > 1) refine.flags = {"--ranks", std::to_string(run.ranks)};
  if (run.oversubscribe) refine.flags.emplace_back("--oversubscribe");
  return refine_command(refine);
}

constexpr const char* kFooter =
    "\nBegin with\n"
    "  brunt plan decks/taylor-bar/taylor-bar.yaml    what will be modelled, memory, steps\n"
    "  brunt run decks/taylor-bar/taylor-bar.yaml     writes taylor-bar.out\n"
    "  brunt render taylor-bar.out                    pictures without ParaView\n"
    "  brunt explain bodies                           what may stand in a deck\n"
    "Exit status: 0 done; 2 the deck or the call is wrong; 3 the physics broke;\n"
    "4 the machine failed; 5 stopped by a signal, what is written is whole.";

/// "" where the first word is a command; else what is wrong with it.
std::string unknown_command(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return "";
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  if (std::find(names.begin(), names.end(), argv[1]) != names.end()) return "";
  const std::string word = argv[1];
  const bool deck = word.ends_with(".yaml");
  return "brunt: there is no command '" + word + "'" +
         (deck ? "; to run a deck, write brunt run " + word : suggestion(word, names));
}

CLI::App* add_table(CLI::App& app, std::vector<std::string>& folders, TableOptions& options) {
  auto* table = app.add_subcommand("table", "one row a run: what a sweep ends with");
  table->add_option("DIR", folders, "output folders")->required()->option_text(" ");
  table->add_option("--show", options.show, "columns instead of the default ones")
      ->option_text("KEY,...")
      ->delimiter(',')
      ->allow_extra_args(false);
  table->add_flag("--csv", options.csv, "all digits, commas");
  return table;
}

CLI::App* add_status(CLI::App& app, std::vector<std::string>& folders) {
  auto* status = app.add_subcommand("status", "how far runs are, or how they ended");
  status->add_option("DIR", folders, "output folders")->required()->option_text(" ");
  return status;
}

CLI::App* add_explain(CLI::App& app, std::string& key) {
  auto* explain = app.add_subcommand("explain", "explains a key of the deck, or lists them");
  explain
      ->add_option("KEY", key,
                   "such as materials.strength.johnson-cook.C, or library; none: the first level")
      ->option_text(" ");
  return explain;
}

CLI::App* add_report(CLI::App& app, std::vector<std::string>& folders) {
  auto* report = app.add_subcommand(
      "report", "a page of HTML of each run: measures, charts over time, pictures, warnings, cost");
  report->add_option("DIR", folders, "output folders")->required()->option_text(" ");
  return report;
}

int print_table(const std::vector<std::string>& folders, const TableOptions& options) {
  const auto runs = read_runs({folders.begin(), folders.end()});
  std::fputs(format_table(runs, options).c_str(), stdout);
  return kDone;
}

CLI::App* add_trade(CLI::App& app, TradeArguments& trade) {
  auto* command = app.add_subcommand("trade", "what accuracy costs: error over processor time");
  command->add_option("DECK", trade.deck, "the deck, a YAML file")->required()->option_text(" ");
  command
      ->add_option("--vary", trade.vary,
                   "runs the deck with each value: --vary parameters.size='1 mm,2 mm'; again for "
                   "more keys; KEY+KEY=... changes two together")
      ->option_text("KEY=V1,V2")
      ->required()
      ->allow_extra_args(false);
  command->add_option("--set", trade.overrides, "overrides a key of all of them")
      ->option_text("KEY=VALUE")
      ->allow_extra_args(false);
  auto* grid = command->add_flag("--grid", trade.grid, "all combinations of values; the default");
  command->add_flag("--one-at-a-time", trade.one_at_a_time, "the deck, and each value alone")
      ->excludes(grid);
  command
      ->add_option("--against", trade.against,
                   "what the front is of: errors to the exact values, to the finest run, or to the "
                   "references; default: exact, else finest")
      ->option_text("WHAT")
      ->check(CLI::IsMember({"exact", "finest", "reference"}));
  command->add_option("--jobs", trade.jobs, "runs at the same time; default: 1")
      ->option_text("N")
      ->check(CLI::Range(1, 4096));
  command->add_option("--repeat", trade.repeat, "runs of each, of which the time is taken; 3")
      ->option_text("N")
      ->check(CLI::Range(1, 1000));
  command->add_option("--threads", trade.threads, "threads of each run; default: 1")
      ->option_text("N")
      ->check(CLI::Range(1, 4096));
  command->add_option("--out", trade.out, "folder; default: the deck's name and .trade")
      ->option_text("DIR")
      ->check(value_given());
  command->add_flag("--force", trade.force, "begins anew what is of another deck");
  command->add_flag("--quiet", trade.quiet, "no progress");
  command->add_flag("--json", trade.json, "prints trade.json instead of tables");
  return command;
}

CLI::App* add_render(CLI::App& app, PictureArguments& picture) {
  auto* render = app.add_subcommand("render", "writes PNG pictures of an output folder");
  render->add_option("DIR", picture.folder, "output folder")->required()->option_text(" ");
  render->add_option("--field", picture.field, "colours: von_mises, velocity.magnitude, ...")
      ->option_text("FIELD");
  render->add_option("--out", picture.out, "folder of the pictures; default: the output folder")
      ->option_text("DIR")
      ->check(value_given());
  render->add_option("--frames", picture.frames, "all, last, or numbers such as 0,5,10")
      ->option_text("WHICH");
  render->add_option("--view", picture.view, "auto, oblique, front, side or top")
      ->option_text("VIEW");
  render->add_option("--title", picture.title, "text at the top")->option_text("TEXT");
  render->add_flag("--contacts", picture.contacts, "black dots where contacts carry force");
  return render;
}

/// Reads the call; the exit status where there is nothing more to do.
std::optional<int> parse(CLI::App& app, int argc, char** argv) {
  if (argc == 1) {
    std::fputs(app.help().c_str(), stderr);
    return kDeckWrong;
  }
  if (const std::string problem = unknown_command(app, argc, argv); !problem.empty()) {
    std::fprintf(stderr, "%s\n", problem.c_str());
    return kDeckWrong;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const int status = app.exit(error);
    return status == 0 ? kDone : kDeckWrong;
  }
  return std::nullopt;
}

/// A message on stderr. Where all ranks fail alike the root speaks and ends them all; another rank
/// that is still there after a while is alone with its failure.
void say(const ParallelSession& session, const std::string& text) {
  if (!session.ranks().is_root()) std::this_thread::sleep_for(std::chrono::seconds(3));
  std::fputs(text.c_str(), stderr);
}

/// Runs a command and turns what it throws into a message and a status.
template <class Command>
int guarded(const ParallelSession& session, Command command) {
  int status = kMachineFailed;
  try {
    const int done = command();
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return done;
    throw MachineError(std::string("cannot write to the standard output: ") + std::strerror(errno));
  } catch (const DeckError& error) {
    std::string text;
    for (const auto& problem : error.problems()) text += problem.text() + "\n";
    say(session, text);
    status = kDeckWrong;
  } catch (const PhysicsError& error) {
    say(session, std::string("brunt: ") + error.what() + "\n");
    status = kPhysicsBroke;
  } catch (const MachineError& error) {
    say(session, std::string("brunt: ") + error.what() + "\n");
  } catch (const std::bad_alloc&) {
    say(session, "brunt: not enough memory; `brunt plan` says what the deck needs\n");
  } catch (const std::exception& error) {  // of the system or a library; it names the path
    say(session, std::string("brunt: ") + error.what() + "\n");
  }
  if (!session.ranks().alone()) session.abort(status);
  return status;
}

/// All of command_line but what happens where not even options have room.
int do_command(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);  // whoever reads may go; a run goes on
  std::signal(SIGXFSZ, SIG_IGN);  // what may not grow (ulimit -f) fails as on a full disk: EFBIG
  CLI::App app{
      "brunt: bodies that hit, cut, slide on and heat each other. Finite elements, SPH, contact."};
  app.set_version_flag("--version", std::string(BRUNT_VERSION) + " (" + BRUNT_ISA + ")");
  app.name("brunt");
  app.require_subcommand(1);
  RunArguments arguments;
  auto* run = add_run(app, arguments);
  auto* check = app.add_subcommand("check", "says what is wrong with a deck");
  auto* plan = add_plan(app, arguments);
  add_deck(check, arguments);

  std::vector<std::string> folders;
  TableOptions table_options;
  auto* table = add_table(app, folders, table_options);
  auto* status_of = add_status(app, folders);
  auto* report = add_report(app, folders);
  TradeArguments trading;
  auto* trade = add_trade(app, trading);
  PictureArguments picture;
  auto* render = add_render(app, picture);

  std::string checkpoint;
  auto* verify = app.add_subcommand("verify", "says whether checkpoints are whole");
  verify->add_option("file", checkpoint, "a manifest, or a folder")->required();

  std::string key;
  auto* explain = add_explain(app, key);
  auto* schema = app.add_subcommand("schema", "prints the JSON schema of decks");
  bool keys = false, columns = false;
  schema->add_flag("--markdown", keys, "prints the reference manual of keys instead");
  schema->add_flag("--columns", columns, "prints what the columns and fields of a run are");

  app.footer(kFooter);  // commands made after it would show it too
  if (const auto status = parse(app, argc, argv)) return *status;
  if (*run && arguments.refine == 0 && arguments.ranks > 1 && !launched_by_mpirun()) {
    return launch_ranks(arguments, argc, argv);
  }
  const ParallelSession session(argc, argv);
  return guarded(session, [&]() -> int {
    if (*run && arguments.refine > 0) return refine_run(arguments);
    if (*run) return run_command(arguments, session.ranks());
    if (*check) return check_command(arguments);
    if (*plan) return plan_command(arguments);
    if (*trade) return trade_command(trading);
    if (*table) return print_table(folders, table_options);
    if (*status_of) return status_command(folders);
    if (*report) return report_command(folders);
    if (*verify) return verify_command(checkpoint);
    if (*render) return render_command(picture);
    if (*explain) return explain_command(key);
    return schema_command(columns ? SchemaPage::columns
                          : keys  ? SchemaPage::keys
                                  : SchemaPage::json);
  });
}
}  // namespace

int command_line(int argc, char** argv) {
  try {
    return do_command(argc, argv);
  } catch (const std::bad_alloc&) {
    std::fputs("brunt: not enough memory\n", stderr);
    return kMachineFailed;
  }
}

}  // namespace brunt
