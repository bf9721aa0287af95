#include "app/trade/refine.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/loop/signals.hpp"
#include "app/trade/report.hpp"
#include "app/trade/results.hpp"
#include "app/trade/study.hpp"
#include "io/file.hpp"
#include "io/number.hpp"

namespace brunt {

namespace fs = std::filesystem;

namespace {
[[noreturn]] void refuse_refinement(const std::string& path, const std::string& message) {
  throw DeckError({{{"--refine", 0, 0}, path, message}});
}

/// "[4, 8]" of cells so many times as large; a single cell across stays one.
std::string cells_text(const std::vector<int>& cells, Real factor) {
  std::string text = "[";
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const auto scaled = static_cast<int>(std::lround(cells[c] / factor));
    text += (c > 0 ? ", " : "") + std::to_string(cells[c] == 1 ? 1 : std::max(1, scaled));
  }
  return text + "]";
}

std::string size_text(const std::vector<Real>& size, Real factor) {
  std::string text = "[";
  for (std::size_t c = 0; c < size.size(); ++c) {
    text += (c > 0 ? ", " : "") + shortest(factor * size[c]) + " m";
  }
  return size.size() == 1 ? text.substr(1) : text + "]";
}

/// The key of a body's size, "" where it has none of its own.
std::string size_key(const Named<deck::Body>& body) {
  if (!body.value.size && !body.value.cells) return "";
  return "bodies." + body.name + (body.value.cells ? ".cells" : ".size");
}

std::string override_of(const LoadedDeck& loaded, const std::string& key, Real factor) {
  constexpr std::string_view kParameters = "parameters.";
  if (key.starts_with(kParameters)) {
    for (const auto& parameter : loaded.parameters) {
      if (parameter.name != key.substr(kParameters.size())) continue;
      const bool plain = parameter.unit == "1";
      const bool whole = plain && parameter.value == std::round(parameter.value);
      if (whole) {  // a number of cells
        const Real cells = std::max(1.0, std::round(parameter.value / factor));
        return key + "=" + shortest(cells);
      }
      return key + "=" + shortest(factor * parameter.value) + (plain ? "" : " " + parameter.unit);
    }
  }
  for (const auto& body : loaded.deck.bodies) {
    if (size_key(body) != key) continue;
    return key + "=" +
           (body.value.cells ? cells_text(*body.value.cells, factor)
                             : size_text(*body.value.size, factor));
  }
  refuse_refinement(key, "is neither a parameter nor the size or cells of a body that deforms");
}

/// How many bodies another size of a parameter changes; 0 where the deck is then wrong, or is not
/// coarser.
std::size_t bodies_that_follow(const std::string& deck, const std::vector<std::string>& overrides,
                               const LoadedDeck& loaded, const std::string& key) {
  constexpr Real kTrial = 1.6;
  auto changed = overrides;
  changed.push_back(override_of(loaded, key, kTrial));
  std::vector<DeckProblem> problems;
  const LoadedDeck other = read_deck(deck, changed, problems);
  if (!problems.empty() || other.deck.bodies.size() != loaded.deck.bodies.size()) return 0;
  const auto ratio = size_ratio(other.deck, loaded.deck);
  if (!ratio || *ratio <= 1) return 0;
  std::size_t count = 0;
  for (std::size_t b = 0; b < loaded.deck.bodies.size(); ++b) {
    const auto& own = loaded.deck.bodies[b].value;
    const auto& its = other.deck.bodies[b].value;
    count += !own.rigid && (own.size != its.size || own.cells != its.cells);
  }
  return count;
}

/// A coarser deck that would not be coarse enough to be told apart, or too coarse to build, has
/// fewer than four cells along an axis that it divides.
bool can_be_halved(const LoadedDeck& loaded, const LoadedDeck& coarse) {
  for (std::size_t b = 0; b < loaded.deck.bodies.size(); ++b) {
    const auto& own = loaded.deck.bodies[b].value.cells;
    const auto& its = coarse.deck.bodies[b].value.cells;
    if (!own || !its) continue;
    for (std::size_t c = 0; c < std::min(own->size(), its->size()); ++c) {
      if ((*own)[c] != (*its)[c] && (*its)[c] < 2) return false;
    }
  }
  return true;
}

}  // namespace

std::optional<LoadedDeck> resized_deck(const std::string& deck,
                                       const std::vector<std::string>& overrides,
                                       const LoadedDeck& loaded) {
  std::vector<DeckProblem> problems;
  LoadedDeck resized = read_deck(deck, overrides, problems);
  if (!problems.empty() || !can_be_halved(loaded, resized)) return std::nullopt;
  return resized;
}

namespace {
/// The decks of these factors; nothing where one of them is wrong or not like the others.
std::vector<Variant> decks_of(const RefineArguments& arguments, const LoadedDeck& loaded,
                              const SizeLever& lever, const std::vector<Real>& factors) {
  std::vector<Variant> variants;
  for (const Real factor : factors) {
    Variant variant;
    variant.overrides = arguments.overrides;
    for (const auto& change : lever.at(loaded, factor)) {
      variant.overrides.push_back(change);
      variant.label += (variant.label.empty() ? "" : ", ") + change;
    }
    auto resized = resized_deck(arguments.deck, variant.overrides, loaded);
    if (!resized) return {};
    variant.loaded = std::move(*resized);
    const auto ratio = size_ratio(variant.loaded.deck, loaded.deck);
    if (!ratio) return {};
    variant.label = "size x " + rounded(*ratio, 3);
    const fs::path own = arguments.out.filename();
    variant.folder = (own.string() + ".refine/size-" + rounded(*ratio, 3));
    variants.push_back(std::move(variant));
  }
  return variants;
}

void add_bounds(const std::vector<Variant>& variants, const StudyResult& study,
                RunSummary& summary) {
  std::vector<Real> sizes;
  std::vector<const RunSummary*> runs;
  for (std::size_t v = 0; v < variants.size(); ++v) {
    if (!study.runs[v].done) continue;
    sizes.push_back(v == 0 ? 1.0 : *size_ratio(variants[v].loaded.deck, variants[0].loaded.deck));
    runs.push_back(&study.runs[v].summary);
  }
  const auto least = std::min_element(sizes.begin(), sizes.end()) - sizes.begin();
  const RunSummary& finest = *runs[slot_of(least)];
  for (auto& measure : summary.measures) {
    const auto found = convergence_of(sizes, runs, measure.name);
    if (!found) {
      measure.convergence = "no other size gave a value";
      continue;
    }
    measure.bound = found->bound;
    for (const auto& other : finest.measures) {  // where finer ones were run
      if (other.name == measure.name) *measure.bound += std::fabs(measure.value - other.value);
    }
    measure.order = found->order;
    measure.convergence = found->words;
  }
}

void print_bounds(const RunSummary& summary) {
  for (const auto& measure : summary.measures) {
    const bool plain = measure.unit.empty() || measure.unit == "any" || measure.unit == "1";
    const std::string unit = plain ? "" : " " + measure.unit;
    std::string text = rounded(measure.value, 6) + unit;
    if (measure.bound) text += " +- " + rounded(*measure.bound, 2) + unit;
    if (measure.bound && measure.value != 0) {
      text += " (" + rounded(100 * std::fabs(*measure.bound / measure.value), 2) + " %)";
    }
    std::fprintf(stderr, "  %-20s %s; %s\n", measure.name.c_str(), text.c_str(),
                 measure.convergence.c_str());
  }
}

/// Refuses what `brunt run` would, before anything runs.
void check_folder(const RefineArguments& arguments) {
  std::error_code error;
  if (arguments.force || arguments.resume || !fs::exists(arguments.out, error)) return;
  throw DeckError({{{arguments.out.string(), 0, 0},
                    "",
                    "the output folder exists; --force replaces it, --resume goes on with its run "
                    "or skips it where it is done, --out DIR names another"}});
}
}  // namespace

std::vector<std::string> SizeLever::at(const LoadedDeck& deck, Real factor) const {
  std::vector<std::string> overrides;
  overrides.reserve(keys.size());
  for (const auto& key : keys) overrides.push_back(override_of(deck, key, factor));
  return overrides;
}

SizeLever find_size_lever(const std::string& deck, const std::vector<std::string>& overrides,
                          const LoadedDeck& loaded, const std::string& key) {
  if (!key.empty()) {
    if (bodies_that_follow(deck, overrides, loaded, key) > 0) return {{key}};
    refuse_refinement(key, "makes no element and no particle larger");
  }
  std::string best;
  std::size_t most = 0;
  for (const auto& parameter : loaded.parameters) {
    const std::string candidate = "parameters." + parameter.name;
    const std::size_t count = bodies_that_follow(deck, overrides, loaded, candidate);
    if (count > most) most = count, best = candidate;
  }
  SizeLever lever;
  for (const auto& body : loaded.deck.bodies) {
    const std::string own = size_key(body);
    if (!body.value.rigid && !own.empty()) lever.keys.push_back(own);
  }
  if (lever.keys.empty()) refuse_refinement("bodies", "no body has a size or cells to change");
  if (most == lever.keys.size()) return {{best}};
  if (most == 0) return lever;
  return {{best}};
}

SizeLever own_sizes(const LoadedDeck& loaded) {
  SizeLever lever;
  for (const auto& body : loaded.deck.bodies) {
    const std::string own = size_key(body);
    if (own.empty() && !body.value.rigid) return {};
    if (!own.empty()) lever.keys.push_back(own);
  }
  return lever;
}

std::vector<Variant> size_variants(const RefineArguments& arguments) {
  Variant own;
  own.label = "as it stands";
  own.folder = arguments.out.filename().string();
  own.overrides = arguments.overrides;
  own.loaded = load_deck(arguments.deck, arguments.overrides);
  const SizeLever lever =
      find_size_lever(arguments.deck, arguments.overrides, own.loaded, arguments.key);
  std::vector<Real> coarser, finer;
  for (int k = 1; k < arguments.sizes; ++k) {
    coarser.push_back(std::pow(2, 0.5 * k));
    finer.push_back(std::pow(2, -0.5 * k));
  }
  auto others = decks_of(arguments, own.loaded, lever, coarser);
  if (others.empty()) others = decks_of(arguments, own.loaded, lever, finer);
  if (others.empty()) {
    refuse_refinement(lever.keys.front(), "gives neither coarser nor finer decks that can run");
  }
  std::vector<Variant> variants;
  variants.push_back(std::move(own));
  for (auto& other : others) variants.push_back(std::move(other));
  return variants;
}

int refine_command(const RefineArguments& arguments) {
  check_folder(arguments);
  const auto variants = size_variants(arguments);
  StudyOptions options;
  options.deck = arguments.deck;
  options.out = arguments.out.parent_path();
  options.words = arguments.out.string() + ".refine";
  options.repeat = 1;
  options.threads = arguments.threads;
  options.force = arguments.force, options.resume = arguments.resume;
  options.flags = arguments.flags;
  options.quiet = arguments.quiet;
  options.title = "refine";
  listen_to_signals();
  const StudyResult study = run_study(variants, options);
  if (study.stopped) {
    std::fprintf(stderr, "brunt: stopped; --resume goes on from there\n");
    return kStopped;
  }
  for (std::size_t v = 0; v < variants.size(); ++v) {
    if (study.runs[v].done) continue;
    std::fprintf(stderr, "brunt: %s did not run to its end: %s\n", variants[v].label.c_str(),
                 study.runs[v].problem.c_str());
    if (v == 0) return kPhysicsBroke;
  }
  RunSummary summary = study.runs[0].summary;
  add_bounds(variants, study, summary);
  write_summary(arguments.out, summary);
  if (arguments.json) std::printf("%s\n", to_json(summary).c_str());
  if (arguments.quiet) return kDone;
  print_bounds(summary);
  std::fprintf(stderr,
               "bounds of what the sizes of elements and particles do, no other error; %s\n",
               arguments.out.c_str());
  return kDone;
}

}  // namespace brunt
// Tested by tests/cli/refine.sh.
