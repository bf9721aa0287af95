// Everything erodes: bodies of one element and of many, of each kind of element, in each geometry,
// at once or one after another. What is left is their mass as points, or nothing; the ledger closes
// and a restart says the same.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

/// What points about the axis meet: a rigid plane, a rigid box, and points like them.
constexpr const char* kPlane =
    "{rigid: true, shape: {plane: {origin: [5 mm, 0], normal: y, extent: 10 mm}}}";
constexpr const char* kBox = "{rigid: true, shape: {box: {min: [0, -4 mm], max: [4 mm, 0]}}}";
constexpr const char* kTwin =
    "material: rubber\n    velocity: [0, $speed]\n"
    "    shape: {box: {min: [0, -1.6 mm], max: [2 mm, -0.6 mm]}}";

struct Case {
  const char *geometry, *box, *cells, *velocity, *element;
};
constexpr Case kCases[] = {
    {"3d", "{min: [0, 0, 0], max: [1 mm, 1 mm, 1 mm]}", "[1, 1, 1]", "[10 m/s, 0, 5 m/s]",
     "{integration: one-point}"},
    {"3d", "{min: [0, 0, 0], max: [2 mm, 3 mm, 2 mm]}", "[2, 3, 2]", "[10 m/s, 0, 5 m/s]",
     "{integration: q1p0}"},
    {"3d", "{min: [0, 0, 0], max: [2 mm, 2 mm, 2 mm]}", "[2, 2, 2]", "[10 m/s, 0, 5 m/s]",
     "{type: tet4}"},
    {"plane-strain", "{min: [0, 0], max: [2 mm, 2 mm]}", "[2, 2]", "[10 m/s, 3 m/s]",
     "{integration: full}"},
    {"axisymmetric", "{min: [0, 0], max: [2 mm, 2 mm]}", "[2, 2]", "[0, 3 m/s]",
     "{integration: one-point}"},
};

std::string flying_block(const Case& one, const std::string& erode, const std::string& more) {
  return std::string("title: All of it erodes\ngeometry: ") + one.geometry + R"(
time: {end: 2 us, max_step: 20 ns}
materials:
  rubber: {density: 1000 kg/m^3, elastic: {E: 1 GPa, nu: 0.3}, thermal: {cp: 1000 J/kg/K, k: 0.2}}
bodies:
  block:
    material: rubber
    shape: {box: )" +
         one.box + "}\n    cells: " + one.cells + "\n    velocity: " + one.velocity +
         "\n    element: " + one.element + "\n    erode: " + erode + R"(
measures:
  length: {extent: {body: block, axis: x}}
  fastest: {max: {body: block, field: velocity.x}}
  pressed: {mean: {body: block, field: pressure}}
output: {every: 0.5 us, history: 0.1 us}
)" + more;
}

TEST(ErosionExtremes, AllElementsOfABodyGo) {
  for (const auto& one : kCases) {
    for (const char* const heat : {"", "heat: conduct\n"}) {
      for (const bool stays : {true, false}) {
        const std::string erode =
            std::string("{when: {step: 1 s}, to: ") + (stays ? "points}" : "nothing}");
        const auto run = simulate_text(flying_block(one, erode, heat));
        EXPECT_EQ(run.failure, "") << one.geometry << one.element;
        EXPECT_EQ(run.last("body.block.internal"), 0);
        EXPECT_NEAR(run.last("body.block.eroded_mass") / run.first("body.block.mass"), 1, 1e-14);
        EXPECT_LT(run.worst_drift, 1e-13) << one.geometry << one.element << stays;
        const Real mass = run.last("body.block.mass"), kinetic = run.first("energy.kinetic");
        EXPECT_EQ(mass, stays ? run.first("body.block.mass") : 0) << one.geometry;
        EXPECT_NEAR(run.last(stays ? "energy.kinetic" : "energy.eroded") / kinetic, 1, 1e-13);
        const auto split = simulate_text(flying_block(one, erode, heat), {}, {.split_at = 7});
        EXPECT_EQ(split.hashes, run.hashes) << one.geometry << one.element << stays;
      }
    }
  }
}

// A particle on the axis had no breadth there, and friction of it was 0/0.
TEST(ErosionExtremes, WhatIsLeftOnTheAxisRubs) {
  for (const char* const heat : {"", "heat: conduct\n"}) {
    const auto run = simulate_text(std::string(heat) + R"(
title: Points of an eroded plate rub on a block about the axis
geometry: axisymmetric
time: {end: 10 us}
materials:
  soft: {density: 2700, elastic: {E: 5e9, nu: 0.33}, strength: {j2: {yield: 2e7}},
         damage: {strain: 0.08}, thermal: {cp: 900, k: 150}}
  hard: {density: 7800, elastic: {E: 2e10, nu: 0.3}, thermal: {cp: 450, k: 40}}
bodies:
  plate:
    material: soft
    shape: {box: {min: [0, 0], max: [2 mm, 0.25 mm]}}
    cells: [2, 1]
    erode: {when: {strain: 0.05}, to: points}
  block:
    material: hard
    shape: {box: {min: [0, 0.26 mm], max: [2 mm, 1.26 mm]}}
    cells: [2, 1]
    velocity: [0, -150 m/s]
contact: {default: {friction: 0.2}}
boundaries: {base: {body: plate, where: {side: min-y}, fix: [x, y]}}
)");
    EXPECT_EQ(run.failure, "") << heat;
    EXPECT_NEAR(run.last("time"), 10e-6, 1e-12);
    EXPECT_GT(run.last("body.plate.eroded_mass"), 0);
    EXPECT_TRUE(std::isfinite(run.last("energy.contact.friction"))) << heat;
  }
}

/// Blocks of two columns from the axis on that become points and come at `speed` to what is told.
std::string falling_points(const std::string& integration, const std::string& speed,
                           const std::string& other) {
  const std::string end = "\n    cells: [2, 1]\n    element: {integration: " + integration +
                          "}\n    erode: {when: {step: 1 s}, to: points}\n";
  return R"(
title: Points of a block about the axis come back
geometry: axisymmetric
time: {end: 60 us, max_step: 5 ns}
parameters: {speed: )" +
         speed + R"(}
materials:
  rubber: {density: 1000 kg/m^3, elastic: {E: 1 GPa, nu: 0.3}}
contact: {default: {damping: 0}}
output: {every: 1 s, history: 1 us}
bodies:
  block:
    material: rubber
    velocity: [0, -$speed]
    shape: {box: {min: [0, 0.6 mm], max: [2 mm, 1.6 mm]}})" +
         end + "  other:" + (other == kTwin ? "\n    " + other + end : " " + other + "\n");
}

// Those on the axis went through, as nothing held them.
TEST(ErosionExtremes, PointsOnTheAxisComeBack) {
  for (const char* const integration : {"one-point", "q1p0"}) {
    for (const std::string other : {kPlane, kBox, kTwin}) {
      const bool twin = other == kTwin;
      // At half the speed of sound centres go behind the surface.
      for (const Real speed : {50.0, twin ? 100.0 : 500.0}) {
        const auto run =
            simulate_text(falling_points(integration, std::to_string(speed) + " m/s", other));
        EXPECT_EQ(run.failure, "");
        EXPECT_TRUE(run.lost.empty()) << integration << other << speed;
        // Elastic, but for the steps: dt w is 0.01, and in the barrier some ten times that.
        EXPECT_NEAR(run.last("body.block.velocity.y") / speed, 1, 3e-3) << integration << other;
        EXPECT_NEAR(run.last("energy.kinetic") / run.first("energy.kinetic"), 1, 6e-3);
        EXPECT_LT(run.worst_drift, 1e-12);
        if (!twin) continue;
        EXPECT_NEAR(run.last("momentum.y") / (run.last("body.block.mass") * speed), 0, 1e-12);
      }
    }
  }
}

// Free points of one body do not touch each other: those that fly inwards come to the other side,
// and bounds of steps and dampers of a breadth below 0 were no number.
TEST(ErosionExtremes, PointsThatCrossTheAxisOnAFloorGoOn) {
  const auto run = simulate_text(R"(
title: Points of a ring fly through the axis while they touch a floor
geometry: axisymmetric
time: {end: 4 us, max_step: 5 ns}
materials:
  rubber: {density: 1000 kg/m^3, elastic: {E: 1 GPa, nu: 0.3}}
bodies:
  block:
    material: rubber
    shape: {box: {min: [0.6 mm, 0.26 mm], max: [1.6 mm, 1.26 mm]}}
    cells: [1, 1]
    velocity: [-500 m/s, -10 m/s]
    erode: {when: {step: 1 s}, to: points}
  floor: {rigid: true, shape: {plane: {origin: [5 mm, 0], normal: y, extent: 10 mm}}}
contact: {default: {friction: 0.2}}
output: {every: 1 s, history: 0.1 us}
)");
  EXPECT_EQ(run.failure, "");
  EXPECT_NEAR(run.last("time"), 4e-6, 1e-12);
  EXPECT_LT(run.worst_drift, 1e-12);
  for (const Real force : run.column("contact.block-floor.force.y")) EXPECT_GE(force, 0);
}

TEST(ErosionExtremes, PointsThatAreLeftTouchWhatTheyMeet) {
  // A cube in free flight becomes points and meets a wall that is held: they come back.
  const auto run = simulate_text(R"(
title: Points against a wall
geometry: 3d
time: {end: 60 us, max_step: 0.1 us}
materials:
  rubber: {density: 1000 kg/m^3, elastic: {E: 1 GPa, nu: 0.3}}
bodies:
  block:
    material: rubber
    shape: {box: {min: [-1 mm, -1 mm, 1 mm], max: [1 mm, 1 mm, 3 mm]}}
    cells: [2, 2, 2]
    velocity: [0, 0, -100 m/s]
    erode: {when: {step: 1 s}}
  wall: {rigid: true, shape: {plane: {origin: [0, 0, 0], normal: z, extent: 20 mm}}}
contact: {default: {damping: 0}}
output: {every: 1 s, history: 1 us}
)");
  EXPECT_EQ(run.failure, "");
  EXPECT_EQ(run.last("body.block.eroded"), 8);
  EXPECT_NEAR(run.last("body.block.velocity.z"), 100, 1);
  EXPECT_NEAR(run.last("energy.kinetic") / run.first("energy.kinetic"), 1, 0.01);
  EXPECT_LT(run.worst_drift, 1e-10);
}

}  // namespace
}  // namespace brunt::test
