// What a restart may change and what not: only the end, the stop, the title and the output.
#include "app/deck/difference.hpp"

#include <gtest/gtest.h>

#include "app/deck/deck.hpp"
#include "tests/support/source_path.hpp"

namespace brunt {
namespace {

std::string resolved(const std::vector<std::string>& overrides) {
  return load_deck(test::source_path("decks/bars/bars.yaml"), overrides).resolved;
}

TEST(DeckDifference, EndStopTitleAndOutputMayDiffer) {
  const auto deck = resolved({});
  for (const char* change : {"time.end=1 s", "time.until=2 us", "output.every=3 us", "title=other",
                             "output.history=3 us", "output.checkpoint=off",
                             "output.checkpoint_steps=7", "output.fields=[stress]"}) {
    EXPECT_TRUE(deck_differences(deck, resolved({change})).empty()) << change;
  }
}

TEST(DeckDifference, AllElseIsNamedWithBothValues) {
  const auto deck = resolved({});
  const auto safety = deck_differences(deck, resolved({"time.safety=0.5"}));
  ASSERT_EQ(safety.size(), 1u);
  EXPECT_EQ(safety[0].find("time.safety: "), 0u) << safety[0];
  EXPECT_NE(safety[0].find("0.5 in the deck"), std::string::npos) << safety[0];
  const auto step = deck_differences(deck, resolved({"time.max_step=1 ns"}));
  ASSERT_EQ(step.size(), 1u);
  EXPECT_EQ(step[0].find("time.max_step: nothing in the checkpoint"), 0u) << step[0];
  const auto gravity = deck_differences(deck, resolved({"gravity=[0, 0, -9.81 m/s^2]"}));
  EXPECT_FALSE(gravity.empty());
}

}  // namespace
}  // namespace brunt
