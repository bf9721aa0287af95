// Tested by tests/cli/run.sh.
#include "app/cli/load_run.hpp"

#include <cstdio>
#include <utility>

#include "app/deck/findings.hpp"
#include "app/setup/sound_part.hpp"

namespace brunt {

LoadedDeck load_run(const RunArguments& arguments, bool print) {
  auto overrides = arguments.overrides;
  if (arguments.until) overrides.push_back("time.until=" + *arguments.until);
  LoadedDeck loaded = load_or_tell_all(arguments.deck, overrides, print);
  const auto& time = loaded.deck.time;
  if (!time.until || *time.until <= time.end) return loaded;
  // Of a run in parts the last part may be shorter; else a unit was left out.
  DeckProblem late = loaded.places.problem(
      "time.until", deck::time_text(time.real(*time.until)) + " is after the end of the run, " +
                        deck::time_text(time.real(time.end)) + " (time.end): it stops nothing");
  if (arguments.until) late.place = {"--until", 0, 0};
  loaded.warnings.push_back(std::move(late));
  if (print) std::fprintf(stderr, "warning: %s\n", loaded.warnings.back().text().c_str());
  return loaded;
}

DeckError as_called(const DeckError& error, const RunArguments& arguments) {
  auto problems = error.problems();
  const std::string last = "--set #" + std::to_string(arguments.overrides.size() + 1);
  for (auto& problem : problems) {
    if (problem.place.file == last) problem.place.file = "--until";
  }
  return DeckError(problems);
}

}  // namespace brunt
