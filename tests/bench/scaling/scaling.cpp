// What a run on 2, 4, ... 4096 ranks would compute, copy and send, without those ranks: the scene
// is built as `run` builds it, its points are partitioned by the same bisection, and what every
// rank would have is counted. With it a simple model of the time of a step.
//   scaling DECK [--set KEY=VALUE]... [--steps N] [--ranks N,...] [--csv]
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <numeric>

#include "app/loop/time_loop.hpp"
#include "app/ranks/distribute.hpp"
#include "app/setup/scene_builder.hpp"
#include "app/watch/column_names.hpp"
#include "app/watch/output_steps.hpp"
#include "io/summary.hpp"
#include "sph/particles.hpp"
#include "step_model.hpp"

namespace brunt {
namespace {

struct Arguments {
  std::string deck, summary;
  std::vector<std::string> overrides;
  std::vector<int> ranks = {1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096};
  std::int64_t steps = 50;
  bool csv = false, again = false;
  Real latency = 1.5, bandwidth = 10;                                   // [us], [GB/s]
  Real ns_element = 0, ns_particle = 0, ns_candidate = 0, ns_face = 0;  // [ns]; 0: as measured
};

/// Stops after so many steps.
template <int Dim>
class StopAfter final : public Observer<Dim> {
 public:
  explicit StopAfter(std::int64_t steps) : steps_(steps) {}
  void begin(Scene<Dim>&, Clock& clock) override {
    if (steps_ == 0) clock.stop();
  }
  void step_done(Scene<Dim>&, Clock& clock) override {
    if (clock.step() == steps_) clock.stop();
  }

 private:
  std::int64_t steps_;
};

template <int Dim>
std::int64_t searches(const Scene<Dim>& scene) {
  std::int64_t n = 0;
  for (const auto& solid : scene.solids) {
    const auto* particles = dynamic_cast<const SphParticles<Dim>*>(solid.get());
    if (particles != nullptr) n += particles->n_searches();
  }
  return n;
}

/// How often all ranks meet in a step: as time loop, observers and contact ask for it.
template <int Dim>
void count_meetings(const Deck& deck, const Scene<Dim>& scene, Real dt, Rates& rates) {
  const Real every = deck.output.history.value_or(deck.time.end / 2000);
  rates.rows = std::min(1.0, dt / every) + 0.01 * std::max(0.0, 1 - dt / every);
  if (!deck.output.history) {
    const OutputWork work = output_work(scene, column_names(scene).names.size());
    const Real sure = sure_rows(work) * dt / deck.time.end;
    rates.rows =
        std::min(rates.rows, std::max(sure, 1 / static_cast<Real>(steps_between_rows(work))));
  }
  // Columns, bodies, hash; what supports take.
  Real row = 3 + static_cast<Real>(scene.boundaries.template of<PrescribedMotion>().size());
  rates.reductions = 1.01;  // the head of a step, and checks
  if (deck.stop.at_rest) rates.reductions += 1;
  if (deck.stop.beyond) rates.reductions += 1;
  if (scene.n_particles() > 0) {
    rates.reductions += 1 + rates.particle_lists;
    rates.exchanges += 2 * rates.particle_lists;
  }
  if (scene.contact) {
    row += 1;
    rates.reductions += 1 + 5 * rates.contact_lists;
    rates.exchanges += (4 + static_cast<Real>(scene.solids.size())) * rates.contact_lists;
  }
  rates.reductions += rates.rows * row;
}

/// What an element and a particle take by themselves, of the phases of a run on one rank: contact,
/// rows and frames are counted apart.
void take_costs(const RunSummary& summary, Machine& machine) {
  const auto seconds = [&](const char* phase) {
    const auto found = std::find_if(summary.phases.begin(), summary.phases.end(),
                                    [&](const auto& one) { return one.first == phase; });
    return found == summary.phases.end() ? 0.0 : found->second;
  };
  const auto elements = static_cast<Real>(summary.elements);
  const auto particles = static_cast<Real>(summary.particles);
  const auto steps = static_cast<Real>(summary.steps);
  if (steps == 0 || elements + particles == 0) return;
  const Real shared = (seconds("points") + seconds("step_bound")) / (elements + particles);
  if (elements > 0) machine.element = (seconds("elements") / elements + shared) / steps;
  if (particles > 0) {
    machine.particle = ((seconds("particles") + seconds("search")) / particles + shared) / steps;
  }
}

/// Steps the scene on this one rank; from that, what work costs and how often lists are made.
template <int Dim>
void measure(const Deck& deck, const Arguments& arguments, Scene<Dim>& scene, Machine& machine,
             Rates& rates) {
  Clock clock(deck.time.end, deck.time.safety, deck.time.max_step.value_or(kInfinity));
  StopAfter<Dim> observer(arguments.steps);
  const auto searches_before = searches(scene);
  const auto builds_before = scene.contact ? scene.contact->work().builds : 0;
  if (arguments.ns_candidate > 0) machine.candidate = 1e-9 * arguments.ns_candidate;
  run_time_loop(scene, clock, observer);
  const auto steps = static_cast<Real>(clock.step());
  const Real dt =
      steps > 0 ? clock.dt() : deck.time.safety * scene.stable_step(0, scene.heat_step()).step;
  rates.particle_lists = 1.0 / 15, rates.contact_lists = 1.0 / 15;
  if (steps > 0) {
    rates.particle_lists = static_cast<Real>(searches(scene) - searches_before) / steps;
    if (scene.contact) {
      // One is of the start.
      const auto builds = static_cast<Real>(scene.contact->work().builds - builds_before) - 1;
      rates.contact_lists = std::max(0.0, builds) / steps;
      const auto listed = static_cast<Real>(scene.contact->work().candidates);
      const auto reaches = scene.contact->reaches();
      const auto surface = static_cast<Real>(reaches.faces.size() + reaches.particles.size());
      const Real seconds = scene.phases.of(Phase::contact).work() / steps;
      machine.surface = std::max(0.0, seconds - listed * machine.candidate) / surface;
    }
  }
  count_meetings(deck, scene, dt, rates);
  if (!arguments.summary.empty()) {
    take_costs(read_summary(arguments.summary), machine);
  }
  if (arguments.ns_element > 0) machine.element = 1e-9 * arguments.ns_element;
  if (arguments.ns_particle > 0) machine.particle = 1e-9 * arguments.ns_particle;
  if (arguments.ns_face > 0) machine.surface = 1e-9 * arguments.ns_face;
  machine.latency = 1e-6 * arguments.latency;
  machine.bandwidth = 1e9 * arguments.bandwidth;
}

struct Spread {
  Real sum = 0, mean = 0, max = 0;
};

template <class Value>
Spread spread(const std::vector<RankLoad>& loads, Value value) {
  Spread spread;
  for (const auto& load : loads) {
    const auto one = static_cast<Real>(value(load));
    spread.sum += one;
    spread.max = std::max(spread.max, one);
  }
  spread.mean = spread.sum / static_cast<Real>(loads.size());
  return spread;
}

/// Mean and largest over the mean of another.
Spread over(Spread part, const Spread& whole) {
  if (whole.mean == 0) return {};
  return {part.sum / whole.sum, part.mean / whole.mean, part.max / whole.mean};
}

void print_heads(bool csv) {
  if (csv) {
    std::printf(
        "ranks,points,elements,particles,ghosts,computed,balance,messages_step,bytes_step,"
        "reductions_step,efficiency\n");
    return;
  }
  std::printf(
      "  ranks points/rank balance   ghosts/owned  elements again      messages          kB sent"
      "   work  neigh. lists   all eff.\n"
      "              mean  max/mean  mean    max    mean    max    mean    max    mean     max"
      "                  [us]\n");
}

void print_ranks(const std::vector<RankLoad>& loads, const Machine& machine, const Rates& rates,
                 Real alone, bool csv) {
  const int n = static_cast<int>(loads.size());
  const auto messages = [&](const RankLoad& load) {
    return load.step.messages + rates.particle_lists * load.particle_lists.messages +
           rates.contact_lists * load.contact_lists.messages;
  };
  const auto bytes = [&](const RankLoad& load) {
    return load.step.bytes + rates.particle_lists * load.particle_lists.bytes +
           rates.contact_lists * load.contact_lists.bytes;
  };
  const auto field = [&](auto member) {
    return spread(loads, [member](const RankLoad& load) { return load.*member; });
  };
  const Spread weight = field(&RankLoad::weight), points = field(&RankLoad::points);
  const Spread ghosts = over(field(&RankLoad::ghosts), points);
  const Spread again =
      over(spread(loads,
                  [](const RankLoad& load) {
                    return static_cast<Real>(load.computed) - static_cast<Real>(load.elements);
                  }),
           field(&RankLoad::elements));
  const Spread sent = spread(loads, messages), volume = spread(loads, bytes);
  StepCost slowest;
  for (const auto& load : loads) {
    const StepCost cost = step_cost(load, machine, rates, n);
    if (cost.total() > slowest.total()) slowest = cost;
  }
  const Real efficiency = alone / (n * slowest.total());
  const Real meetings = n > 1 ? rates.reductions + rates.exchanges : 0.0;
  if (csv) {
    std::printf("%d,%.0f,%.0f,%.0f,%.0f,%.0f,%.4f,%.4f,%.1f,%.3f,%.4f\n", n, points.sum,
                field(&RankLoad::elements).sum, field(&RankLoad::particles).sum,
                field(&RankLoad::ghosts).sum, field(&RankLoad::computed).sum,
                weight.max / weight.mean, sent.sum, volume.sum, meetings, efficiency);
    return;
  }
  std::printf(
      "%7d %11.1f %8.3f %6.2f %6.2f  %6.2f %6.2f  %6.1f %6.0f %7.1f %7.1f %7.0f %6.1f %5.1f %6.1f "
      "%.2f\n",
      n, points.mean, weight.max / weight.mean, ghosts.mean, ghosts.max, again.mean, again.max,
      sent.mean, sent.max, 1e-3 * volume.mean, 1e-3 * volume.max, 1e6 * slowest.work,
      1e6 * slowest.neighbours, 1e6 * slowest.lists, 1e6 * slowest.all_ranks, efficiency);
}

/// The points where they are now, weighed by the work that was measured: what Balance partitions
/// by.
template <int Dim>
WeighedPoints<Dim> measured_points(const Scene<Dim>& scene, const Machine& machine) {
  auto all = weighed_points(scene);
  const auto add = [&](const Points<Dim>& points, const std::vector<Real>& shares, Real seconds) {
    const Real sum = std::accumulate(shares.begin(), shares.end(), 0.0);
    for (std::size_t i = 0; i < shares.size() && sum > 0; ++i) {
      all.weight[points.id[i]] += seconds * shares[i] / sum;
    }
  };
  std::fill(all.weight.begin(), all.weight.end(), 0.0);
  for (const auto& solid : scene.solids) {
    add(solid->points(), solid->point_work(),
        static_cast<Real>(solid->n_elements()) * machine.element +
            static_cast<Real>(solid->n_particles()) * machine.particle);
  }
  if (!scene.contact) return all;
  const auto shares = scene.contact->point_work();
  Real sum = 0;
  for (const auto& of : shares) sum = std::accumulate(of.begin(), of.end(), sum);
  const auto listed = static_cast<Real>(scene.contact->work().candidates);
  for (std::size_t s = 0; s < shares.size() && sum > 0; ++s) {
    const Real part = std::accumulate(shares[s].begin(), shares[s].end(), 0.0) / sum;
    add(scene.solids[s]->points(), shares[s], part * listed * machine.candidate);
  }
  return all;
}

template <int Dim>
void print_tables(const LoadedDeck& loaded, const Arguments& arguments) {
  const auto scene = build_scene<Dim>(loaded);
  auto points = weighed_points(*scene);
  Machine machine;
  Rates rates;
  measure(loaded.deck, arguments, *scene, machine, rates);
  if (arguments.again) points = measured_points(*scene, machine);
  std::vector<Partition> partitions;
  for (const int n : arguments.ranks) {
    partitions.push_back(make_partition<Dim>(lone_rank(), points.x, points.weight, n));
  }
  const auto whole = make_partition<Dim>(lone_rank(), points.x, points.weight);
  const auto alone = rank_loads<Dim>(*scene, whole, points.weight, 1);
  if (!arguments.csv) {
    std::printf("%zu points, %zu elements, %zu particles, %zu candidates of contact\n",
                scene->n_points(), scene->n_elements(), scene->n_particles(),
                alone.front().candidates);
    std::printf(
        "an element %.0f ns, a particle %.0f ns, a candidate %.0f ns, a face %.0f ns; a message "
        "%.2f us, "
        "%.3g GB/s\n",
        1e9 * machine.element, 1e9 * machine.particle, 1e9 * machine.candidate,
        1e9 * machine.surface, 1e6 * machine.latency, 1e-9 * machine.bandwidth);
    std::printf(
        "a step: %.3f lists of particles, %.3f of contact, %.2f rows, %.2f reductions, "
        "%.2f exchanges of sizes\n",
        rates.particle_lists, rates.contact_lists, rates.rows, rates.reductions, rates.exchanges);
  }
  print_heads(arguments.csv);
  const Real seconds = work_of(alone.front(), machine);
  for (std::size_t k = 0; k < partitions.size(); ++k) {
    const auto loads = rank_loads<Dim>(*scene, partitions[k], points.weight, arguments.ranks[k]);
    print_ranks(loads, machine, arguments.ranks[k] > 1 ? rates : Rates{}, seconds, arguments.csv);
  }
}

int run(int argc, char** argv) {
  CLI::App app{"what a run on many ranks would compute, copy and send"};
  Arguments arguments;
  app.add_option("DECK", arguments.deck)->required();
  app.add_option("--set", arguments.overrides, "overrides a key")->allow_extra_args(false);
  app.add_option("--ranks", arguments.ranks, "numbers of ranks")->delimiter(',');
  app.add_option("--steps", arguments.steps, "taken first, by this one rank");
  app.add_option("--summary", arguments.summary, "folder of a run whose costs are taken");
  app.add_option("--ns-element", arguments.ns_element);
  app.add_option("--ns-particle", arguments.ns_particle);
  app.add_option("--ns-candidate", arguments.ns_candidate);
  app.add_option("--ns-face", arguments.ns_face, "of a face or particle of contact");
  app.add_option("--latency", arguments.latency, "of a message [us]");
  app.add_option("--bandwidth", arguments.bandwidth, "of a rank [GB/s]");
  app.add_flag("--again", arguments.again, "repartitions by the work after the steps");
  app.add_flag("--csv", arguments.csv, "sums over the ranks, for programs");
  CLI11_PARSE(app, argc, argv);
  const ParallelSession session(argc, argv);
  try {
    const LoadedDeck loaded = load_deck(arguments.deck, arguments.overrides);
    loaded.deck.geometry == Geometry::three_d ? print_tables<3>(loaded, arguments)
                                              : print_tables<2>(loaded, arguments);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "scaling: %s\n", error.what());
    return 1;
  }
  return 0;
}

}  // namespace
}  // namespace brunt

int main(int argc, char** argv) { return brunt::run(argc, argv); }
