/// From files to a Deck: sources, library, overrides, parameters, reader, checks.
#include <algorithm>
#include <cctype>
#include <cstdint>
#include <set>
#include <tuple>

#include "app/deck/checks.hpp"
#include "app/deck/deck.hpp"
#include "app/deck/library.hpp"
#include "app/deck/loader.hpp"
#include "app/deck/process_speed.hpp"
#include "app/deck/quality.hpp"
#include "io/deck/echo.hpp"
#include "io/deck/parameters.hpp"
#include "io/deck/reader.hpp"
#include "io/deck/sources.hpp"

namespace brunt {

namespace {

/// FNV-1a of a text, as 16 hex digits (Fowler, Noll & Vo 1991).
std::string hash_of(const std::string& text) {
  std::uint64_t hash = 14695981039346656037ull;
  for (const char c : text) {
    hash ^= static_cast<unsigned char>(c);
    hash *= 1099511628211ull;
  }
  std::string digits;
  for (int shift = 60; shift >= 0; shift -= 4) digits += "0123456789abcdef"[(hash >> shift) & 15];
  return digits;
}

/// measures.NAME.expression: its dollars are measures, or parameters.
bool is_formula(const std::string& path) {
  return path.starts_with("measures.") && path.ends_with(".expression") &&
         std::count(path.begin(), path.end(), '.') == 2;
}

std::set<std::string> names_of_measures(const Node& root) {
  std::set<std::string> names;
  const Node* measures = root.find("measures");
  if (measures == nullptr) return names;
  for (const Entry& entry : measures->entries) names.insert(entry.key);
  return names;
}

bool sets_library(const Override& change) {
  return change.path.size() == 3 && change.path[0] == "materials" && change.path[2] == "library";
}

/// The geometry decides on numbers of components, so it is read before all else; without it
/// nothing can be said of the rest.
Geometry geometry_of(const Node& root) {
  static const std::vector<std::string> kWords{"3d", "plane-strain", "axisymmetric"};
  const Node* node = root.find("geometry");
  if (!node) return Geometry::three_d;
  const auto found = std::find(kWords.begin(), kWords.end(), node->text);
  if (found == kWords.end()) {
    refuse_deck(node->place, "geometry",
                "expects 3d, plane-strain or axisymmetric, got " + what_stands(*node) +
                    "; the rest of the deck is looked at once this is known");
  }
  return static_cast<Geometry>(found - kWords.begin());
}

/// Puts library values under the materials that name one; says which are of low confidence.
void use_library(Node& root, const Node& library, std::vector<DeckProblem>& problems,
                 std::vector<DeckProblem>& warnings) {
  Node* materials = root.find("materials");
  if (!materials || !materials->is_map()) return;
  for (const Entry& material : materials->entries) {
    const Node* name = material.value.is_map() ? material.value.find("library") : nullptr;
    const Node* entry = name && name->is_scalar() ? library.find(name->text) : nullptr;
    const Node* low = entry ? entry->find("low_confidence") : nullptr;
    if (!low) continue;
    warnings.push_back({name->place, "materials." + material.key + ".library",
                        "values of low confidence in '" + name->text + "': " + low->text});
  }
  expand_library(*materials, "materials", library, {"elastic", "strength", "eos"}, problems);
}

/// What is reported of a parameter is not reported again where it is used: one that is wrong
/// itself, beyond the first `n_reported` problems; one that is no number, or does not fit in the
/// same way, but once.
void drop_consequences(const std::vector<Parameter>& parameters, std::size_t n_reported,
                       std::vector<DeckProblem>& problems) {
  std::map<std::string, std::vector<const Parameter*>> used_at;
  for (const Parameter& parameter : parameters) {
    for (const SourcePlace& place : parameter.used_at) {
      used_at[place.text()].push_back(&parameter);
    }
  }
  const auto first = problems.begin() + static_cast<std::ptrdiff_t>(n_reported);
  std::set<std::pair<const Parameter*, std::string>> seen;
  const auto repeats = [&](const DeckProblem& problem) {
    const auto used = used_at.find(problem.place.text());
    if (used == used_at.end()) return false;
    return std::any_of(used->second.begin(), used->second.end(), [&](const Parameter* parameter) {
      // "expects a length (m), got '-$size = 2 kg'": the value is written as it was used.
      const std::string& reported = problem.message;
      const std::size_t value = reported.find(", got '"), end = reported.rfind('\'');
      const std::string what = value < end ? reported.substr(0, value) + reported.substr(end)
                                           : reported.substr(0, value);
      return parameter->failed || !seen.emplace(parameter, parameter->value ? what : "").second;
    });
  };
  std::vector<DeckProblem> kept(problems.begin(), first);
  std::copy_if(first, problems.end(), std::back_inserter(kept),
               [&](const DeckProblem& problem) { return !repeats(problem); });
  problems = std::move(kept);
}

/// Names that stand behind a dollar somewhere below a node.
void collect_names(const Node& node, std::set<std::string>& names) {
  for (const Node& item : node.items) collect_names(item, names);
  for (const Entry& entry : node.entries) collect_names(entry.value, names);
  if (!node.is_scalar()) return;
  const auto in_name = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
  };
  for (auto at = node.text.find('$'); at != std::string::npos; at = node.text.find('$', at + 1)) {
    std::size_t end = at + 1;
    while (end < node.text.size() && in_name(node.text[end])) ++end;
    names.insert(node.text.substr(at + 1, end - at - 1));
  }
}

/// A parameter that the deck uses where an override stands now may be left without use.
void forgive_unused(const std::set<std::string>& used_before, std::size_t first,
                    std::vector<DeckProblem>& problems) {
  const auto forgiven = [&](const DeckProblem& problem) {
    constexpr std::string_view kParameters = "parameters.";
    return problem.path.starts_with(kParameters) && problem.message.starts_with("is not used") &&
           used_before.contains(problem.path.substr(kParameters.size()));
  };
  problems.erase(std::remove_if(problems.begin() + static_cast<std::ptrdiff_t>(first),
                                problems.end(), forgiven),
                 problems.end());
}

}  // namespace

namespace deck {

DeckLoader::DeckLoader() : library_(library()) {}

LoadedDeck DeckLoader::read(Node root, const std::vector<std::string>& override_texts,
                            std::vector<DeckProblem>& problems) const {
  LoadedDeck loaded;
  const std::vector<Override> overrides = read_overrides(override_texts, problems);
  std::set<std::string> used_before;
  if (!overrides.empty()) collect_names(root, used_before);
  for (const Override& change : overrides) {
    if (sets_library(change)) apply_override(root, change, problems);
  }
  use_library(root, library_, problems, loaded.warnings);
  for (const Override& change : overrides) {
    if (!sets_library(change)) apply_override(root, change, problems);
  }
  const bool declares = root.find("parameters") != nullptr;
  const std::size_t n_before = problems.size();
  const std::set<std::string> measures = names_of_measures(root);
  const auto own = [&](const std::string& path) { return is_formula(path) ? &measures : nullptr; };
  const std::vector<Parameter> parameters = resolve_parameters(root, units_, own, problems);
  forgive_unused(used_before, n_before, problems);
  const ParameterValues values = values_of(parameters);
  std::size_t n_reported = problems.size();
  ReadReport report;
  Reader reader(root, geometry_of(root), units_, values, report);
  loaded.deck = deck_of(quality_of(root));
  describe(reader, loaded.deck);
  reader.finish({"include", "parameters"});
  // An unknown section may be that of the parameters.
  const auto& read = report.problems;
  const bool section_unknown = std::any_of(
      read.begin(), read.end(), [](const DeckProblem& problem) { return problem.path.empty(); });
  if (!declares && section_unknown) n_reported = n_before;
  loaded.places.set("", root.place);
  for (const auto& [path, place] : report.places) loaded.places.set(path, place);
  problems.insert(problems.end(), report.problems.begin(), report.problems.end());
  loaded.warnings.insert(loaded.warnings.end(), report.warnings.begin(), report.warnings.end());
  Findings findings(loaded.places, problems, loaded.warnings);
  check_deck(loaded.deck, findings);
  loaded.wrong = findings.reported_elsewhere();
  for (const DeckProblem& problem : problems) loaded.wrong.push_back(problem.path);
  drop_consequences(parameters, n_reported, problems);
  sort_problems(problems);
  sort_problems(loaded.warnings);
  for (const Parameter& parameter : parameters) {
    if (!parameter.declared) continue;
    DeckParameter shown{parameter.name, parameter.text, 0, ""};
    if (parameter.value) {
      shown.value = parameter.value->value;
      shown.unit = parameter.value->dimension.unit();
    }
    loaded.parameters.push_back(shown);
  }
  loaded.overrides = override_texts;
  if (problems.empty()) {  // half a deck has no echo
    loaded.resolved = echo(loaded.deck);
    loaded.hash = hash_of(loaded.resolved);
  }
  loaded.deck = stepped_deck(loaded.deck);
  return loaded;
}

LoadedDeck DeckLoader::load(Node root, const std::vector<std::string>& overrides) const {
  std::vector<DeckProblem> problems;
  LoadedDeck loaded = read(std::move(root), overrides, problems);
  if (!problems.empty()) throw DeckError(problems);
  return loaded;
}

LoadedDeck DeckLoader::load_text(const std::string& text, const std::string& name,
                                 const std::vector<std::string>& overrides) const {
  return load(read_deck_source(text, name), overrides);
}

}  // namespace deck

void sort_problems(std::vector<DeckProblem>& problems) {
  std::set<std::tuple<std::string, std::string>> seen;
  std::erase_if(problems, [&](const DeckProblem& problem) {
    return !seen.emplace(problem.place.text(), problem.path).second;
  });
  std::stable_sort(problems.begin(), problems.end(),
                   [](const DeckProblem& a, const DeckProblem& b) {
                     return std::tie(a.place.file, a.place.line, a.place.column) <
                            std::tie(b.place.file, b.place.line, b.place.column);
                   });
}

LoadedDeck read_deck(const std::string& path, const std::vector<std::string>& overrides,
                     std::vector<DeckProblem>& problems) {
  return deck::DeckLoader().read(read_deck_file(path), overrides, problems);
}

LoadedDeck load_deck(const std::string& path, const std::vector<std::string>& overrides) {
  return deck::DeckLoader().load(read_deck_file(path), overrides);
}

LoadedDeck load_deck_text(const std::string& text, const std::string& name,
                          const std::vector<std::string>& overrides) {
  return deck::DeckLoader().load_text(text, name, overrides);
}

std::string echo(const Deck& deck) {
  Deck copy = deck;
  Echo writer(deck.geometry);
  describe(writer, copy);
  return to_yaml(writer.root());
}

}  // namespace brunt
