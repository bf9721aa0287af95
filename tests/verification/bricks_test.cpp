// Measures of one brick of a wall, by its name.
//   Six bricks of 20 x 10 mm, two courses in stack bond with gaps of 1 mm, so that a box about a
// brick at time 0 holds that brick and no other. Brick 1.0 is struck by a bullet. Of it the name
// must give, bit for bit, what `where: {box: ...}` gives: the same points and elements, in the same
// order, whatever the ranks and over a restart. All bricks are alike in mass M, so that the
// momentum of the wall is M times the sum of their mean velocities, and its own mean velocity
// is their mean: only rounding (1e-12 of the largest) tells these apart.
//   Rigid bricks that fall freely have v = -g t each, as the wall has. No force is known before the
// first step, whose first half is without gravity: g dt / 2 < 1e-4 m/s.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

std::string wall(const std::string& body) {
  std::string text = R"(
title: A bullet strikes one brick
geometry: plane-strain
time: {end: 60 us}
materials: {stone: {density: 2400 kg/m^3, elastic: {E: 20 GPa, nu: 0.2}}}
bodies:
  wall:
    material: stone
    shape: {brick-wall: {bricks: [3, 2], brick: [20 mm, 10 mm], origin: [0, 0], course: x,
                         bond: stack, gap: 1 mm}}
)" + body + R"(
  bullet:
    material: stone
    shape: {box: {min: [28 mm, -5 mm], max: [34 mm, -0.1 mm]}}
    size: 3 mm
    velocity: [2 m/s, 30 m/s]
measures:
  named: {mean: {body: wall.1.0, field: velocity.y}}
  boxed: {mean: {body: wall, field: velocity.y,
    where: {box: {min: [20.5 mm, -0.5 mm], max: [41.5 mm, 10.5 mm]}}}}
  stress: {max: {body: wall.1.0, field: von_mises}}
  stress_boxed: {max: {body: wall, field: von_mises,
    where: {box: {min: [20.5 mm, -0.5 mm], max: [41.5 mm, 10.5 mm]}}}}
  part: {mean: {body: wall.1.0, field: displacement.y,
    where: {box: {min: [0, 0], max: [70 mm, 5.1 mm]}}}}
  part_boxed: {mean: {body: wall, field: displacement.y,
    where: {box: {min: [20.5 mm, 0], max: [41.5 mm, 5.1 mm]}}}}
  width: {extent: {body: wall.2.1, axis: x}}
  speed: {speed: {body: wall.1.0}}
  whole: {mean: {body: wall, field: velocity.y}}
)";
  for (const char* brick : {"0.0", "1.0", "2.0", "0.1", "1.1", "2.1"}) {
    text += std::string("  v") + brick[0] + brick[2] + ": {mean: {body: wall." + brick +
            ", field: velocity.y}}\n";
  }
  return text;
}

void expect_bricks(const Simulation& run) {
  ASSERT_EQ(run.failure, "");
  const auto& m = run.measures;
  EXPECT_EQ(m.at("named"), m.at("boxed"));
  EXPECT_GT(m.at("named"), 1);  // [m/s] it has been struck
  EXPECT_EQ(m.at("stress"), m.at("stress_boxed"));
  EXPECT_GT(m.at("stress"), 0);
  EXPECT_EQ(m.at("part"), m.at("part_boxed"));
  EXPECT_GE(m.at("speed"), m.at("named"));
  const Real sum =
      m.at("v00") + m.at("v10") + m.at("v20") + m.at("v01") + m.at("v11") + m.at("v21");
  EXPECT_NEAR(sum, 6 * m.at("whole"), 1e-12 * std::fabs(sum));
  EXPECT_EQ(m.at("v20"), 0);  // nothing has touched it
}

TEST(Bricks, ANamedBrickIsWhatABoxAboutItHolds) {
  const auto run = simulate_text(wall("    size: 2.5 mm"));
  expect_bricks(run);
  EXPECT_NEAR(run.measures.at("width"), 20e-3, 1e-12);
}

TEST(Bricks, OfParticlesToo) {
  const auto run = simulate_text(wall("    method: sph\n    size: 2.5 mm"));
  expect_bricks(run);
}

TEST(Bricks, AreTheSameAfterARestart) {
  const std::string deck = wall("    size: 2.5 mm");
  const auto whole = simulate_text(deck);
  RunVariation split;
  split.split_at = 20;
  const auto parts = simulate_text(deck, {}, split);
  EXPECT_LT(parts.steps_here, whole.steps);
  EXPECT_EQ(parts.measures, whole.measures);
}

TEST(Bricks, RigidOnesFallAndAProbeFollowsOne) {
  const auto run = simulate_text(R"(
title: Rigid bricks fall
geometry: 3d
time: {end: 10 ms}
materials: {stone: {density: 2400 kg/m^3, elastic: {E: 20 GPa, nu: 0.2}}}
bodies:
  wall:
    rigid: true
    material: stone
    shape: {brick-wall: {bricks: [2, 1, 2], brick: [0.2 m, 0.1 m, 0.1 m], origin: [0, 0, 0],
                         course: x, bond: stack, gap: 1 mm}}
gravity: [0, 0, -10 m/s^2]
probes: {corner: {body: wall.1.0.0, at: [0.201 m, 0, 0], fields: [velocity.z]}}
measures:
  one: {mean: {body: wall.1.0.1, field: velocity.z}}
  all: {mean: {body: wall, field: velocity.z}}
  depth: {extent: {body: wall.0.0.1, axis: z}}
)");
  ASSERT_EQ(run.failure, "");
  const Real one = run.measures.at("one");
  EXPECT_NEAR(one, -0.1, 1e-4);
  EXPECT_NEAR(run.measures.at("all"), one, 1e-12);
  EXPECT_NEAR(run.measures.at("depth"), 0.1, 1e-12);
  EXPECT_NEAR(run.last("probe.corner.velocity.z"), one, 1e-12);
}

TEST(Bricks, OneThatHasErodedHasNoValue) {
  const auto run = simulate_text(R"(
title: The last of two bricks of lead is pulled apart
geometry: plane-strain
time: {end: 20 us}
materials: {lead: {density: 11340, elastic: {E: 16 GPa, nu: 0.44}, strength: {j2: {yield: 1 MPa}}}}
bodies:
  wall:
    material: lead
    shape: {brick-wall: {bricks: [2, 1], brick: [4 mm, 1 mm], course: x, bond: stack, gap: 0.9 mm}}
    cells: [1, 1]
    erode: {when: {strain: 0.05}, to: nothing}
boundaries:
  pull: {body: wall, where: {plane: {axis: x, at: 8.9 mm}}, velocity: [50 m/s, 0]}
  hold: {body: wall, where: {plane: {axis: x, at: 4.9 mm}}, fix: [x, y]}
measures:
  gone: {max: {body: wall.1.0, field: eps_p}}
  left: {max: {body: wall.0.0, field: eps_p}}
  length: {extent: {body: wall.1.0, axis: x}}
)");
  ASSERT_EQ(run.failure, "");
  EXPECT_TRUE(std::isnan(run.measures.at("gone")));
  EXPECT_TRUE(std::isnan(run.measures.at("length")));
  EXPECT_EQ(run.measures.at("left"), 0);
}

}  // namespace
}  // namespace brunt::test
