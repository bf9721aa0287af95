// With `step_by_area` pairs of faces far stiffer than their elements bound the step by the area
// that they may press in it (docs/theory/contact.md (C56)): not where nothing is near, and little
// where an edge digs in.
//
// Whole faces that meet: fast_faces_test.cpp, by which phi (0.9 e r)^2/4n = 2.2 % of the energy of
// two bodies of 6 elements may be made at phi = 50.
//
// A block that falls on its edge presses a wedge, whose force goes with k g^2: to take the same
// energy, k g^3, it goes 50^(1/3) = 3.7 times less deep where k is 50 times as large, as long as
// its elements give nothing themselves. They do: half of that is asked for.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "contact/law/springs.hpp"
#include "tests/support/random_impacts.hpp"
#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

const std::string kHead = R"(
title: stiff pairs
time: {end: $end}
materials:
  soft: {density: 1000 kg/m^3, elastic: {E: 10 MPa, nu: 0}}
contact: {default: {friction: 0, damping: 0, stiffness: $phi, step_by_area: true}}
output: {history: 1 us}
)";
const std::string kEdge = R"(
geometry: 3d
parameters: {end: 1.2 ms, phi: 50, angle: 30 deg}
bodies:
  flying:
    material: soft
    shape:
      box: {min: [-2 mm, -2 mm, 0], max: [2 mm, 2 mm, 4 mm]}
      rotate: {axis: y, angle: $angle, about: [-2 mm, 0, 0]}
      translate: [0, 0, 2.2 mm]
    size: 1 mm
    velocity: [0, 0, -4 m/s]
  plate:
    material: soft
    shape: {box: {min: [-5.5 mm, -3.3 mm, -3 mm], max: [4.7 mm, 3.7 mm, 0]}}
    size: 1 mm
)";

Real largest(const Simulation& run, const std::string& column) {
  Real value = 0;
  for (const Real one : run.column(column)) value = std::max(value, std::fabs(one));
  return value;
}

TEST(StiffFaces, AnEdgeHardlyBoundsTheStep) {
  for (const std::string angle : {"30 deg", "20 deg", "12 deg"}) {
    const auto run = simulate_text(kHead + kEdge, {"parameters.angle=" + angle});
    const auto soft =
        simulate_text(kHead + kEdge, {"parameters.angle=" + angle, "parameters.phi=1"});
    ASSERT_EQ(run.failure, "") << angle;
    const std::string depth = "contact.flying-plate.max_penetration";
    EXPECT_LT(largest(run, depth), 0.5 * largest(soft, depth)) << angle;
    const Real always = 1.2e-3 / (0.9 * 1e-5 * surface_step_ratio(50, 0));
    EXPECT_LT(static_cast<Real>(run.steps), 0.9 * always) << angle;
    // An edge presses a fifth of a face at most.
    EXPECT_LT(run.created, 0.2 * 0.022) << angle;
    EXPECT_LT(largest(run, "energy.contact.pairs"), 0.2 * 0.022 * run.largest_energy()) << angle;
  }
}

// A needle of particles on a held chisel (random impact 6). At a stiffness of 20 the contact allows
// the step that the particles allow each other, 0.41 dp/c; both springs together allow 0.7 of it
// (C40). Bounded by either alone the needle made 13 % of its energy.
TEST(StiffParticles, KeepTheirEnergy) {
  const Outcome outcome = outcome_of(random_impact(6), {"contact.default.stiffness=20"});
  EXPECT_EQ(outcome.failure, "");
  EXPECT_LT(outcome.created, 1e-3);
  EXPECT_LT(outcome.pairs, 0.01);
}

}  // namespace
}  // namespace brunt::test
