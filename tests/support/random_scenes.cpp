// random_scenes impact|deck|newer FIRST [LAST [KEY=VALUE...]]: what random impacts and decks of
// seeds come to, a line each, with overrides as those of --set; of one seed with --print, its deck.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include "core/errors.hpp"
#include "tests/support/random_deck.hpp"
#include "tests/support/random_impacts.hpp"
#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

void throw_pair(std::uint64_t seed, const std::vector<std::string>& overrides) {
  const Impact impact = random_impact(seed);
  const Outcome outcome = outcome_of(impact, overrides);
  const bool reported = outcome.lost > 0 || !outcome.failure.empty() || outcome.created > 0.05;
  const bool wrong = (outcome.crossed && !reported) || outcome.pairs > 0.01 ||
                     outcome.created > 0.01 || !outcome.failure.empty();
  std::printf("%s seed %llu: %s: contact.pairs %.3g, created %.3g, lost %zu, steps %lld%s %s\n",
              wrong ? "WRONG" : "ok", static_cast<unsigned long long>(seed), impact.what.c_str(),
              outcome.pairs, outcome.created, outcome.lost, static_cast<long long>(outcome.steps),
              outcome.crossed ? ", crossed" : "", outcome.failure.c_str());
}

void run_deck(std::uint64_t seed, bool newer, const std::vector<std::string>& overrides) {
  const auto number = static_cast<unsigned long long>(seed);
  try {
    const Simulation run = simulate_text(random_deck(seed, newer), overrides, {.threads = 1});
    bool numbers = true;
    for (const auto& row : run.rows) {
      for (const Real value : row) numbers = numbers && std::isfinite(value);
    }
    const bool wrong = (run.failure.empty() && run.created > 0.05) || !numbers;
    std::printf("%s seed %llu: %lld steps, created %.3g, lost %zu %s%s\n",
                wrong                 ? "WRONG"
                : run.failure.empty() ? "ok"
                                      : "broke",
                number, static_cast<long long>(run.steps), run.created, run.lost.size(),
                numbers ? "" : "NO NUMBER ", run.failure.c_str());
  } catch (const DeckError& error) {
    for (const auto& problem : error.problems()) {
      std::printf("refused seed %llu: %s\n", number, problem.text().c_str());
    }
  } catch (const std::exception& error) {
    std::printf("WRONG seed %llu: %s\n", number, error.what());
  }
}

}  // namespace
}  // namespace brunt::test

int main(int argc, char** argv) {
  using namespace brunt::test;
  if (argc < 3) return 2;
  const bool impact = std::strcmp(argv[1], "impact") == 0;
  const bool newer = std::strcmp(argv[1], "newer") == 0;
  const std::uint64_t first = std::stoull(argv[2]);
  if (argc > 3 && std::strcmp(argv[3], "--print") == 0) {
    std::fputs((impact ? random_impact(first).text : random_deck(first, newer)).c_str(), stdout);
    return 0;
  }
  const std::uint64_t last = argc > 3 ? std::stoull(argv[3]) : first;
  const std::vector<std::string> overrides(argv + std::min(argc, 4), argv + argc);
  for (auto seed = first; seed <= last; ++seed) {
    impact ? throw_pair(seed, overrides) : run_deck(seed, newer, overrides);
    std::fflush(stdout);
  }
}
