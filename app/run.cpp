#include "app/run.hpp"

#include <omp.h>
#include <spdlog/sinks/basic_file_sink.h>
#include <spdlog/spdlog.h>
#include <sys/resource.h>

#include <chrono>
#include <cstdio>

#include "app/build/scene_builder.hpp"
#include "app/checkpointing.hpp"
#include "app/frames.hpp"
#include "app/monitor.hpp"
#include "app/output_folder.hpp"
#include "io/file.hpp"
#include "io/summary.hpp"

namespace brunt {

namespace {
void choose_threads(int asked) {
  if (asked > 0) omp_set_num_threads(asked);
}

/// A deck with the command line's --until in place.
LoadedDeck load(const RunArguments& arguments) {
  auto overrides = arguments.overrides;
  if (arguments.until) overrides.push_back("time.until=" + *arguments.until);
  return load_deck(arguments.deck, overrides);
}

double peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

template <int Dim>
void fill_costs(const Scene<Dim>& scene, std::int64_t steps, RunSummary& summary) {
  const auto seconds = [&](Phase phase) {
    return scene.phases.seconds[static_cast<std::size_t>(phase)];
  };
  for (int p = 0; p < kPhases; ++p) {
    summary.phases.emplace_back(kPhaseNames[static_cast<std::size_t>(p)],
                                seconds(static_cast<Phase>(p)));
  }
  summary.points = static_cast<std::int64_t>(scene.n_points());
  summary.elements = static_cast<std::int64_t>(scene.n_elements());
  summary.particles = static_cast<std::int64_t>(scene.n_particles());
  // Whatever is spent on points, step bound and lists is shared by elements and particles.
  const double shared = seconds(Phase::points) + seconds(Phase::step_bound);
  const auto count = static_cast<double>(summary.elements + summary.particles);
  if (steps == 0 || count == 0) return;
  const auto n = static_cast<double>(steps);
  if (summary.elements > 0) {
    const auto elements = static_cast<double>(summary.elements);
    summary.ns_element_step = 1e9 * (seconds(Phase::elements) / elements + shared / count) / n;
  }
  if (summary.particles > 0) {
    const auto particles = static_cast<double>(summary.particles);
    summary.ns_particle_step =
        1e9 * ((seconds(Phase::particles) + seconds(Phase::search)) / particles + shared / count) /
        n;
  }
}

std::shared_ptr<spdlog::logger> open_log(const std::filesystem::path& folder, bool goes_on) {
  return std::make_shared<spdlog::logger>(
      "brunt",
      std::make_shared<spdlog::sinks::basic_file_sink_mt>((folder / "log.txt").string(), !goes_on));
}

struct Ended {
  int status = kDone;
  std::string reason;
};

/// Steps the scene; a broken physics is reported after a last frame.
template <int Dim>
Ended step_to_end(Scene<Dim>& scene, Clock& clock, const Deck& deck, Monitor<Dim>& monitor,
                  Checkpointing<Dim>& checkpointing) {
  try {
    run_time_loop(scene, clock, deck.time.min_step.value_or(1e-9 * deck.time.end), checkpointing);
    monitor.end(scene, clock);
    return {checkpointing.interrupted() ? kStopped : kDone, monitor.reason()};
  } catch (const PhysicsError& error) {
    PhysicsFailure failure = error.failure();
    if (failure.time == 0) failure.time = clock.time();
    monitor.write_last_frame(scene, clock);
    return {kPhysicsBroke, PhysicsError(failure).what()};
  }
}

template <int Dim>
int run_scene(const LoadedDeck& loaded, const RunArguments& arguments) {
  const auto wall_start = std::chrono::steady_clock::now();
  auto scene = build_scene<Dim>(loaded);
  const auto folder = output_path(arguments);
  RunSummary summary;
  if (arguments.resume && is_finished(folder, loaded.hash)) {
    summary = read_summary(folder);
    if (arguments.json) std::printf("%s\n", to_json(summary).c_str());
    if (!arguments.quiet) std::fprintf(stderr, "%s is done already\n", folder.c_str());
    return kDone;
  }
  std::vector<std::string> refused;
  const auto restart = find_restart(arguments, folder, loaded, [&](const std::string& reason) {
    refused.push_back(reason);
    std::fprintf(stderr, "warning: %s\n", reason.c_str());
  });
  std::error_code no_folder;
  const bool goes_on =
      restart && std::filesystem::equivalent(restart->point().folder(), folder, no_folder);
  prepare_output(folder, arguments, goes_on);
  write_file_atomically(folder / "deck.resolved.yaml", loaded.resolved);
  auto log = open_log(folder, goes_on);
  log->info("brunt {} ({}), {} threads, deck {}", BRUNT_VERSION, BRUNT_ISA, omp_get_max_threads(),
            arguments.deck);
  for (const auto& warning : loaded.warnings) {
    log->warn("{}", warning.text());
    std::fprintf(stderr, "warning: %s\n", warning.text().c_str());
    summary.warnings.push_back({warning.path, warning.message});
  }

  const Deck& deck = loaded.deck;
  Clock clock(deck.time.end, deck.time.safety, deck.time.max_step.value_or(kInfinity));
  HistoryWriter history(folder / "history.csv", HistoryColumns<Dim>(*scene).names());
  const auto frames = make_frame_sink(folder);
  Monitor<Dim> monitor(deck, &history, frames.get(), arguments.quiet);
  if (restart) {
    log->info("goes on from {}, t = {} s", restart->point().manifest.string(),
              restart->point().header.time);
  }
  Checkpointing<Dim> checkpointing(loaded, folder, monitor, restart.get(), take_requests);
  const Ended ended = step_to_end(*scene, clock, deck, monitor, checkpointing);
  for (const auto& reason : refused) {
    log->warn("{}", reason);
    summary.warnings.push_back({"checkpoint", reason});
  }

  summary.version = BRUNT_VERSION;
  summary.deck_hash = loaded.hash;
  for (const auto& parameter : loaded.parameters) {
    summary.parameters.emplace_back(parameter.name, parameter.text);
  }
  summary.overrides = loaded.overrides;
  summary.status = ended.status;
  summary.reason = ended.reason;
  summary.steps = clock.step();
  summary.wall_seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_start).count();
  fill_costs(*scene, clock.step() - checkpointing.first_step(), summary);
  summary.peak_memory = peak_memory();
  summary.drift = monitor.worst_drift();
  for (const auto& measure : monitor.measures()) {
    std::optional<Real> error;
    if (measure.reference && *measure.reference != 0) {
      error = (measure.value - *measure.reference) / std::fabs(*measure.reference);
    }
    summary.measures.push_back(
        {measure.name, measure.value, measure.unit, measure.reference, error});
  }
  for (const auto& warning : monitor.warnings()) summary.warnings.push_back({"measure", warning});
  summary.threads = omp_get_max_threads();
  summary.instruction_set = BRUNT_ISA;
  write_summary(folder, summary);

  if (ended.status == kPhysicsBroke) {
    log->error("{}", ended.reason);
    std::fprintf(stderr, "brunt: %s\n", ended.reason.c_str());
  }
  log->info("{} steps, {} s, drift {}", summary.steps, summary.wall_seconds, summary.drift);
  log->flush();
  if (arguments.json) std::printf("%s\n", to_json(summary).c_str());
  if (!arguments.quiet) {
    for (const auto& measure : summary.measures) {
      std::fprintf(stderr, "  %-20s %.6g %s", measure.name.c_str(), measure.value,
                   measure.unit.c_str());
      if (measure.error)
        std::fprintf(stderr, "   (%+.2f %% of %.6g)", 100 * *measure.error, *measure.reference);
      std::fputc('\n', stderr);
    }
    std::fprintf(
        stderr,
        "%lld steps in %.1f s, energy drift %.1e. Pictures: open %s/frames.pvd in ParaView, "
        "or type: brunt render %s\n",
        static_cast<long long>(summary.steps), summary.wall_seconds, summary.drift, folder.c_str(),
        folder.c_str());
  }
  return ended.status;
}
}  // namespace

int run_command(const RunArguments& arguments) {
  listen_to_signals();
  choose_threads(arguments.threads);
  const LoadedDeck loaded = load(arguments);
  return loaded.deck.geometry == Geometry::three_d ? run_scene<3>(loaded, arguments)
                                                   : run_scene<2>(loaded, arguments);
}

}  // namespace brunt
