// A lintel of brick lies 30 mm on each of two blocks, elements of 100 mm, and the whole stands on a
// rigid floor. The faces at the ends of the lintel lie 30 mm deep in those of the blocks, over the
// height that the lintel sinks into them: they came in over the borders and not through the faces,
// and push nothing (contact/geometry/overlap_push.hpp). Closed form, at rest:
//   each block carries half of the lintel, m g/2 = 2000 kg/m^3 4.6 l 9.81 m/s^2 / 2 = 45.13 N.
// Damping of 20 1/s leaves exp(-10 0.6) = 0.2 % of what moves at the start: 1 %. Nothing pushes the
// blocks apart but the bending of the lintel, which friction takes: below mu m g/2 = 13.5 N, and no
// block moves, to the 0.1 mm that the lintel bends and sinks.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

const char* const kDeck = R"(
title: a lintel on two blocks
geometry: 3d
time: {end: 0.6 s}
gravity: [0, 0, -9.81 m/s^2]
damping: {rate: 20 1/s}
materials:
  brick: {density: 2000 kg/m^3, elastic: {E: 50 MPa, nu: 0.2}}
bodies:
  left:
    method: fe
    material: brick
    shape: {box: {min: [-300 mm, 0, 0], max: [0, 100 mm, 100 mm]}}
    size: 100 mm
  right:
    method: fe
    material: brick
    shape: {box: {min: [400 mm, 0, 0], max: [700 mm, 100 mm, 100 mm]}}
    size: 100 mm
  lintel:
    method: fe
    material: brick
    shape: {box: {min: [-30 mm, 0, 100 mm], max: [430 mm, 100 mm, 200 mm]}}
    size: 100 mm
  floor:
    rigid: true
    material: brick
    shape: {box: {min: [-500 mm, -100 mm, -100 mm], max: [900 mm, 200 mm, 0]}}
    motion: {velocity: [0, 0, 0]}
contact:
  default: {friction: 0.3}
output: {history: 10 ms}
)";

TEST(Lintel, RestsOnItsBlocks) {
  const auto run = simulate_text(kDeck);
  ASSERT_EQ(run.failure, "");
  const Real half = 2000 * 0.46 * 0.1 * 0.1 * 9.81 / 2;
  for (const char* block : {"left", "right"}) {
    const std::string pair = std::string("contact.") + block + "-lintel.";
    EXPECT_NEAR(std::fabs(run.last(pair + "force.z")), half, 0.01 * half) << block;
    EXPECT_LT(std::fabs(run.last(pair + "force.x")), 0.3 * half) << block;
    EXPECT_LT(run.last(pair + "max_penetration"), 1e-3) << block;
    const std::string place = std::string("body.") + block + ".position.x";
    EXPECT_NEAR(run.last(place), run.first(place), 1e-4) << block;
  }
  Real largest = 0;
  for (const Real held : run.column("energy.contact.spring")) largest = std::max(largest, held);
  // What damping has not taken goes into the ledger's other columns: pairs take next to nothing.
  EXPECT_LT(std::fabs(run.last("energy.contact.pairs")), 0.05 * largest);
}

}  // namespace
}  // namespace brunt::test
