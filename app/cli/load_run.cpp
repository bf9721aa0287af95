// Tested by tests/cli/run.sh.
#include "app/cli/load_run.hpp"

#include <cstdio>

#include "app/deck/findings.hpp"
#include "app/setup/sound_part.hpp"

namespace brunt {

LoadedDeck load_run(const RunArguments& arguments, bool print) {
  auto overrides = arguments.overrides;
  if (arguments.until) overrides.push_back("time.until=" + *arguments.until);
  LoadedDeck loaded = load_or_tell_all(arguments.deck, overrides, print);
  const auto& time = loaded.deck.time;
  if (!arguments.until || *time.until <= time.end) return loaded;
  // Of a run in parts the last part may be shorter; else a unit was left out.
  loaded.warnings.push_back(
      {{"--until", 0, 0},
       "time.until",
       deck::time_text(time.real(*time.until)) + " is after the end of the run, " +
           deck::time_text(time.real(time.end)) + " (time.end): it stops nothing"});
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
