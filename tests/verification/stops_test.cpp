// What ends a run. A stone that is thrown up at v0 turns at t = v0/g, and has come down by h under
// where it began at t = (v0 + sqrt(v0^2 + 2 g h))/g. Conditions over columns are looked at with
// every row: they hold at most a row and a step later.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

constexpr Real kThrown = 2, kGravity = 10, kRow = 1e-3;  // m/s, m/s^2, s

std::string stone(const std::string& when, const std::string& parameters = "{}") {
  return "parameters: " + parameters + R"(
title: A stone is thrown up
time: {end: 1 s}
gravity: [0, 0, -10 m/s^2]
materials:
  stone: {density: 2500 kg/m^3, elastic: {E: 1 MPa, nu: 0.2}}
bodies:
  stone-1:
    material: stone
    shape: {box: {min: [0, 0, 0], max: [1 cm, 1 cm, 1 cm]}}
    cells: [1, 1, 1]
    velocity: [0, 0, 2 m/s]
stop: {when: ")" +
         when + R"("}
output: {history: 1 ms}
)";
}

void expect_stops_at(const std::string& deck, Real expected) {
  const auto run = simulate_text(deck);
  EXPECT_EQ(run.failure, "");
  EXPECT_GE(run.last("time"), expected * (1 - 1e-12)) << deck;
  EXPECT_LE(run.last("time"), expected + kRow + run.last("dt")) << deck;
  EXPECT_NE(run.reason.find("stop.when holds"), std::string::npos) << run.reason;
  const std::int64_t middle = run.steps / 2;
  EXPECT_EQ(simulate_text(deck, {}, {.split_at = middle}).hashes, run.hashes) << deck;
}

TEST(Stops, WhenACondition) {
  expect_stops_at(stone("= body.stone-1.velocity.z < 0"), kThrown / kGravity);
  const Real down = (kThrown + std::sqrt(kThrown * kThrown + 2 * kGravity * 0.5)) / kGravity;
  expect_stops_at(stone("= body.stone-1.position.z < 0.005 - $depth", "{depth: 50 cm}"), down);
  expect_stops_at(stone("= body.stone-1.velocity.z < 0 && time > 0.35"), 0.35);
}

// The root of what is below 0 is no number: it holds no sooner than 2 m/s - 10 m/s^2 t < 1.5 m/s.
TEST(Stops, NotWhereItIsNoNumber) {
  expect_stops_at(stone("= sqrt(1.5 - body.stone-1.velocity.z)"), 0.05);
}

TEST(Stops, NotWhereItNeverHolds) {
  const auto run = simulate_text(stone("= body.stone-1.velocity.z > 2.001"));
  EXPECT_EQ(run.failure, "");
  EXPECT_EQ(run.reason, "");
  EXPECT_NEAR(run.last("time"), 1, 1e-12);
}

// A tool at 2 m/s passes 5 mm from where it begins after 2.5 ms; it has no mass to have a centre.
TEST(Stops, BeyondIsOfDrivenBodiesToo) {
  const auto result = simulate_text(R"(
time: {end: 10 ms, max_step: 10 us}
materials: {oak: {density: 700, elastic: {E: 1.5 GPa, nu: 0.3}}}
bodies:
  apart: {rigid: true, material: oak, shape: {box: {min: [1, 0, 0], max: [1.1, 0.1, 0.1]}}}
  tool: {rigid: true, shape: {box: {min: [0, 0, 0], max: [10 mm, 10 mm, 10 mm]}},
    motion: {velocity: [0, 0, -2]}}
stop: {beyond: {body: tool, axis: z, at: 0}}
)");
  ASSERT_EQ(result.failure, "");
  EXPECT_NEAR(result.last("time"), 2.5e-3, 2e-5);
  EXPECT_NEAR(result.last("body.tool.position.z"), 0, 5e-5);
}

}  // namespace
}  // namespace brunt::test
