// Planes of symmetry of particles (docs/theory/sph.md, section 14). What lies beyond a plane is the
// mirror image of what lies before it, so that a half, a quarter or an eighth of a scene that is
// symmetric is the scene: sums have the same pairs, in another order, and all that differs is
// rounding. It grows as fast as the scene parts what lies side by side: 1e-9 of energies and
// lengths for the blocks here, which it leaves 1e-13; 1e-6 where pairs are of single precision.
//   Bits are those of any threads and lists, and over a restart.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

/// A bar of 6 x 6 x 9 mm against a wall, or a quarter of it.
std::string bar(bool quarter, const std::string& keys, const std::string& thermal = "") {
  return std::string(R"(
title: A bar of particles hits a wall
geometry: 3d
time: {end: 8 us}
materials:
  copper: {density: 8930 kg/m^3, elastic: {E: 117 GPa, nu: 0.35},
           strength: {j2: {yield: 400 MPa, hardening: 100 MPa}})") +
         thermal + R"(}
bodies:
  bar:
    method: sph
    material: copper
    size: 1 mm
    velocity: [0, 0, -227 m/s]
    shape: {box: {min: )" +
         (quarter ? "[0, 0, 0]" : "[-3 mm, -3 mm, 0]") + R"(, max: [3 mm, 3 mm, 9 mm]}}
    )" + keys +
         R"(
  wall: {rigid: true, shape: {plane: {origin: [0, 0, 0], normal: z, extent: 20 mm}}}
contact: {default: {friction: 0.2}}
measures:
  length: {extent: {body: bar, axis: z}}
  foot: {max: {body: bar, field: displacement.x}}
  strain: {max: {body: bar, field: eps_p}}
)" + (quarter ? "symmetry: {x: 0, y: 0}\n" : "");
}

void expect_share(const Simulation& whole, const Simulation& part, Real shares, Real tolerance) {
  ASSERT_EQ(whole.failure, "");
  ASSERT_EQ(part.failure, "");
  EXPECT_EQ(whole.steps, part.steps);
  const Real scale = whole.largest_energy();
  for (const auto& column : whole.columns) {
    if (column.substr(0, 7) != "energy." || column == "energy.drift") continue;
    EXPECT_NEAR(shares * part.last(column), whole.last(column), tolerance * scale) << column;
  }
  for (const auto& [name, value] : whole.measures) {
    EXPECT_NEAR(part.measures.at(name), value, tolerance * std::fabs(value)) << name;
  }
}

void expect_a_quarter(const std::string& keys, Real tolerance, const std::string& thermal = "") {
  expect_share(simulate_text(bar(false, keys, thermal)), simulate_text(bar(true, keys, thermal)), 4,
               tolerance);
}

TEST(MirroredParticles, AQuarterOfABarIsTheBar) {
  expect_a_quarter("artificial_stress: 0.3", 1e-9);
  expect_a_quarter("xsph: 0.1", 1e-9);
  expect_a_quarter("correction: false", 1e-9);
}

TEST(MirroredParticles, AQuarterOfATotalBarIsTheBar) {
  expect_a_quarter("formulation: total\n    smoothing: 1.2", 1e-9);
}

TEST(MirroredParticles, InSinglePrecisionToo) {
  expect_a_quarter("pair_precision: single\n    artificial_stress: 0.3", 1e-6);
}

TEST(MirroredParticles, HeatFlowsAsInTheWhole) {
  expect_a_quarter("temperature: '= 300 + 1e4 * z + 1e7 * (x * x + y * y)'", 1e-9,
                   ", thermal: {k: 4000 W/m/K, cp: 385 J/kg/K}");
}

/// A block below x = 1003 mm whose halves fly through each other, as nothing brakes them: what is
/// behind the plane has its image before it.
std::string halves(bool half) {
  return std::string(R"(
title: Halves that fly through each other
geometry: plane-strain
time: {end: 6 us}
materials: {stuff: {density: 2700 kg/m^3, elastic: {E: 1 GPa, nu: 0.3}}}
bodies:
  block:
    method: sph
    material: stuff
    size: 0.5 mm
    viscosity: {alpha: 0, beta: 0}
    velocity: ["= x > 1.003 ? -500 : 500", 0]
    shape: {box: {min: [999 mm, -2 mm], max: [)") +
         (half ? "1003" : "1007") + R"( mm, 2 mm]}}
measures: {height: {extent: {body: block, axis: y}}}
)" + (half ? "symmetry: {x: 1003 mm}\n" : "");
}

TEST(MirroredParticles, WhatComesThroughThePlaneMeetsItsImages) {
  bool through = false;
  SceneHooks hooks;
  hooks.moved = [&](std::int64_t, const std::function<BodyView(Label)>& view) {
    const BodyView block = view(0);
    for (std::size_t k = 0; k < block.position.size(); k += 3) {
      through = through || block.position[k] > 1.003;
    }
  };
  expect_share(simulate_text(halves(false)), simulate_text(halves(true), {}, {}, hooks), 2, 1e-9);
  EXPECT_TRUE(through);
}

TEST(MirroredParticles, BitsDependOnTheDeckAlone) {
  for (const std::string& text :
       {halves(true), bar(true, "artificial_stress: 0.3"), bar(true, "formulation: total")}) {
    const auto plain = simulate_text(text);
    ASSERT_EQ(plain.failure, "");
    RunVariation threads, lists, split;
    threads.threads = 2, lists.rearrange_every_step = true, split.split_at = 15;
    for (const auto& variation : {threads, lists, split}) {
      EXPECT_EQ(simulate_text(text, {}, variation).hashes.back(), plain.hashes.back());
    }
  }
}

// A second block, a spacing beside the plane, is no part of what lies on it: it flies through.
TEST(MirroredParticles, WhatDoesNotTouchThePlaneIsNotReflected) {
  const auto run = simulate_text(R"(
title: A block flies through a plane
geometry: plane-strain
time: {end: 40 us}
materials: {al: {density: 2700 kg/m^3, elastic: {E: 70 GPa, nu: 0.3}}}
bodies:
  on: {method: sph, material: al, size: 1 mm, shape: {box: {min: [0, 10 mm], max: [4 mm, 14 mm]}}}
  off: {method: sph, material: al, size: 1 mm, velocity: [-100 m/s, 0],
        shape: {box: {min: [1 mm, 0], max: [5 mm, 4 mm]}}}
symmetry: {x: 0}
measures:
  off: {max: {body: off, field: velocity.x}}
)");
  ASSERT_EQ(run.failure, "");
  EXPECT_EQ(run.measures.at("off"), -100);
}

}  // namespace
}  // namespace brunt::test
