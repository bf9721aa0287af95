#include "app/cli/calibration.hpp"

#include <omp.h>
#include <unistd.h>

#include <ctime>
#include <filesystem>

#include "app/loop/time_loop.hpp"
#include "app/watch/frames.hpp"
#include "app/watch/monitor.hpp"
#include "io/file.hpp"

namespace brunt {

namespace fs = std::filesystem;

namespace {
/// Watches as a run does, and stops the clock when enough was seen.
template <int Dim>
class Sample final : public Observer<Dim> {
 public:
  Sample(Monitor<Dim>& monitor, const SampleLimits& limits) : monitor_(monitor), limits_(limits) {}
  void begin(Scene<Dim>& scene, Clock& clock) override {
    monitor_.begin(scene, clock);
    first_ = processor_seconds();
  }
  Requests requests(const Scene<Dim>& scene, const Clock& clock) override {
    return monitor_.requests(scene, clock);
  }
  void answer(const StepHead& head, Scene<Dim>& scene, Clock& clock) override {
    monitor_.answer(head, scene, clock);
    note_stop(clock);
  }
  void step_done(Scene<Dim>& scene, Clock& clock) override {
    monitor_.step_done(scene, clock);
    note_stop(clock);
    last_ = processor_seconds();
    steps_ = clock.step();
    if (clock.time() <= limits_.first_part) {
      of_first_part_ = (last_ - first_) / static_cast<Real>(steps_);
    }
    if (last_ - first_ > limits_.seconds || steps_ >= limits_.steps) clock.stop();
  }
  std::optional<Calibration> result(const Clock& clock) const {
    if (steps_ == 0) return std::nullopt;
    const Real each = (last_ - first_) / static_cast<Real>(steps_);
    return Calibration{.steps = steps_,
                       .seconds_per_step = each,
                       .start = first_,
                       .planned_step = clock.planned_step(),
                       .reached = clock.time(),
                       .ended = clock.time() >= clock.end(),
                       .stopped = stopped_,
                       .dearer = of_first_part_ > 0 ? each / of_first_part_ : 1};
  }

 private:
  /// The clock stands before its end, and it was not this sample that had seen enough.
  void note_stop(const Clock& clock) { stopped_ = clock.finished() && clock.time() < clock.end(); }
  Monitor<Dim>& monitor_;
  SampleLimits limits_;
  Real first_ = 0, last_ = 0;  // [s]
  Real of_first_part_ = 0;     // [s] a step
  std::int64_t steps_ = 0;
  bool stopped_ = false;
};
}  // namespace

Real processor_seconds() {
  timespec now{};
  if (clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now) != 0) return 0;
  return static_cast<Real>(now.tv_sec) + 1e-9 * static_cast<Real>(now.tv_nsec);
}

template <int Dim>
std::optional<Calibration> calibrate(const LoadedDeck& loaded, Scene<Dim>& scene,
                                     const SampleLimits& limits) {
  const Deck& deck = loaded.deck;
  std::error_code error;
  const fs::path folder =
      fs::temp_directory_path(error) / ("brunt-plan-" + std::to_string(getpid()));
  if (error || !fs::create_directory(folder, error)) return std::nullopt;
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  std::optional<Calibration> found;
  try {
    HistoryWriter history(folder / "history.csv", HistoryColumns<Dim>(scene).names());
    const auto frames = make_frame_sink(folder, lone_rank());
    Monitor<Dim> monitor(deck, &history, frames.get(), true, [](const RunWarning&) {});
    Sample<Dim> sample(monitor, limits);
    Clock clock(deck.time.end, deck.time.safety, deck.time.max_step.value_or(kInfinity),
                deck.time.min_step, deck.time.process_speed);
    run_time_loop<Dim>(scene, clock, sample);
    found = sample.result(clock);
    if (found) found->points = static_cast<Real>(scene.n_points());
  } catch (const std::exception&) {
    found.reset();  // a plan says nothing of what breaks; the run will
  }
  omp_set_num_threads(threads);
  fs::remove_all(folder, error);
  return found;
}

template std::optional<Calibration> calibrate(const LoadedDeck&, Scene<2>&, const SampleLimits&);
template std::optional<Calibration> calibrate(const LoadedDeck&, Scene<3>&, const SampleLimits&);

}  // namespace brunt
