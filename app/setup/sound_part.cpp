#include "app/setup/sound_part.hpp"

#include <algorithm>
#include <cstdio>
#include <set>

#include "app/deck/findings.hpp"
#include "app/setup/scene_builder.hpp"

namespace brunt {

namespace {
bool is_wrong(const std::string& path, const std::vector<std::string>& wrong) {
  return std::any_of(wrong.begin(), wrong.end(), [&](const std::string& key) {
    return !key.empty() && deck::related(key, path);
  });
}

template <class T, class Test>
void keep(std::vector<Named<T>>& entries, Test test) {
  std::erase_if(entries, [&](const Named<T>& entry) { return !test(entry); });
}

}  // namespace

LoadedDeck sound_part(const LoadedDeck& loaded, const std::vector<std::string>& wrong) {
  LoadedDeck part = loaded;
  Deck& deck = part.deck;
  std::set<std::string> materials, kept;
  for (const auto& material : deck.materials) {
    if (!is_wrong("materials." + material.name, wrong)) materials.insert(material.name);
  }
  keep(deck.bodies, [&](const auto& body) {
    const bool needs_none = body.value.rigid && body.value.material.empty();
    const bool made = needs_none || materials.contains(body.value.material);
    const bool sound = made && !is_wrong("bodies." + body.name, wrong);
    if (sound) kept.insert(body.name);
    return sound;
  });
  keep(deck.materials, [&](const auto& material) { return materials.contains(material.name); });
  keep(deck.contact.pairs, [&](const auto& pair) {
    const auto known = [&](const std::string& body) {
      return body == "any" || kept.contains(body);
    };
    return !is_wrong("contact", wrong) && pair.value.between.size() == 2 &&
           pair.value.between[0] != "any" && known(pair.value.between[0]) &&
           known(pair.value.between[1]);
  });
  keep(deck.boundaries, [&](const auto& boundary) {
    return kept.contains(boundary.value.body) && !is_wrong("boundaries." + boundary.name, wrong);
  });
  keep(deck.measures,
       [&](const auto& measure) { return !is_wrong("measures." + measure.name, wrong); });
  keep(deck.probes, [&](const auto& probe) {
    return kept.contains(body_of_part(probe.value.body)) &&
           !is_wrong("probes." + probe.name, wrong);
  });
  keep(deck.sections, [&](const auto& section) {
    return kept.contains(section.value.body) && !is_wrong("sections." + section.name, wrong);
  });
  if (is_wrong("gravity", wrong)) deck.gravity.reset();
  deck.damping.reset();
  return part;
}

void add_build_problems(const LoadedDeck& loaded, std::vector<DeckProblem>& problems) {
  std::vector<std::string> wrong = loaded.wrong;
  for (const auto& problem : problems) wrong.push_back(problem.path);
  if (is_wrong("geometry", wrong) || is_wrong("depth", wrong)) return;
  LoadedDeck part = sound_part(loaded, wrong);
  if (part.deck.bodies.empty()) return;
  part.wrong = std::move(wrong);
  try {
    if (part.deck.geometry == Geometry::three_d) {
      build_scene<3>(part);
    } else {
      build_scene<2>(part);
    }
  } catch (const DeckError& error) {
    const auto& more = error.problems();
    problems.insert(problems.end(), more.begin(), more.end());
  }
}

LoadedDeck load_or_tell_all(const std::string& path, const std::vector<std::string>& overrides,
                            bool print_warnings) {
  std::vector<DeckProblem> problems;
  LoadedDeck loaded = read_deck(path, overrides, problems);
  for (const auto& warning : loaded.warnings) {
    if (print_warnings) std::fprintf(stderr, "warning: %s\n", warning.text().c_str());
  }
  if (problems.empty()) return loaded;
  add_build_problems(loaded, problems);
  sort_problems(problems);
  throw DeckError(problems);
}

}  // namespace brunt
