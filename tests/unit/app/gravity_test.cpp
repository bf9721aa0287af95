// Gravity over time: a table that bends at 0, 10 and 30 ms, and sin, whose largest value within 20
// ms is at 15 ms, 3/4 of the run. With time.process_speed = 4 the same happens in a quarter of the
// time.
#include "app/deck/gravity.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "app/deck/deck.hpp"
#include "app/setup/bonds.hpp"

namespace brunt::deck {
namespace {

Deck with(const std::string& gravity, const std::string& more = "") {
  return load_deck_text("time: {end: 20 ms" + more + "}\ngravity: " + gravity + R"(
materials: {steel: {density: 7850, elastic: {E: 200 GPa, nu: 0.3}}}
bodies:
  bar: {material: steel, shape: {box: {min: [0, 0, 0], max: [4 mm, 1 mm, 1 mm]}}, size: 1 mm}
)",
                        "gravity.yaml")
      .deck;
}

const std::string kGrows =
    "[0, 1 m/s^2, {table: [[0, 0], [10 ms, -8 m/s^2], [30 ms, -4 m/s^2]], over: time}]";

TEST(Gravity, IsATableOverTime) {
  const Deck deck = with(kGrows);
  EXPECT_TRUE(deck.has_gravity());
  EXPECT_TRUE(is_over_time(deck.gravity));
  EXPECT_EQ(gravity_at(deck.gravity, 0), (std::array<Real, 3>{0, 1, 0}));
  EXPECT_NEAR(gravity_at(deck.gravity, 5e-3)[2], -4, 1e-12);
  EXPECT_NEAR(gravity_at(deck.gravity, 20e-3)[2], -6, 1e-12);
  EXPECT_EQ(largest_gravity(deck.gravity, deck.time.end), (std::vector<Real>{0, 1, -8}));
}

TEST(Gravity, IsAnExpressionOfTime) {
  const Deck deck = with("[0, 0, \"= -2*t + 5*sin(2*pi*t/0.02)\"]");
  EXPECT_NEAR(gravity_at(deck.gravity, 5e-3)[2], 5 - 0.01, 1e-12);
  const auto largest = largest_gravity(deck.gravity, deck.time.end);
  EXPECT_NEAR(largest[2], -5 - 2 * 0.015, 1e-12);  // one of 257 moments is 15 ms
  EXPECT_EQ(contact_options(deck).gravity, largest);
}

TEST(Gravity, IsAConstantOrNone) {
  const Deck deck = with("[0, 0, -9.81 m/s^2]");
  EXPECT_FALSE(is_over_time(deck.gravity));
  EXPECT_EQ(largest_gravity(deck.gravity, deck.time.end), (std::vector<Real>{0, 0, -9.81}));
  EXPECT_FALSE(with("[0, 0, 0]").has_gravity());
  EXPECT_FALSE(pulls(std::nullopt));
  EXPECT_EQ(gravity_at(std::nullopt, 1), (std::array<Real, 3>{}));
}

TEST(Gravity, ComesSoonerWhereTheProcessIsFaster) {
  for (const std::string& gravity : {kGrows, std::string("[0, 0, \"= -9*sin(100*t)\"]")}) {
    const Deck real = with(gravity), fast = with(gravity, ", process_speed: 4");
    for (const Real time : {0.0, 3e-3, 12e-3, 20e-3}) {
      EXPECT_EQ(gravity_at(fast.gravity, time / 4), gravity_at(real.gravity, time)) << time;
    }
  }
}

}  // namespace
}  // namespace brunt::deck
