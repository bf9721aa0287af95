// A bolt that is pushed through a hole narrower than itself goes through no face: its sides press
// on those of the hole, 0.2 mm in, and hold it there. Behind it the faces of its base and of the
// plate's far side lie over each other by these 0.2 mm, from farther apart than an element is deep,
// where faces let go, until the bolt has left. They came in over the borders of both, the force of
// that overlap has faded to next to nothing (contact/geometry/overlap_push.hpp), and so they are
// none that came back.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/simulate.hpp"
#include "tests/support/source_path.hpp"

namespace brunt::test {
namespace {

const std::string kShortBolt = R"(
title: a rigid bolt with an ogive nose is pushed through a hole that is too narrow
geometry: 3d
time: {end: 0.6 ms}
materials:
  alu: {density: 2780 kg/m^3, elastic: {E: 73 GPa, nu: 0.33}}
bodies:
  bolt:
    rigid: true
    shape:
      ogive: {radius: 4.2 mm, length: 10 mm, nose: 8 mm, base: [0, 0, 10.5 mm], axis: [0, 0, -1]}
    size: 1 mm
    motion: {velocity: [0, 0, -20 m/s]}
  plate:
    material: alu
    shape: {tube: {inner: 4 mm, outer: 8 mm, length: 2 mm, base: [0, 0, -2 mm], axis: z}}
    size: 1 mm
contact:
  pairs: {hole: {between: [bolt, plate], friction: 0.15}}
boundaries:
  ring:
    body: plate
    where: {box: {min: [-9 mm, -9 mm, -2.5 mm], max: [9 mm, 9 mm, -1.5 mm]}}
    fix: [z]
output: {history: 2 us}
)";

void expect_no_lost_contact(const Simulation& run) {
  ASSERT_EQ(run.failure, "");
  EXPECT_TRUE(run.lost.empty());
  for (const auto& warning : run.warnings) {
    EXPECT_EQ(warning.find("came back"), std::string::npos) << warning;
  }
}

/// How far a column moves from one row to the next, at most, from a time on.
Real largest_step(const Simulation& run, const std::string& name, Real from) {
  const auto values = run.column(name), time = run.column("time");
  Real largest = 0;
  for (std::size_t i = 1; i < values.size(); ++i) {
    if (time[i] > from) largest = std::max(largest, std::fabs(values[i] - values[i - 1]));
  }
  return largest;
}

TEST(CameBack, SidesOfABoltInAHoleDidNot) {
  expect_no_lost_contact(simulate_text(kShortBolt, {}, {.threads = 1}));
}

// The deck's own criterion: as it leaves, from 1.1 ms on, its axial force falls by less than 5 % of
// the 11 kN that pushed its nose in from row to row, and contact.pairs moves by some 0.01 J.
TEST(CameBack, LongSidesOfTheBoltOfTheDeckDidNot) {
  const auto run =
      simulate(load_deck(source_path("tests/cases/bolt-hole.yaml"), {}), {.threads = 1});
  expect_no_lost_contact(run);
  EXPECT_LT(largest_step(run, "contact.hole.force.z", 1.1e-3), 0.05 * 11e3);
  EXPECT_LT(largest_step(run, "energy.contact.pairs", 1.1e-3), 0.015);
}

}  // namespace
}  // namespace brunt::test
