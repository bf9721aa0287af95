// With `step_by_area` pairs of faces far stiffer than their elements bound the step by the area
// that they may press in it (docs/theory/contact.md (C56)): not where nothing is near, and little
// where an edge digs in.
//
// Elements of h = 1 mm, c = 100 m/s and safety 0.9: a step of 9 us times the factor of (C39), which
// is 0.786 for phi = 2 and 0.199 for phi = 50, and half of that where whole faces press, e = 0.57.
// Of two like blocks in a tube the first gives its momentum to the second. What the mean of the
// forces at both ends of a step makes of the first one into a spring is k dx^2/8 too much at most,
// with k = phi M/2h and dx = 0.9 e r v h/c: phi (0.9 e r)^2/4n of the rho n h v^2/4 that two bodies
// of n elements lose, 2.2 % for n = 6, and the same once more where they part. (Bounded by the
// limit itself instead of e times it, nodes that bounce off and back made 93 % of the energy.)
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
const std::string kTube = R"(
geometry: plane-strain
parameters: {end: 1 ms, phi: 50}
bodies:
  flying:
    material: soft
    shape: {box: {min: [0, 0.3 mm], max: [10 mm, 6.3 mm]}}
    size: 1 mm
    velocity: [0, -10 m/s]
  standing:
    material: soft
    shape: {box: {min: [0, -6 mm], max: [10 mm, 0]}}
    size: 1 mm
boundaries:
  a: {body: flying, where: {side: min-x}, fix: [x]}
  b: {body: flying, where: {side: max-x}, fix: [x]}
  c: {body: standing, where: {side: min-x}, fix: [x]}
  d: {body: standing, where: {side: max-x}, fix: [x]}
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

TEST(StiffFaces, BoundTheStepWhileTheyPress) {
  const auto run = simulate_text(kHead + kTube);
  ASSERT_EQ(run.failure, "");
  EXPECT_NEAR(run.last("body.standing.velocity.y") + run.last("body.flying.velocity.y"), -10, 1e-9);
  EXPECT_LT(run.last("body.standing.velocity.y"), run.last("body.flying.velocity.y"));
  EXPECT_LT(largest(run, "energy.contact.pairs"), 2 * 0.022 * run.largest_energy());
  EXPECT_LT(run.created, 2 * 0.022);
  EXPECT_LT(run.worst_drift, 1e-12);
  // Pressed they hold the step that whole faces need, and apart that of their elements.
  const auto dt = run.column("dt");
  const Real whole = 0.9 * 1e-5 * surface_step_ratio(50, 0);
  EXPECT_LE(*std::min_element(dt.begin(), dt.end()), 1.001 * whole);
  EXPECT_GE(dt[dt.size() - 20], 0.98 * 0.9e-5 * surface_step_ratio(2, 0));
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
