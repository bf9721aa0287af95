// What holds around the checks of a deck; the wrong decks themselves stand in tests/wrong.
#include "app/deck/checks.hpp"

#include <gtest/gtest.h>

#include "app/deck/loader.hpp"
#include "app/loop/time_loop.hpp"
#include "app/setup/scene_builder.hpp"
#include "app/setup/sound_part.hpp"
#include "app/watch/history_columns.hpp"

namespace brunt {
namespace {

const std::string kHead = R"yaml(
time: {end: 10 us}
materials:
  steel: {density: 7850, elastic: {E: 200 GPa, nu: 0.3}}
)yaml";

std::string box(const std::string& name, const std::string& from, const std::string& to) {
  return "  " + name + ": {material: steel, cells: [4, 2, 2], shape: {box: {min: [" + from +
         ", 0, 0], max: [" + to + ", 2 mm, 2 mm]}}}\n";
}

std::string problems_of_build(const std::string& text) {
  try {
    build_scene<3>(load_deck_text(text, "deck"));
  } catch (const DeckError& error) {
    return error.what();
  }
  return "";
}

TEST(Findings, NumbersForMessages) {
  EXPECT_EQ(deck::length_text(2.5e-3), "2.5 mm");
  EXPECT_EQ(deck::length_text(1), "1 m");
  EXPECT_EQ(deck::length_text(-0.25e-6), "-250 nm");
  EXPECT_EQ(deck::time_text(1e-5), "10 us");
  EXPECT_EQ(deck::time_text(0), "0 s");
}

TEST(Findings, AKeyIsUnsoundWithWhatIsAboveAndBelowIt) {
  std::vector<DeckProblem> problems{{{}, "bodies.bar.shape", "wrong"}}, warnings;
  const DeckPlaces places;
  const deck::Findings findings(places, problems, warnings);
  EXPECT_FALSE(findings.sound("bodies.bar.shape.box"));
  EXPECT_FALSE(findings.sound("bodies.bar"));
  EXPECT_TRUE(findings.sound("bodies.bar2"));
  EXPECT_TRUE(findings.sound("bodies.bar.size"));
}

TEST(Overlaps, TouchingIsNoOverlapAndDepthIsTold) {
  const std::string first = kHead + "bodies:\n" + box("a", "0", "4 mm");
  EXPECT_EQ(problems_of_build(first + box("b", "4 mm", "8 mm")), "");
  // Elements have edges of 1 mm: 0.4 mm is less than half of one.
  EXPECT_EQ(problems_of_build(first + box("b", "3.6 mm", "7.6 mm")), "");
  const std::string reported = problems_of_build(first + box("b", "3 mm", "7 mm"));
  EXPECT_NE(reported.find("bodies.b.shape: is inside 'a' by 1 mm at time 0"), std::string::npos)
      << reported;
  EXPECT_NE(reported.find("moving 'b' by 1 mm along x parts them"), std::string::npos) << reported;
}

TEST(Overlaps, BodiesThatIgnoreEachOtherMayOverlap) {
  const std::string both = kHead + "bodies:\n" + box("a", "0", "4 mm") + box("b", "3 mm", "7 mm");
  EXPECT_NE(problems_of_build(both), "");
  EXPECT_EQ(problems_of_build(both + "contact: {default: {ignore: true}}\n"), "");
  EXPECT_EQ(problems_of_build(both + "contact: {pairs: {p: {between: [b, a], ignore: true}}}\n"),
            "");
  EXPECT_EQ(problems_of_build(both + "contact: {pairs: {p: {between: [b, any], ignore: true}}}\n"),
            "");
}

TEST(SoundPart, LeavesOutWhatIsWrongAndWhatNamesIt) {
  const LoadedDeck whole = load_deck_text(
      kHead + "bodies:\n" + box("a", "0", "4 mm") + box("b", "5 mm", "9 mm") +
          "boundaries: {left: {body: a, where: all, fix: [x]}, right: {body: b, where: all, fix: "
          "[x]}}\nmeasures: {l: {extent: {body: a, axis: x}}, v: {history: {column: "
          "body.b.velocity.x}}}\n",
      "deck");
  const Deck part = sound_part(whole, {"bodies.a.size"}).deck;
  ASSERT_EQ(part.bodies.size(), 1u);
  EXPECT_EQ(part.bodies[0].name, "b");
  ASSERT_EQ(part.boundaries.size(), 1u);
  EXPECT_EQ(part.boundaries[0].name, "right");
  EXPECT_TRUE(sound_part(whole, {"materials.steel.density"}).deck.bodies.empty());
}

TEST(Drift, ABodyAtRestDoesNotDriftByItsEnergyOfRounding) {
  const LoadedDeck loaded = load_deck_text(kHead + "bodies:\n" + box("a", "0", "4 mm"), "deck");
  auto scene = build_scene<3>(loaded);
  struct Watch final : Observer<3> {
    std::unique_ptr<HistoryColumns<3>> columns;
    Real worst = 0;
    void begin(Scene<3>& scene, Clock& clock) override {
      columns = std::make_unique<HistoryColumns<3>>(scene);
      columns->collect(scene, clock, true, false);
    }
    void step_done(Scene<3>& scene, Clock& clock) override {
      worst = std::max(worst, std::fabs(columns->collect(scene, clock, true, false).drift));
    }
  } watch;
  Clock clock(10e-6, 0.9, kInfinity);
  run_time_loop(*scene, clock, watch);
  EXPECT_GT(clock.step(), 10);
  EXPECT_LT(watch.worst, 1e-3);
}

}  // namespace
}  // namespace brunt
