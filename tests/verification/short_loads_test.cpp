// Loads act as they are at the ends of steps. A pulse whose time lies between two of them does
// nothing, and the run says so; one that lasts for ten steps gives its impulse to a tenth, as the
// first of its steps counts half and the last may.
#include <gtest/gtest.h>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

const std::string kDeck = R"(
title: A block that is pushed for a short time
geometry: plane-strain
time: {end: 1 ms, max_step: 10 us}
materials: {m: {density: 1000 kg/m^3, elastic: {E: 10 MPa, nu: 0}}}
bodies: {block: {material: m, shape: {box: {min: [0, 0], max: [0.1, 0.1]}}, cells: [1, 1]}}
boundaries: {push: {body: block, where: all, force: [1000 N, 0], from: 0 us, to: 5 us}}
output: {history: 0.1 ms}
)";

Simulation pushed(const std::string& from, const std::string& to) {
  return simulate_text(kDeck, {"boundaries.push.from=" + from, "boundaries.push.to=" + to});
}

TEST(ShortLoads, BetweenTwoStepsAreTold) {
  for (const auto& [from, to] : {std::pair{"0 s", "5 us"}, std::pair{"12 us", "18 us"}}) {
    const auto run = pushed(from, to);
    ASSERT_EQ(run.failure, "");
    EXPECT_EQ(run.last("body.block.velocity.x"), 0);
    ASSERT_EQ(run.reported.size(), 1U) << from;
    EXPECT_EQ(run.reported[0].id, "boundaries.push");
    EXPECT_NE(run.reported[0].text.find("from " + std::string(from) + " to " + to),
              std::string::npos)
        << run.reported[0].text;
  }
}

TEST(ShortLoads, OfManyStepsGiveTheirImpulse) {
  for (const auto& [from, to] : {std::pair{"0 us", "105 us"}, std::pair{"12 us", "117 us"}}) {
    const auto run = pushed(from, to);
    ASSERT_EQ(run.failure, "");
    EXPECT_NEAR(run.last("body.block.velocity.x"), 1000 * 105e-6 / 10, 0.1 * 1000 * 105e-6 / 10);
    EXPECT_TRUE(run.reported.empty());
  }
}

}  // namespace
}  // namespace brunt::test
