#include "app/command_line.hpp"

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <new>
#include <thread>

#include "app/deck/deck.hpp"
#include "app/launch_ranks.hpp"
#include "app/pictures.hpp"
#include "app/reference.hpp"
#include "app/run.hpp"
#include "core/errors.hpp"
#include "io/table.hpp"

namespace brunt {

namespace {
void add_deck(CLI::App* command, RunArguments& arguments) {
  command->add_option("deck", arguments.deck, "the deck (YAML)")->required();
  command->add_option("--set", arguments.overrides, "KEY=VALUE: overrides a key of the deck")
      ->allow_extra_args(false);
}

CLI::App* add_run(CLI::App& app, RunArguments& arguments) {
  auto* run = app.add_subcommand("run", "runs a deck");
  add_deck(run, arguments);
  run->add_option("--out", arguments.out, "output folder; default: <deck>.out");
  run->add_flag("--force", arguments.force, "replaces what an earlier run wrote there");
  run->add_flag("--resume", arguments.resume, "skips a run that is done with the same deck");
  run->add_option("--threads", arguments.threads, "threads; default: OMP_NUM_THREADS or all cores")
      ->check(CLI::Range(1, 4096));
  run->add_option("--ranks", arguments.ranks, "processes: brunt starts mpirun itself")
      ->check(CLI::Range(1, 1 << 20));
  run->add_flag("--oversubscribe", arguments.oversubscribe, "lets ranks share cores");
  run->add_option("--until", arguments.until, "ends at this time instead");
  run->add_flag("--quiet", arguments.quiet, "no progress");
  run->add_flag("--json", arguments.json, "prints the summary to stdout");
  return run;
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
    return command();
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
  }
  if (!session.ranks().alone()) session.abort(status);
  return status;
}
}  // namespace

int command_line(int argc, char** argv) {
  CLI::App app{
      "brunt: bodies that hit, cut, rub and heat each other. Finite elements, SPH, contact."};
  app.set_version_flag("--version", std::string(BRUNT_VERSION) + " (" + BRUNT_ISA + ")");
  app.require_subcommand(1);
  RunArguments arguments;
  auto* run = add_run(app, arguments);
  auto* check = app.add_subcommand("check", "says what is wrong with a deck");
  auto* plan = app.add_subcommand("plan", "says what will be modelled and what it costs");
  add_deck(check, arguments);
  add_deck(plan, arguments);

  std::vector<std::string> folders;
  TableOptions table_options;
  auto* table = app.add_subcommand("table", "one row a run: what a sweep ends with");
  table->add_option("dirs", folders, "output folders")->required();
  table->add_option("--show", table_options.show, "columns instead of the default ones")
      ->delimiter(',')
      ->allow_extra_args(false);
  table->add_flag("--csv", table_options.csv, "all digits, commas");

  PictureArguments picture;
  auto* render = app.add_subcommand("render", "writes PNG pictures of an output folder");
  render->add_option("dir", picture.folder, "output folder")->required();
  render->add_option("--field", picture.field, "field to colour by, such as von_mises");
  render->add_option("--out", picture.out, "folder of the pictures; default: the output folder");
  render->add_option("--frames", picture.frames, "all, last, or numbers such as 0,5,10");
  render->add_option("--view", picture.view, "auto, oblique, front, side or top");
  render->add_option("--title", picture.title, "text at the top");

  std::string key;
  auto* explain = app.add_subcommand("explain", "explains a key of the deck, or lists them");
  explain->add_option("key", key, "such as materials.strength.johnson-cook.C, or library");
  auto* schema = app.add_subcommand("schema", "prints the JSON schema of decks");
  bool markdown = false;
  schema->add_flag("--markdown", markdown, "prints the reference manual instead");

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const int status = app.exit(error);
    return status == 0 ? kDone : kDeckWrong;
  }
  if (*run && arguments.ranks > 1 && !launched_by_mpirun()) {
    return launch_ranks(arguments, argc, argv);
  }
  const ParallelSession session(argc, argv);
  return guarded(session, [&]() -> int {
    if (*run) return run_command(arguments, session.ranks());
    if (*check) return check_command(arguments);
    if (*plan) return plan_command(arguments);
    if (*table) {
      const auto runs = read_runs({folders.begin(), folders.end()});
      std::fputs(format_table(runs, table_options).c_str(), stdout);
      return kDone;
    }
    if (*render) return render_command(picture);
    if (*explain) return explain_command(key);
    return schema_command(markdown);
  });
}

}  // namespace brunt
