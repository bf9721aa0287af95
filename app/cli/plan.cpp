#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/cli/calibration.hpp"
#include "app/cli/forecast.hpp"
#include "app/cli/memory.hpp"
#include "app/cli/plan_pairs.hpp"
#include "app/cli/rehearsal.hpp"
#include "app/cli/run.hpp"
#include "app/deck/findings.hpp"
#include "app/setup/heat.hpp"
#include "app/setup/scene_builder.hpp"
#include "app/setup/scene_checks.hpp"
#include "app/setup/sound_part.hpp"
#include "app/watch/history_columns.hpp"
#include "app/watch/progress.hpp"
#include "io/number.hpp"

namespace brunt {

namespace {
/// How a rigid body moves; of one that follows its forces also what it weighs.
template <int Dim>
std::string rigid_text(const deck::Body& body, const Scene<Dim>& scene, Label label) {
  if (!deck::follows_forces(body)) return body.motion ? "has a prescribed motion" : "held";
  ExactSum mass;
  std::size_t pieces = 0;
  for (const auto& one : scene.rigid->all()) {
    if (one.body != label) continue;
    mass.add(one.state.mass);
    ++pieces;
  }
  std::string text = body.motion ? "moves in part as prescribed" : "free";
  if (pieces > 1) text += ", " + std::to_string(pieces) + " pieces";
  return text + ", " + deck::short_text(mass.value()) + " kg of " + body.material;
}

template <int Dim>
void print_bodies(const LoadedDeck& loaded, const Scene<Dim>& scene) {
  for (std::size_t b = 0; b < scene.body_names.size(); ++b) {
    const auto& body = loaded.deck.bodies[b].value;
    std::size_t points = 0;
    for (const auto& solid : scene.solids) {
      if (solid->rides()) continue;
      for (const Label label : solid->points().body) points += label == b;
    }
    const std::size_t elements = scene.view(static_cast<Label>(b), kNoFields).n_cells();
    if (body.rigid) {
      const bool conducts = heat_mode(loaded.deck, body, scene.body_names[b]) == HeatMode::conducts;
      std::printf("  %-16s rigid, %s: %zu %s%s\n", scene.body_names[b].c_str(),
                  rigid_text(body, scene, static_cast<Label>(b)).c_str(), elements,
                  conducts ? "element" : "facet", elements == 1 ? "" : "s");
    } else if (body.method == deck::Method::fe) {
      std::printf("  %-16s finite elements: %zu elements, %zu nodes, material %s\n",
                  scene.body_names[b].c_str(), elements, points, body.material.c_str());
    } else {
      std::printf("  %-16s SPH: %zu particles, material %s\n", scene.body_names[b].c_str(), points,
                  body.material.c_str());
    }
  }
}

void print_physics(const LoadedDeck& loaded) {
  std::string heated, conducts, uneven;
  for (const auto& [name, body] : loaded.deck.bodies) {
    const HeatMode mode = heat_mode(loaded.deck, body, name);
    if (mode == HeatMode::adiabatic) heated += " " + name;
    if (mode == HeatMode::conducts) conducts += " " + name;
    if (mode == HeatMode::conducts && is_held(loaded.deck, name)) conducts += " (held)";
    if (mode == HeatMode::none && deck::has_temperature_field(body)) uneven += " " + name;
  }
  if (!conducts.empty()) std::printf("heat       is conducted in:%s\n", conducts.c_str());
  if (!heated.empty()) {
    std::printf("heat       adiabatic, plastic work heats the point where it is done, in:%s\n",
                heated.c_str());
  }
  if (!uneven.empty()) {
    std::printf("heat       none, each point keeps the temperature of time 0, in:%s\n",
                uneven.c_str());
  }
  if (conducts.empty() && heated.empty() && uneven.empty()) {
    std::printf("heat       none: no material is heated, no temperature is kept\n");
  }
  if (loaded.deck.has_gravity()) std::printf("gravity    yes\n");
  const Real speed = loaded.deck.time.process_speed;
  if (loaded.deck.damping) std::printf("damping    %g 1/s\n", loaded.deck.damping->rate / speed);
  if (speed != 1) std::printf("process    stepped %g times faster; all times are real\n", speed);
}

/// The memory that a run will need, and of it the parts that matter.
void print_memory(const MemoryEstimate& memory) {
  std::printf("memory     about %.0f MB:", memory.total() / 1e6);
  const std::pair<const char*, Real> parts[] = {
      {"program", memory.program},     {"elements", memory.elements},
      {"particles", memory.particles}, {"neighbours", memory.neighbours},
      {"contact", memory.contact},     {"building or output", memory.passing},
      {"history", memory.rows}};
  const char* separator = " ";
  for (const auto& [name, bytes] : parts) {
    if (bytes < 0.5e6) continue;
    std::printf("%s%s %.0f", separator, name, bytes / 1e6);
    separator = ", ";
  }
  if (memory.converted > 0.5e6) {
    std::printf("; up to %.0f more\n           as elements become particles",
                memory.converted / 1e6);
  }
  std::printf("\n");
}

constexpr Real kHardly = 1.2;  // growth of the steps that is not worth a word

/// What is known of the steps of a run.
struct PlannedSteps {
  Real kept = 0;                      ///< if all were as long as the first
  std::vector<Rehearsal> rehearsals;  ///< of elements that may flatten
  Flattening flattening;

  bool flattens() const { return flattening.most_steps() >= kHardly; }
  bool whole() const { return !rehearsals.empty() && rehearsals.front().factor == 1; }
  /// Where nothing flattens, coarse rehearsals say what steps cost and where `stop` ends, no more.
  Real growth() const { return flattens() || whole() ? expected_growth(rehearsals) : 1; }
  Real expected() const { return kept * growth() * expected_share(rehearsals); }
  /// Without a rehearsal: if they flatten as far as the energy allows.
  Real most() const {
    return flattens() && rehearsals.empty() ? kept * flattening.most_steps() : expected();
  }
};

/// Rehearses a run of elements that may flatten. Where those of a body as a whole hardly do, some
/// that are struck by an edge may yet: a short run is tried.
PlannedSteps plan_steps(const RunArguments& arguments, const LoadedDeck& loaded, Real kept,
                        const std::optional<Calibration>& measured) {
  PlannedSteps steps{kept, {}, flattening_of(loaded.deck)};
  if (!measured) return steps;
  if (measured->whole()) {
    const Real share = measured->reached / loaded.deck.time.end;
    steps.rehearsals = {{1, static_cast<Real>(measured->steps) / (kept * share), 1, share}};
    return steps;
  }
  if (!arguments.rehearse) return steps;
  steps.rehearsals = rehearse(arguments.deck, arguments.overrides, loaded, *measured,
                              measured->seconds_per_step * kept);
  return steps;
}

/// Rounded; more digits are not known.
Real two_digits(Real steps) {
  const Real digits = std::pow(10, std::floor(std::log10(steps)) - 1);
  return digits * std::round(steps / digits);
}

/// How many steps a run will take.
void print_steps(const Deck& deck, const PlannedSteps& steps) {
  const Real share = expected_share(steps.rehearsals);
  std::string end = deck::time_text(deck.time.real(share * deck.time.end));
  if (share < 1) {
    end += ", where `stop` ends " + std::string(steps.whole() ? "it" : "a coarser run");
  } else if (!deck.stop.when.empty() || deck.stop.at_rest || deck.stop.beyond) {
    end += ", or until `stop`";
  }
  const std::string speed = deck::short_text(steps.flattening.speed);
  if (steps.whole()) {
    std::printf("steps      %.0f to %s, by a run of the deck itself\n", std::ceil(steps.expected()),
                end.c_str());
    return;
  }
  if (steps.most() < kHardly * steps.kept) {
    std::printf("steps      about %.0f to %s; more where elements are driven flat\n",
                std::ceil(steps.expected()), end.c_str());
    return;
  }
  if (steps.rehearsals.empty()) {
    std::printf(
        "steps      %.0f to %.0f up to %s: %.0f while elements keep their shapes, and how far "
        "those\n           that meet at %s m/s flatten is not known; a step is as long as the "
        "thinnest is thick\n",
        steps.kept, two_digits(steps.most()), end.c_str(), steps.kept, speed.c_str());
    return;
  }
  std::string sizes;
  for (std::size_t k = 0; k < steps.rehearsals.size(); ++k) {
    if (k > 0) sizes += k + 1 < steps.rehearsals.size() ? ", " : " and ";
    sizes += rounded(steps.rehearsals[k].factor, 2);
  }
  std::printf(
      "steps      about %.0f to %s: %.0f while shapes stay as they are, but what meets at %s m/s "
      "is\n           flattened: %s times as many, by rehearsals with sizes %s times as large\n",
      two_digits(steps.expected()), end.c_str(), steps.kept, speed.c_str(),
      rounded(expected_growth(steps.rehearsals), 2).c_str(), sizes.c_str());
}

/// Names of the columns of history.csv, for measures.
template <int Dim>
void print_columns(const Scene<Dim>& scene) {
  constexpr std::size_t kWidth = 96;
  std::string line = "history   ";
  const HistoryColumns<Dim> columns(scene);
  for (const auto& name : columns.names()) {
    if (line.size() + 1 + name.size() > kWidth) {
      std::printf("%s\n", line.c_str());
      line = "          ";
    }
    line += " " + name;
  }
  std::printf("%s\n", line.c_str());
}

template <int Dim>
void print_contact(const Scene<Dim>& scene) {
  if (!scene.contact) {
    std::printf("contact    none: nothing can touch\n");
    return;
  }
  const auto reported = scene.contact->reports();
  std::printf("contact    %zu facets; ", scene.contact->n_facets());
  if (reported.size() < scene.contact->n_pairs()) {
    std::printf("%zu pairs, with columns in history.csv:", scene.contact->n_pairs());
  } else {
    std::printf("pairs:");
  }
  for (const auto& pair : reported) std::printf(" %s", pair.name.c_str());
  if (reported.empty()) std::printf(" none, as none is named in `contact: {pairs: ...}`");
  std::printf("\n");
}

/// Every pair of a small scene; of a large one those that are not modelled, by their number.
template <int Dim>
void print_pairs(const Deck& deck, const Scene<Dim>& scene) {
  constexpr std::size_t kMany = 15;
  const auto pairs = planned_pairs(deck, scene);
  if (pairs.size() <= kMany) {
    for (const auto& pair : pairs) {
      std::printf("  %-24s %s%s\n", pair.name.c_str(),
                  pair.modelled ? "" : "not modelled: ", pair.what.c_str());
    }
    return;
  }
  std::size_t modelled = 0;
  for (const auto& pair : pairs) modelled += pair.modelled;
  std::printf("  %zu of %zu pairs of bodies may touch\n", modelled, pairs.size());
}

/// How long the run will take on one thread, by its own first steps.
void print_time(const PlannedSteps& steps, const std::optional<Calibration>& measured) {
  if (!measured) {
    std::printf("time       not known: the first steps do not run\n");
    return;
  }
  const Real dearer = expected_cost(steps.rehearsals);
  const auto seconds = [&](Real n) {
    return measured->start + n * dearer * measured->seconds_per_step;
  };
  const Real least = steps.rehearsals.empty() ? steps.kept : steps.expected();
  std::string range = duration_text(seconds(least));
  if (steps.most() > kHardly * least) range += " to " + duration_text(seconds(steps.most()));
  std::printf("time       about %s of one thread: %s a step, measured over the first %lld",
              range.c_str(), deck::time_text(measured->seconds_per_step).c_str(),
              static_cast<long long>(measured->steps));
  const bool changes = std::fabs(dearer - 1) >= kHardly - 1;
  std::printf(changes ? "; %s of that in the mean of a run\n" : "\n", rounded(dearer, 2).c_str());
}

/// The whole scene of a deck, with what it has to be warned of.
template <int Dim>
std::unique_ptr<Scene<Dim>> build_and_warn(const LoadedDeck& loaded) {
  auto scene = build_scene<Dim>(loaded);
  std::vector<DeckProblem> warnings;
  warn_of_scene(loaded, *scene, true, warnings);
  return scene;
}

/// The longest stable step of heat, and for how many steps an evaluation of conduction acts.
/// dt, heat_step  [s] of the run, of heat alone
void print_heat(const Deck& deck, const HeatWindows& windows, Real dt, Real heat_step) {
  constexpr std::int64_t kLate = 1000000;  // steps after which only physics bounds a window
  const int steps = windows.length(kLate, dt, heat_step);
  const std::string every =
      windows.is_chosen() ? "auto, " + std::to_string(steps) + " at time 0" : std::to_string(steps);
  if (heat_step == kInfinity) {
    std::printf("heat step  no heat flows at time 0; time.heat_every: %s\n",
                windows.is_chosen() ? "auto" : every.c_str());
    return;
  }
  std::printf("heat step  stable up to %s, %.2g of the run's steps; time.heat_every: %s\n",
              deck::time_text(deck.time.real(heat_step)).c_str(), heat_step / dt, every.c_str());
}

template <int Dim>
void print_plan(const RunArguments& arguments, const LoadedDeck& loaded, Real program) {
  auto scene = build_and_warn<Dim>(loaded);
  static constexpr const char* geometries[] = {"3d", "plane strain", "axisymmetric"};
  if (!loaded.deck.title.empty()) std::printf("%s\n", loaded.deck.title.c_str());
  std::printf("geometry   %s\n", geometries[static_cast<int>(scene->geometry)]);
  print_bodies(loaded, *scene);
  print_physics(loaded);
  print_contact(*scene);
  print_pairs(loaded.deck, *scene);
  scene->rigid_motions.start();
  scene->boundaries.start();
  scene->rearrange();
  const Deck& deck = loaded.deck;
  const Real max_step = deck.time.max_step.value_or(kInfinity);
  const StepLimit of_heat = scene->heat_step();
  const StepLimit step_limit = scene->stable_step(0, of_heat);
  const Real dt = std::min(deck.time.safety * step_limit.step, max_step);
  const Real kept = std::ceil(deck.time.end / dt);
  const bool conducts = scene->conducts();
  const HeatWindows windows = scene->heat_windows;
  const Real heat_step = windows.bounding_steps() * of_heat.step;
  const MemoryEstimate memory = memory_of(*scene, memory_inputs(deck, *scene, program));
  const std::string whose = scene->body_names[step_limit.body];
  std::printf("points     %zu (%zu elements, %zu particles)\n", scene->n_points(),
              scene->n_elements(), scene->n_particles());
  scene.reset();
  scene = build_scene<Dim>(loaded);  // as it is at time 0
  const auto measured = calibrate(loaded, *scene);
  print_memory(memory);
  std::printf("step       %s, bound by %s of %s\n", deck::time_text(deck.time.real(dt)).c_str(),
              step_limit.reason, whose.c_str());
  const PlannedSteps steps = plan_steps(arguments, loaded, kept, measured);
  print_steps(deck, steps);
  if (conducts) print_heat(deck, windows, dt, heat_step);
  print_columns(*scene);
  print_time(steps, measured);
}

}  // namespace

int plan_command(const RunArguments& arguments) {
  const LoadedDeck loaded = load_or_tell_all(arguments.deck, arguments.overrides);
  const Real program = resident_memory();
  if (loaded.deck.geometry == Geometry::three_d) {
    print_plan<3>(arguments, loaded, program);
  } else {
    print_plan<2>(arguments, loaded, program);
  }
  return kDone;
}

int check_command(const RunArguments& arguments) {
  const LoadedDeck loaded = load_or_tell_all(arguments.deck, arguments.overrides);
  if (loaded.deck.geometry == Geometry::three_d) {
    build_and_warn<3>(loaded);
  } else {
    build_and_warn<2>(loaded);
  }
  std::printf("%s: nothing is wrong\n", arguments.deck.c_str());
  return kDone;
}

}  // namespace brunt
