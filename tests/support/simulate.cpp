#include "tests/support/simulate.hpp"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "app/restart/checkpointing.hpp"
#include "app/setup/scene_builder.hpp"
#include "app/watch/monitor.hpp"
#include "tests/support/source_path.hpp"

namespace brunt::test {

std::size_t Simulation::index(const std::string& column) const {
  const auto found = std::find(columns.begin(), columns.end(), column);
  if (found == columns.end()) throw std::invalid_argument("no column " + column);
  return static_cast<std::size_t>(found - columns.begin());
}

std::vector<Real> Simulation::column(const std::string& name) const {
  const std::size_t c = index(name);
  std::vector<Real> values;
  for (const auto& row : rows) values.push_back(row[c]);
  return values;
}

Real Simulation::largest_energy() const {
  Real largest = 0;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    if (!columns[c].starts_with("energy.") || columns[c] == "energy.drift") continue;
    for (const auto& row : rows) largest = std::max(largest, std::fabs(row[c]));
  }
  return largest;
}

namespace {
/// A folder that goes away with it.
struct TemporaryFolder {
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "brunt-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path = name;
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  std::filesystem::path path;
};

/// Passes on to another observer and to the hooks, and rearranges after every step where that is
/// asked for.
template <int Dim>
class Watcher final : public Observer<Dim> {
 public:
  Watcher(Observer<Dim>& inner, bool rearrange, const SceneHooks& hooks)
      : inner_(inner), rearrange_(rearrange), hooks_(hooks) {}
  void begin(Scene<Dim>& scene, Clock& clock) override { inner_.begin(scene, clock); }
  Requests requests(const Scene<Dim>& scene, const Clock& clock) override {
    return inner_.requests(scene, clock);
  }
  void answer(const StepHead& head, Scene<Dim>& scene, Clock& clock) override {
    inner_.answer(head, scene, clock);
  }
  void step_done(Scene<Dim>& scene, Clock& clock) override {
    inner_.step_done(scene, clock);
    if constexpr (Dim == 3) {
      if (hooks_.step_done) hooks_.step_done(scene, clock);
    }
    if (hooks_.moved) {
      hooks_.moved(clock.step(), [&](Label body) { return scene.view(body); });
    }
    if (rearrange_) scene.rearrange();
  }

 private:
  Observer<Dim>& inner_;
  bool rearrange_;
  const SceneHooks& hooks_;
};

template <int Dim>
Simulation simulate_scene(const LoadedDeck& loaded, const RunVariation& variation,
                          const SceneHooks& hooks, const std::filesystem::path& folder,
                          Restart* restart) {
  auto scene = build_scene<Dim>(loaded);
  if constexpr (Dim == 3) {
    if (hooks.built) hooks.built(*scene);
  }
  const Deck& deck = loaded.deck;
  Clock clock(deck.time.end, deck.time.safety, deck.time.max_step.value_or(kInfinity),
              deck.time.min_step, deck.time.process_speed);
  Simulation result;
  Monitor<Dim> monitor(deck, nullptr, nullptr, true, [&](const RunWarning& said) {
    if (said.id == "contact") result.warnings.push_back(said.text);
  });
  const std::int64_t stop_at = restart == nullptr ? variation.split_at : 0;
  std::int64_t steps = 0;
  Checkpointing<Dim> checkpointing(loaded, folder, monitor, restart, [&] {
    return Requests{false, ++steps == stop_at};
  });
  Watcher<Dim> observer(checkpointing, variation.rearrange_every_step, hooks);
  try {
    run_time_loop(*scene, clock, observer);
    monitor.end(*scene, clock);
  } catch (const PhysicsError& error) {
    result.failure = error.what();
  }
  result.columns = monitor.columns();
  result.columns.pop_back();
  result.rows = monitor.rows();
  result.hashes = monitor.hashes();
  for (const auto& measure : monitor.measures()) result.measures[measure.name] = measure.value;
  for (std::size_t b = 0; b < scene->body_names.size(); ++b) {
    result.bodies[scene->body_names[b]] = scene->view(static_cast<Label>(b));
  }
  if (scene->contact) {
    for (const auto& pair : scene->contact->lost_pairs(scene->origin)) {
      if (pair.lost.any()) result.lost[pair.name] = pair.lost;  // else they held, though deep
    }
  }
  result.steps = clock.step();
  result.steps_here = clock.step() - checkpointing.first_step();
  result.worst_drift = monitor.worst_drift();
  result.reason = monitor.reason();
  result.reported = monitor.warned();
  for (const auto& warning : monitor.body_warnings()) result.reported.push_back(warning);
  result.step_margins = monitor.step_check().margins();
  for (const auto& warning : monitor.step_check().warnings()) result.reported.push_back(warning);
  result.inertia = monitor.inertia();
  result.created = monitor.energy_shares().created;
  return result;
}
}  // namespace

Simulation simulate(const LoadedDeck& given, const RunVariation& variation,
                    const SceneHooks& hooks) {
  LoadedDeck loaded = given;
  loaded.deck.output.state_hash = true;  // tests compare runs by it
  const int threads = omp_get_max_threads();
  if (variation.threads > 0) omp_set_num_threads(variation.threads);
  const auto run = [&](const std::filesystem::path& folder, Restart* restart) {
    return loaded.deck.geometry == Geometry::three_d
               ? simulate_scene<3>(loaded, variation, hooks, folder, restart)
               : simulate_scene<2>(loaded, variation, hooks, folder, restart);
  };
  Simulation result;
  if (variation.split_at == 0) {
    result = run("", nullptr);
  } else {
    const TemporaryFolder folder;
    run(folder.path, nullptr);
    Restart restart(checkpoints_in(folder.path), loaded,
                    [](const std::string& reason) { throw std::runtime_error(reason); });
    if (!restart.next()) throw std::runtime_error("the first part wrote no checkpoint");
    result = run("", &restart);
  }
  omp_set_num_threads(threads);
  return result;
}

Simulation simulate_text(const std::string& text, const std::vector<std::string>& overrides,
                         const RunVariation& variation, const SceneHooks& hooks) {
  return simulate(load_deck_text(text, "test.yaml", overrides), variation, hooks);
}

Simulation simulate_shipped(const std::string& name, const std::vector<std::string>& overrides,
                            const RunVariation& variation) {
  const std::string file = name.find('/') == std::string::npos ? name + "/" + name : name;
  const std::string path = source_path("decks/" + file + ".yaml");
  return simulate(load_deck(path, overrides), variation);
}

}  // namespace brunt::test
