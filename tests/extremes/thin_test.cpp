// Particles shot at plates one element thick (physics.md C11; contact.md 3, test 23), 0.2 to 5
// times as fast as their sound, 0 to 89 degrees off the normal: none comes out behind. The plates
// are a half to two spacings thick, in the plane and in space; held, so that they give way nowhere,
// or free. A particle whose centre has passed the middle is nearer to the back, and lost: the
// barrier of thin plates has to stop it before (barrier_of in contact/particle_law.hpp).
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

// Every shot is a brick of one particle, rho = 1000 kg/m^3, M = 10 MPa: c = 100 m/s. They stand on
// a slope, 0.1 to 0.9 mm above the plate, so that they meet it in all parts of a step.
const std::string kDeck = R"(
title: shots at a thin plate
parameters: {mach: 1, c: 100 m/s, angle: 0 deg, thick: 1 mm, long: 20 mm, end: 1 ms}
time: {end: $end}
materials:
  soft: {density: 1000 kg/m^3, elastic: {E: 10 MPa, nu: 0}}
  hard: {density: 1000 kg/m^3, elastic: {E: 1 GPa, nu: 0}}
output: {history: 1 us}
)";
const std::string kInPlane = R"(
geometry: plane-strain
bodies:
  shots:
    method: sph
    material: soft
    shape:
      brick-wall: {bricks: [9, 1], brick: [1 mm, 1 mm], gap: 0.83 mm, origin: [0, 0.1 mm]}
      rotate: {angle: 3 deg, about: [0, 0.1 mm]}
    size: 1 mm
    velocity: [= $mach * $c * sin($angle), = -$mach * $c * cos($angle)]
  plate:
    material: hard
    shape: {box: {min: [-3 mm, = -$thick], max: [$long, 0]}}
    size: [1 mm, $thick]
)";
const std::string kInSpace = R"(
geometry: 3d
bodies:
  shots:
    method: sph
    material: soft
    shape:
      brick-wall: {bricks: [9, 1, 1], brick: [1 mm, 1 mm, 1 mm], gap: 0.83 mm,
                   origin: [0, -0.3 mm, 0.1 mm]}
      rotate: {axis: y, angle: -3 deg, about: [0, 0, 0.1 mm]}
    size: 1 mm
    velocity: [= $mach * $c * sin($angle), 0, = -$mach * $c * cos($angle)]
  plate:
    material: hard
    shape: {box: {min: [-3 mm, -2 mm, = -$thick], max: [$long, 2 mm, 0]}}
    size: [1 mm, 1 mm, $thick]
)";
const std::string kHeld[] = {"boundaries: {all: {body: plate, where: all, fix: [x, y]}}\n",
                             "boundaries: {all: {body: plate, where: all, fix: [x, y, z]}}\n"};

/// How many of the shots are not over the corner of the plate's upper side that is nearest to them
/// along the plate, or do not fly away from its mean motion.
int count_lost(const Simulation& run, int dim) {
  const auto &shots = run.bodies.at("shots"), &plate = run.bodies.at("plate");
  const auto& moved = field_named(plate.point_fields, "displacement")->values;
  const auto& v = field_named(shots.point_fields, "velocity")->values;
  const auto up = static_cast<std::size_t>(dim - 1);
  const Real plate_speed = run.last(dim == 2 ? "body.plate.velocity.y" : "body.plate.velocity.z");
  int lost = 0;
  for (std::size_t s = 0; s < shots.position.size(); s += 3) {
    Real nearest = kInfinity, height = 0;
    for (std::size_t i = 0; i < plate.position.size(); i += 3) {
      if (plate.position[i + up] - moved[i + up] < -1e-9) continue;  // the lower side
      const Real aside = std::hypot(plate.position[i] - shots.position[s],
                                    dim == 3 ? plate.position[i + 1] - shots.position[s + 1] : 0.0);
      if (aside < nearest)
        nearest = aside, height = shots.position[s + up] - plate.position[i + up];
    }
    EXPECT_LT(nearest, 1e-3);
    lost += height > 0 && v[s + up] > plate_speed ? 0 : 1;
  }
  return lost;
}

/// thick [mm]; degrees off the normal
Simulation shot(int dim, bool held, Real thick, Real mach, Real degrees,
                const RunVariation& variation = {}) {
  const Real angle = degrees * kPi / 180, down = 0.95e-3 / (mach * 100 * std::cos(angle));
  const Real end = 2.2 * down + 50e-6 / mach;  // [s]
  const std::string deck = kDeck + (dim == 2 ? kInPlane : kInSpace) + (held ? kHeld[dim - 2] : "");
  return simulate_text(
      deck,
      {"parameters.mach=" + std::to_string(mach),
       "parameters.angle=" + std::to_string(degrees) + " deg",
       "parameters.thick=" + std::to_string(thick) + " mm",
       "parameters.end=" + std::to_string(1e6 * end) + " us",
       "parameters.long=" + std::to_string(20 + 1e5 * mach * std::sin(angle) * end) + " mm"},
      variation);
}

void expect_none_lost(int dim, bool held, Real thick, Real mach, Real degrees) {
  const auto run = shot(dim, held, thick, mach, degrees);
  ASSERT_EQ(run.failure, "");
  ASSERT_EQ(run.bodies.at("shots").position.size(), 27u);
  EXPECT_EQ(count_lost(run, dim), 0) << dim << "D, " << (held ? "held, " : "free, ") << thick
                                     << " mm, mach " << mach << ", " << degrees << " degrees";
}

// At 5 c, half of the plate's own speed of sound, a free plate of half a spacing is squeezed as it
// is hit, its middle nearer than its depth at time 0, and one in nine passes: it is shot at with 2
// c at most.
void shoot(int dim, const std::vector<Real>& machs) {
  for (const bool held : {true, false}) {
    for (const Real thick : {0.5, 1.0, 2.0}) {
      for (const Real mach : machs) {
        if (!held && thick == 0.5 && mach > 2) continue;
        for (const Real degrees : {0.0, 45.0}) expect_none_lost(dim, held, thick, mach, degrees);
      }
      expect_none_lost(dim, held, thick, 5, 80);
    }
  }
}

TEST(ThinPlate, NothingPassesInThePlane) {
  shoot(2, {0.2, 1, 2, 5});
  expect_none_lost(2, true, 1, 5, 89);
}
TEST(ThinPlate, NothingPassesInSpace) { shoot(3, {2, 5}); }

// The step follows the depth of the thinnest face of all, whatever is listed.
TEST(ThinPlate, KeepsItsBits) {
  const auto run = shot(3, false, 0.5, 2, 45);
  RunVariation threads, lists, halves;
  threads.threads = 2;
  lists.rearrange_every_step = true;
  halves.split_at = run.steps / 2;
  for (const auto& variation : {threads, lists, halves}) {
    EXPECT_EQ(shot(3, false, 0.5, 2, 45, variation).hashes, run.hashes);
  }
}

}  // namespace
}  // namespace brunt::test
