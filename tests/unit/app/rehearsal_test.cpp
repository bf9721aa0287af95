// Rehearsals: what coarser runs lead to expect of the steps.
#include "app/cli/rehearsal.hpp"

#include <gtest/gtest.h>

#include "tests/support/source_path.hpp"

namespace brunt {
namespace {

// What first steps of some scene might have cost.
const Calibration kMeasured{.steps = 10, .seconds_per_step = 1e-3, .reached = 1e-6, .points = 100};

TEST(Rehearsals, ExpectTheGrowthOfTheFinestAndHalfOfItsLead) {
  EXPECT_EQ(expected_growth({}), 1);
  EXPECT_EQ(expected_growth({{3, 8}}), 8);
  EXPECT_EQ(expected_growth({{3, 8}, {2, 12}}), 14);
  EXPECT_EQ(expected_growth({{3, 12}, {2, 8}}), 8);           // no trend to go on with
  EXPECT_EQ(expected_growth({{3, 2}, {2, 4}, {1.5, 6}}), 6);  // a third, where there is one
}

// A bar of eight elements across that strikes a wall: with four, and with three, the foot flattens
// less. 25,962 steps are taken at the deck's own size where the first promises 1,503: 17.3 times.
// A run of 1,000 s is thought of, so that there is time for both on any machine.
TEST(Rehearsals, OfATaylorBarForetellItsStepsToAQuarter) {
  const std::string deck =
      test::source_path("decks/taylor-bar-axisymmetric/taylor-bar-axisymmetric.yaml");
  const auto rehearsals = rehearse(deck, {}, load_deck(deck, {}), kMeasured, 1000);
  ASSERT_EQ(rehearsals.size(), 2U);
  EXPECT_GT(rehearsals[1].growth, rehearsals[0].growth);
  EXPECT_NEAR(expected_growth(rehearsals), 17.3, 0.25 * 17.3);
}

// Two elements across are one with twice the size, and one with three times: no bar that flattens.
TEST(Rehearsals, LeaveOutWhatCannotBeMadeCoarser) {
  const std::string deck =
      test::source_path("decks/taylor-bar-axisymmetric/taylor-bar-axisymmetric.yaml");
  const std::vector<std::string> single{"bodies.bar.cells=[2, 20]"};
  EXPECT_TRUE(rehearse(deck, single, load_deck(deck, single), kMeasured, 1000).empty());
}

// A run that would take a second is tried itself (to its very steps: tests/cli/plan.sh). Elements
// of a third of the size flatten more, to 17.3 times the steps.
TEST(Rehearsals, AShortRunIsTriedItself) {
  const std::string deck =
      test::source_path("decks/taylor-bar-axisymmetric/taylor-bar-axisymmetric.yaml");
  const std::vector<std::string> coarse{"bodies.bar.cells=[3, 16]"};
  const auto rehearsals = rehearse(deck, coarse, load_deck(deck, coarse), kMeasured, 1);
  ASSERT_EQ(rehearsals.size(), 1U);
  EXPECT_EQ(rehearsals[0].factor, 1);
  EXPECT_GT(rehearsals[0].growth, 2);
  EXPECT_LT(rehearsals[0].growth, 17.3);
  EXPECT_EQ(rehearsals[0].share, 1);
}

// Balls that are pressed together are at rest after a third of the time that the deck allows: these
// at 0.372 of it. They are coarse, for a rehearsal of a short run has 20 s of the processor, and
// a build with sanitizers takes thirty times as long.
TEST(Rehearsals, SeeWhereStopEndsARun) {
  const std::string deck = test::source_path("decks/hertz/pressed.yaml");
  const std::vector<std::string> coarse{"parameters.cells=4"};
  const auto rehearsals = rehearse(deck, coarse, load_deck(deck, coarse), kMeasured, 1);
  ASSERT_EQ(rehearsals.size(), 1U);
  EXPECT_NEAR(rehearsals[0].share, 0.372, 0.03);
  EXPECT_NEAR(expected_share(rehearsals), 0.372, 0.03);
}

// Coarse cylinders slide off each other where finer ones come to rest (decision 203): if none of
// two sizes stops, a third is tried. Here none does, for the deck ends too early; or all do.
TEST(Rehearsals, LookCloserWhereNoneStops) {
  const std::string deck = test::source_path("decks/hertz/cylinders.yaml");
  const std::vector<std::string> early{"time.end=2 us"};
  EXPECT_EQ(rehearse(deck, early, load_deck(deck, early), kMeasured, 1000).size(), 3U);
  const std::vector<std::string> halved{"time.end=2 us", "stop={when: '= time > 1e-6'}"};
  const auto stopped = rehearse(deck, halved, load_deck(deck, halved), kMeasured, 1000);
  ASSERT_EQ(stopped.size(), 2U);
  EXPECT_NEAR(stopped[1].share, 0.5, 0.01);
}

}  // namespace
}  // namespace brunt
