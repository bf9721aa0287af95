// Random decks end with status 0, 2 or 3, whatever is thrown at what; where one ends well, nobody
// has put in more than 5 % of its largest energy, and all that is written are numbers.
//   BRUNT_RANDOM_DECKS=FIRST:COUNT extremes --gtest_filter=RandomDecks.LongMany
// runs others than those of the label; a COUNT of 1 prints its deck.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "tests/support/random_deck.hpp"
#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

struct Tally {
  int done = 0, refused = 0, broke = 0;
};

void expect_numbers(const Simulation& run) {
  for (const auto& row : run.rows) {
    for (std::size_t c = 0; c < row.size(); ++c) {
      ASSERT_TRUE(std::isfinite(row[c])) << "column " << run.columns[c] << " at t = " << row[0];
    }
  }
  if (!run.failure.empty()) return;  // the program leaves out what is no number of a last frame
  for (const auto& [name, view] : run.bodies) {
    for (const auto* fields : {&view.point_fields, &view.cell_fields}) {
      for (const auto& field : *fields) {
        for (const Real value : field.values) {
          ASSERT_TRUE(std::isfinite(value)) << name << " " << field.name;
        }
      }
    }
  }
}

/// Runs one; what it says goes to stdout beside the seed, so that a failure can be found again.
void try_deck(std::uint64_t seed, bool newer, Tally& tally) {
  SCOPED_TRACE("seed " + std::to_string(seed));
  const std::string text = random_deck(seed, newer);
  try {
    const Simulation run = simulate_text(text, {}, {.threads = 1});
    std::printf("seed %llu: %s%lld steps, created %.2g %s\n", static_cast<unsigned long long>(seed),
                run.failure.empty() ? "" : "broke, ", static_cast<long long>(run.steps),
                run.created, run.failure.c_str());
    expect_numbers(run);
    if (!run.failure.empty()) {
      ++tally.broke;
    } else {
      ++tally.done;
      EXPECT_LT(run.created, 0.05);
    }
  } catch (const DeckError& error) {
    ++tally.refused;
    for (const auto& problem : error.problems()) {
      std::printf("seed %llu: %s\n", static_cast<unsigned long long>(seed), problem.text().c_str());
    }
  } catch (const std::exception& error) {
    ADD_FAILURE() << error.what() << "\n" << text;
  }
}

Tally try_decks(std::uint64_t first, std::uint64_t count, bool newer = false) {
  Tally tally;
  for (std::uint64_t seed = first; seed < first + count; ++seed) try_deck(seed, newer, tally);
  std::printf("%d done, %d refused, %d broke\n", tally.done, tally.refused, tally.broke);
  return tally;
}

/// The generator writes decks that are right, and fewer than one in ten asks for too much. One that
/// is not up to date would have most of its decks refused, and try nothing.
void expect_most_done(const Tally& tally) {
  const int count = tally.done + tally.refused + tally.broke;
  EXPECT_LE(20 * tally.refused, count + 20);
  EXPECT_LE(5 * tally.broke, count + 10);
}
void expect_most_tried(const Tally& tally) {
  EXPECT_LE(5 * tally.refused, tally.done + tally.refused + tally.broke + 10);
}

TEST(RandomDecks, EndWellOrSayWhy) { expect_most_done(try_decks(1, 10)); }

// With liquids, gases, explosives, concrete, damage, erosion, tetrahedra, ties, joints, symmetry
// and pressure: more of them ask for too much (explosives beside the air, say).
TEST(RandomDecks, OfNewerFeaturesEndWellOrSayWhy) { expect_most_tried(try_decks(1, 10, true)); }

TEST(RandomDecks, LongOfNewerFeatures) { expect_most_tried(try_decks(2000, 100, true)); }

TEST(RandomDecks, LongMany) {
  unsigned long long first = 1000, count = 200;
  if (const char* which = std::getenv("BRUNT_RANDOM_DECKS")) {
    ASSERT_EQ(std::sscanf(which, "%llu:%llu", &first, &count), 2) << which;
  }
  if (count == 1) std::printf("%s", random_deck(first).c_str());
  expect_most_done(try_decks(first, count));
}

}  // namespace
}  // namespace brunt::test
