#include "app/cli/run.hpp"

#include <omp.h>
#include <spdlog/sinks/basic_file_sink.h>
#include <spdlog/spdlog.h>

#include <chrono>
#include <cstdio>
#include <optional>

#include "app/cli/costs.hpp"
#include "app/cli/find_restart.hpp"
#include "app/cli/load_run.hpp"
#include "app/cli/memory.hpp"
#include "app/cli/output_folder.hpp"
#include "app/cli/pictures.hpp"
#include "app/deck/findings.hpp"
#include "app/ranks/balance.hpp"
#include "app/ranks/distribute.hpp"
#include "app/restart/checkpointing.hpp"
#include "app/setup/scene_builder.hpp"
#include "app/setup/scene_checks.hpp"
#include "app/setup/sound_part.hpp"
#include "app/watch/frames.hpp"
#include "app/watch/monitor.hpp"
#include "app/watch/progress.hpp"
#include "core/large_blocks.hpp"
#include "io/file.hpp"
#include "io/summary.hpp"

namespace brunt {

namespace fs = std::filesystem;

namespace {
void choose_threads(int asked) {
  if (asked > 0) omp_set_num_threads(asked);
}

/// The log of the root; other ranks keep none.
std::shared_ptr<spdlog::logger> open_log(const fs::path& folder, bool goes_on, bool root) {
  auto log = std::make_shared<spdlog::logger>("brunt");
  if (!root) return log;
  log->sinks().push_back(
      std::make_shared<spdlog::sinks::basic_file_sink_mt>((folder / "log.txt").string(), !goes_on));
  return log;
}

struct Ended {
  int status = kDone;
  std::string reason;
};

/// How often conduction was evaluated, and how long that acted, of which its error is reported.
void log_windows(const HeatWindows& windows, std::int64_t steps, spdlog::logger& log) {
  if (windows.evaluations() == 0 || windows.evaluations() == steps) return;
  log.info(
      "conduction was evaluated in {} of {} steps, and acted for at most {:.2g} of its longest "
      "stable step",
      windows.evaluations(), steps, windows.largest_part());
}

/// Steps the scene; a broken physics is reported after a last frame.
template <int Dim>
Ended step_to_end(Scene<Dim>& scene, Clock& clock, Monitor<Dim>& monitor,
                  Checkpointing<Dim>& checkpointing, Balance<Dim>& balance) {
  try {
    run_time_loop(scene, clock, checkpointing, &balance);
    monitor.end(scene, clock);
    return {checkpointing.interrupted() ? kStopped : kDone, monitor.reason()};
  } catch (const PhysicsError& error) {
    PhysicsFailure failure = error.failure();
    if (failure.time == 0) failure.time = clock.time();
    failure.time = clock.real(failure.time);
    if (clock.real(1) != 1) {
      failure.cause +=
          "; speeds and rates in this line are as stepped, time.process_speed times "
          "the real ones";
    }
    monitor.write_last_frame(scene, clock);
    return {kPhysicsBroke, PhysicsError(failure).what()};
  }
}

/// Pictures of the run; one that cannot be drawn is a warning, for the results are there.
std::vector<fs::path> draw_pictures(const fs::path& folder, const std::string& title,
                                    RunSummary& summary) {
  try {
    return draw_run(folder, title);
  } catch (const std::exception& error) {
    summary.warnings.push_back({"output.pictures", error.what()});
    std::fprintf(stderr, "warning: output.pictures: %s\n", error.what());
    return {};
  }
}

/// What the end of a run reports of energies, and of inertia where the process was made faster.
std::vector<std::string> end_lines(const RunSummary& summary) {
  auto lines = energy_lines(summary.energy);
  if (!summary.distorts.empty()) lines.push_back(summary.distorts);
  if (!summary.inertia.empty()) lines.push_back(inertia_line(summary.inertia));
  return lines;
}

void print_summary(const RunSummary& summary, const fs::path& folder,
                   const std::vector<fs::path>& pictures) {
  for (const auto& measure : summary.measures) {
    std::fprintf(stderr, "  %-20s %.6g %s", measure.name.c_str(), measure.value,
                 measure.unit.c_str());
    if (measure.error) {
      std::fprintf(stderr, "   (%+.2f %% of %.6g)", 100 * *measure.error, *measure.reference);
    }
    std::fputc('\n', stderr);
  }
  for (const auto& line : end_lines(summary)) {
    std::fprintf(stderr, "  %s\n", line.c_str());
  }
  for (const auto& [body, margin] : summary.step_margins) {
    std::fprintf(stderr, "  %s: stable up to %.3g times its step limit\n", body.c_str(), margin);
  }
  std::fprintf(stderr, "%lld steps in %s, energy drift %.1e. Results are in %s:\n",
               static_cast<long long>(summary.steps), duration_text(summary.wall_seconds).c_str(),
               summary.drift, folder.c_str());
  if (!summary.step_bounds.empty()) {
    std::fprintf(stderr, "  %s\n", step_bounds_line(summary.step_bounds).c_str());
  }
  if (summary.planned_steps > 0) {
    std::fprintf(stderr, "  planned were %lld steps; memory %.0f MB",
                 static_cast<long long>(summary.planned_steps), summary.peak_memory / 1e6);
    if (summary.planned_memory > 0) {
      std::fprintf(stderr, ", planned %.0f MB", summary.planned_memory / 1e6);
    }
    std::fputc('\n', stderr);
  }
  std::fprintf(stderr, "  frames.pvd opens in ParaView, history.csv holds curves\n");
  if (pictures.empty()) {
    std::fprintf(stderr, "  brunt render %s draws pictures\n", folder.c_str());
  } else {
    std::fprintf(stderr, "  %zu pictures: %s to %s\n", pictures.size(),
                 pictures.front().filename().c_str(), pictures.back().filename().c_str());
  }
}

/// Why a run ended before its time, also where it was asked to be quiet.
void print_end(const Ended& ended, const Clock& clock, const fs::path& folder) {
  if (ended.status == kPhysicsBroke) {
    std::fprintf(stderr, "brunt: %s\n", ended.reason.c_str());
  } else if (ended.status == kStopped) {
    std::fprintf(
        stderr,
        "brunt: stopped by a signal at t = %s of %s, after step %lld; what stands in %s is "
        "whole up to there, and --resume goes on from there\n",
        deck::time_text(clock.real_time()).c_str(),
        deck::time_text(clock.real(clock.end())).c_str(), static_cast<long long>(clock.step()),
        folder.c_str());
  } else if (!ended.reason.empty()) {
    std::fprintf(stderr, "brunt: ended at t = %s: %s\n", deck::time_text(clock.real_time()).c_str(),
                 ended.reason.c_str());
  }
}

/// What making the process faster distorts.
void take_process(Real speed, const std::vector<InertiaShare>& inertia, RunSummary& summary) {
  summary.process_speed = speed;
  summary.distorts = distortion_text(speed);
  summary.inertia = inertia;
  for (const auto& warning : inertia_warnings(inertia, speed)) summary.warnings.push_back(warning);
}

/// What the run came to; costs aside.
template <int Dim>
void fill_summary(const LoadedDeck& loaded, const Ended& ended, const Clock& clock,
                  const Monitor<Dim>& monitor, RunSummary& summary) {
  summary.version = BRUNT_VERSION;
  summary.deck_hash = loaded.hash;
  for (const auto& parameter : loaded.parameters) {
    summary.parameters.emplace_back(parameter.name, parameter.text);
  }
  summary.overrides = loaded.overrides;
  summary.status = ended.status;
  summary.reason = ended.reason;
  summary.steps = clock.step();
  summary.peak_memory = peak_memory();
  summary.drift = monitor.worst_drift();
  for (const auto& measure : monitor.measures()) {
    std::optional<Real> error;
    if (measure.reference && *measure.reference != 0) {
      error = (measure.value - *measure.reference) / std::fabs(*measure.reference);
    }
    summary.measures.push_back({measure.name, measure.value, measure.unit, measure.reference, error,
                                measure.exact, measure.time});
  }
  for (const auto& warning : monitor.warnings()) {
    summary.warnings.push_back({kMeasureWarning, warning});
  }
  const auto& reported = monitor.warned();
  summary.warnings.insert(summary.warnings.end(), reported.begin(), reported.end());
  summary.energy = monitor.energy_shares();
  if (monitor.end_hash()) summary.state_hash = std::to_string(*monitor.end_hash());
  summary.step_margins = monitor.step_check().margins();
  summary.eroded = monitor.eroded();
  take_process(loaded.deck.time.process_speed, monitor.inertia(), summary);
  for (const auto& warning : monitor.step_check().warnings()) summary.warnings.push_back(warning);
  for (const auto& [pair, text] : monitor.lost_contacts()) {
    summary.warnings.push_back({"contact", text});
  }
  for (const auto& warning : monitor.body_warnings()) summary.warnings.push_back(warning);
  summary.instruction_set = BRUNT_ISA;
}

/// A warning of the run: into the log, of the root on stderr too.
void warn(const RunWarning& warning, bool root, spdlog::logger& log) {
  log.warn("{}: {}", warning.id, warning.text);
  log.flush();
  if (!root) return;
  std::fprintf(stderr, "warning: %s: %s\n", warning.id.c_str(), warning.text.c_str());
}

/// Writes the summary and the pictures, and says on the log and the screen how the run ended.
template <int Dim>
void report_end(const LoadedDeck& loaded, const RunArguments& arguments, const fs::path& folder,
                const Ended& ended, const Clock& clock, const Monitor<Dim>& monitor,
                RunSummary& summary, spdlog::logger& log) {
  const auto pictures = loaded.deck.output.pictures && ended.status != kStopped
                            ? draw_pictures(folder, loaded.deck.title, summary)
                            : std::vector<fs::path>{};
  write_summary(folder, summary);

  for (const auto& [pair, text] : monitor.lost_contacts()) log.warn("contact: {}", text);
  for (const auto& warning : inertia_warnings(summary.inertia, summary.process_speed)) {
    warn(warning, true, log);
  }
  log.info("{} steps, {} s, drift {}", summary.steps, summary.wall_seconds, summary.drift);
  for (const auto& line : end_lines(summary)) log.info("{}", line);
  if (!ended.reason.empty()) log.info("{}", ended.reason);
  log.flush();
  if (arguments.json) std::printf("%s\n", to_json(summary).c_str());
  if (!arguments.quiet) print_summary(summary, folder, pictures);
  print_end(ended, clock, folder);
}

/// Throws: DeckError where the deck asks for pictures that this program cannot draw.
void ask_for_pictures(const LoadedDeck& loaded) {
  if (loaded.deck.output.pictures && !can_draw()) {
    throw DeckError({loaded.places.problem(
        "output.pictures",
        "this brunt was built without VTK and draws nothing: take the key out, "
        "or configure with -DBRUNT_VTK=ON")});
  }
}

/// The folder of a run that is done already.
void tell_finished(const RunArguments& arguments, const fs::path& folder) {
  if (arguments.json) std::printf("%s\n", to_json(read_summary(folder)).c_str());
  if (!arguments.quiet) std::fprintf(stderr, "%s is done already\n", folder.c_str());
}

/// What runs, on what, and what was noticed while the scene was built.
template <int Dim>
void log_start(const RunArguments& arguments, const Scene<Dim>& scene, const Communicator& ranks,
               const std::vector<DeckProblem>& warnings, RunSummary& summary, spdlog::logger& log) {
  log.info("brunt {} ({}), {} ranks of {} threads, deck {}", BRUNT_VERSION, BRUNT_ISA, ranks.size(),
           omp_get_max_threads(), arguments.deck);
  for (const auto& note : scene.notes) log.info("{}", note);
  for (const auto& warning : warnings) {
    log.warn("{}", warning.text());
    summary.warnings.push_back({warning.path, warning.message});
  }
  for (const auto& probe : scene.probes) log.info("{}", place_text(probe));
}

/// Checkpoints that the run could not go on from.
void log_refused(const std::vector<std::string>& reasons, RunSummary& summary,
                 spdlog::logger& log) {
  for (const auto& reason : reasons) {
    log.warn("{}", reason);
    summary.warnings.push_back({"checkpoint", reason});
  }
}

template <int Dim>
void take_balance(const Balance<Dim>& balance, RunSummary& summary, spdlog::logger& log) {
  summary.balance = balance.ratio();
  summary.repartitions = balance.repartitions();
  if (balance.steps_alone() == 0) return;
  log.info("{} steps on one thread instead of {}: other programs used the processors",
           balance.steps_alone(), summary.threads);
}

/// What the run cost, and the steps that a plan would have said.
template <int Dim>
void take_costs(const Scene<Dim>& scene, const Clock& clock, std::int64_t first_step,
                const Communicator& ranks, RunSummary& summary) {
  summary.first_step = first_step;
  if (clock.planned_step() > 0) {
    summary.planned_steps = std::llround(std::ceil(clock.end() / clock.planned_step()));
  }
  fill_step_bounds(scene, clock, summary);
  fill_costs(scene, clock.step() - first_step, summary);
  fill_pairs(scene, ranks, summary);
  fill_traffic(ranks, clock.step() - first_step, summary);
}

double seconds_since(std::chrono::steady_clock::time_point from,
                     std::optional<std::chrono::steady_clock::time_point> to = {}) {
  return std::chrono::duration<double>(to.value_or(std::chrono::steady_clock::now()) - from)
      .count();
}

template <int Dim>
int run_scene(const LoadedDeck& loaded, const RunArguments& arguments, const Communicator& ranks) {
  const auto wall_start = std::chrono::steady_clock::now();
  ask_for_pictures(loaded);
  const Real program = resident_memory();
  auto scene = build_scene<Dim>(loaded);
  std::vector<DeckProblem> warnings = loaded.warnings;
  warn_of_scene(loaded, *scene, ranks.is_root(), warnings);
  RunSummary summary;
  const MemoryInputs inputs = memory_inputs(loaded.deck, *scene, program);
  if (ranks.alone()) summary.planned_memory = memory_of(*scene, inputs).total();
  distribute(*scene, ranks);
  const double build_time = seconds_since(wall_start);
  const auto anew = [&] { return build_scene<Dim>(loaded); };
  Balance<Dim> balance(loaded.deck.ranks, anew, build_time);
  const auto folder = output_path(arguments);
  summary.threads = omp_get_max_threads();
  std::optional<OutputFolder> output;
  const bool root = ranks.is_root();
  if (root) output.emplace(folder, arguments);
  ranks.barrier();  // the root alone holds the folder
  if (arguments.resume && ranks.any(root && is_finished(folder, loaded.hash))) {
    if (root) tell_finished(arguments, folder);
    return kDone;
  }
  std::vector<std::string> refused;
  const auto restart = find_restart(arguments, folder, loaded, [&](const std::string& reason) {
    refused.push_back(reason);
    if (root) std::fprintf(stderr, "warning: %s\n", reason.c_str());
  });
  const bool goes_on = restart && restart->lies_in(folder);
  ranks.barrier();  // all have read what the root may replace
  if (root) {
    output->prepare(goes_on);
    write_file_atomically(folder / "deck.resolved.yaml", loaded.resolved);
  }
  ranks.barrier();  // the folder is there for all
  auto log = open_log(folder, goes_on, root);
  log_start(arguments, *scene, ranks, warnings, summary, *log);
  const Deck& deck = loaded.deck;
  Clock clock(deck.time.end, deck.time.safety, deck.time.max_step.value_or(kInfinity),
              deck.time.min_step, deck.time.process_speed);
  std::optional<HistoryWriter> history;
  const auto columns = HistoryColumns<Dim>(*scene).names();  // collective
  if (root) history.emplace(folder / "history.csv", columns);
  const auto frames = make_frame_sink(folder, ranks);
  Monitor<Dim> monitor(deck, history ? &*history : nullptr, frames.get(), arguments.quiet || !root,
                       [&](const RunWarning& warning) { warn(warning, root, *log); });
  if (restart) say_restart(*restart, folder, arguments.quiet || !root, *log);
  Checkpointing<Dim> checkpointing(loaded, folder, monitor, restart.get(), take_requests);
  const Ended ended = step_to_end(*scene, clock, monitor, checkpointing, balance);
  log_refused(refused, summary, *log);
  log_windows(scene->heat_windows, clock.step() - checkpointing.first_step(), *log);
  fill_summary(loaded, ended, clock, monitor, summary);
  summary.start_seconds = seconds_since(wall_start, monitor.begun());
  summary.wall_seconds = seconds_since(wall_start);
  take_costs(*scene, clock, checkpointing.first_step(), ranks, summary);
  take_balance(balance, summary, *log);
  if (root) report_end(loaded, arguments, folder, ended, clock, monitor, summary, *log);
  return ended.status;
}
}  // namespace

int run_command(const RunArguments& arguments, const Communicator& ranks) {
  listen_to_signals();
  choose_threads(arguments.threads);
  try {
    const LoadedDeck loaded = load_run(arguments, ranks.is_root());
    keep_freed_blocks(true);  // until the first step
    return loaded.deck.geometry == Geometry::three_d ? run_scene<3>(loaded, arguments, ranks)
                                                     : run_scene<2>(loaded, arguments, ranks);
  } catch (const DeckError& error) {
    throw as_called(error, arguments);
  }
}

}  // namespace brunt
