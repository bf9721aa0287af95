#include "app/command_line.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <new>

#include "app/deck/deck.hpp"
#include "app/pictures.hpp"
#include "app/reference.hpp"
#include "app/restart.hpp"
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
  run->add_flag("--resume", arguments.resume,
                "goes on from the latest good checkpoint; skips a run that is done");
  run->add_option("--threads", arguments.threads, "threads; default: OMP_NUM_THREADS or all cores")
      ->check(CLI::Range(1, 4096));
  run->add_option("--until", arguments.until, "stops at this time with a checkpoint");
  run->add_option(
      "--restart", arguments.restart,
      "goes on from a checkpoint (manifest or folder), with a longer end or other output");
  run->add_flag("--quiet", arguments.quiet, "no progress");
  run->add_flag("--json", arguments.json, "prints the summary to stdout");
  return run;
}

/// Runs a command and turns what it throws into a message and a status.
template <class Command>
int guarded(Command command) {
  try {
    return command();
  } catch (const DeckError& error) {
    for (const auto& problem : error.problems())
      std::fprintf(stderr, "%s\n", problem.text().c_str());
    return kDeckWrong;
  } catch (const PhysicsError& error) {
    std::fprintf(stderr, "brunt: %s\n", error.what());
    return kPhysicsBroke;
  } catch (const MachineError& error) {
    std::fprintf(stderr, "brunt: %s\n", error.what());
    return kMachineFailed;
  } catch (const std::bad_alloc&) {
    std::fputs("brunt: not enough memory; `brunt plan` says what the deck needs\n", stderr);
    return kMachineFailed;
  }
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

  std::string checkpoint;
  auto* verify = app.add_subcommand("verify", "says whether checkpoints are whole");
  verify->add_option("file", checkpoint, "a manifest, or a folder")->required();

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
  return guarded([&]() -> int {
    if (*run) return run_command(arguments);
    if (*check) return check_command(arguments);
    if (*plan) return plan_command(arguments);
    if (*table) {
      const auto runs = read_runs({folders.begin(), folders.end()});
      std::fputs(format_table(runs, table_options).c_str(), stdout);
      return kDone;
    }
    if (*verify) return verify_command(checkpoint);
    if (*render) return render_command(picture);
    if (*explain) return explain_command(key);
    return schema_command(markdown);
  });
}

}  // namespace brunt
