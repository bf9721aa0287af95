// Elements and rigid bodies that meet face on face up to five times as fast as their sound
// none goes through another. Of two like blocks in a tube the first gives its
// momentum to the second, whatever their law: momenta add up, the second leaves faster than the
// first, and there is a gap between them at the end; a block that passes keeps its speed. Two ends
// of a rod that meet press by rho c v/2, which the linear spring, phi M/2h, has at a penetration of
// v/(phi c) of an element: 2 of them at the speed of sound, where faces let go at 1. The barrier
// (FaceBarrier) has it at 0.27, and so many elements deep they may come, the ringing of an elastic
// chain beside it (it overshoots by less than the pressure itself).
//
// contact.pairs is what the mean of the forces at both ends of a step makes of springs that are not
// linear. The first step from before a face into it, dx, of which g is inside, does k g dx/2
// instead of k g^2/2: k dx^2/8 too much at most. On linear springs dx <= 0.83 v h/c (phi = 1/2), k
// = M/4h: 0.021 rho h v^2 of the rho n h v^2/4 that two bodies of n elements lose: 8.6 %/n. Faster
// ones go g0/2 a step, and their remainder falls with v^2. Beside a rigid body the spring is that
// of the elements alone, M/2h: of a free one that is as heavy twice the share, 17.2 %/n; of a held
// one, at which twice as much is lost, the same.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "contact/law/springs.hpp"
#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

// rho = 1000 kg/m^3, M = 10 MPa: c = 100 m/s.
const std::string kHead = R"(
title: blocks that meet fast
time: {end: $end}
materials:
  soft: {density: 1000 kg/m^3, elastic: {E: 10 MPa, nu: 0}}
contact: {default: {friction: 0}}
output: {history: 1 us}
)";
const std::string kTube = R"(
geometry: plane-strain
parameters: {speed: 100 m/s, thick: 6 mm, gap: 0.3 mm, end: 0.3 ms}
bodies:
  flying:
    material: soft
    shape: {box: {min: [0, $gap], max: [10 mm, = $gap + $thick]}}
    size: 1 mm
    velocity: [0, = -$speed]
  standing:
    material: soft
    shape: {box: {min: [0, = -$thick], max: [10 mm, 0]}}
    size: 1 mm
boundaries:
  a: {body: flying, where: {side: min-x}, fix: [x]}
  b: {body: flying, where: {side: max-x}, fix: [x]}
  c: {body: standing, where: {side: min-x}, fix: [x]}
  d: {body: standing, where: {side: max-x}, fix: [x]}
)";
const std::string kTubeInSpace = R"(
geometry: 3d
parameters: {speed: 100 m/s, thick: 4 mm, gap: 0.3 mm, end: 0.2 ms}
bodies:
  flying:
    material: soft
    shape: {box: {min: [0, 0, $gap], max: [3 mm, 2 mm, = $gap + $thick]}}
    size: 1 mm
    velocity: [0, 0, = -$speed]
  standing:
    material: soft
    shape: {box: {min: [0, 0, = -$thick], max: [3 mm, 2 mm, 0]}}
    size: 1 mm
boundaries:
  a: {body: flying, where: all, fix: [x, y]}
  b: {body: standing, where: all, fix: [x, y]}
)";

Real least(const BodyView& body, std::size_t axis) {
  Real value = kInfinity;
  for (std::size_t i = axis; i < body.position.size(); i += 3)
    value = std::min(value, body.position[i]);
  return value;
}
Real most(const BodyView& body, std::size_t axis) {
  Real value = -kInfinity;
  for (std::size_t i = axis; i < body.position.size(); i += 3)
    value = std::max(value, body.position[i]);
  return value;
}

Simulation meet(const std::string& deck, Real mach, std::vector<std::string> overrides = {}) {
  overrides.push_back("parameters.speed=" + std::to_string(100 * mach) + " m/s");
  return simulate_text(kHead + deck, overrides);
}

void expect_small_remainder(const Simulation& run, Real share) {
  Real remainder = 0;
  for (const Real e : run.column("energy.contact.pairs"))
    remainder = std::max(remainder, std::fabs(e));
  EXPECT_LT(remainder, share * run.largest_energy());
  EXPECT_LT(run.worst_drift, 1e-12);
}

/// dim of the tube; the first stays before the second.
void expect_momentum_is_given(int dim, Real mach, Real remainder,
                              const std::vector<std::string>& overrides = {}) {
  const auto run = meet(dim == 2 ? kTube : kTubeInSpace, mach, overrides);
  ASSERT_EQ(run.failure, "") << mach;
  const std::string axis = dim == 2 ? "y" : "z";
  const Real flying = run.last("body.flying.velocity." + axis);
  const Real standing = run.last("body.standing.velocity." + axis);
  EXPECT_NEAR(flying + standing, -100 * mach, 1e-10 * mach) << "momentum";
  EXPECT_LT(standing, flying) << dim << "D, mach " << mach;
  const auto up = static_cast<std::size_t>(dim - 1);
  EXPECT_GT(least(run.bodies.at("flying"), up), most(run.bodies.at("standing"), up)) << mach;
  expect_small_remainder(run, remainder);
}

TEST(FastFaces, GiveTheirMomentumInATube) {
  for (const Real mach : {0.5, 1.0, 2.0}) expect_momentum_is_given(2, mach, 0.086 / 6);
}

TEST(FastFaces, GiveTheirMomentumWhereTheyAreOneElementThick) {
  for (const Real mach : {0.5, 1.0, 2.0}) {
    expect_momentum_is_given(2, mach, 0.086, {"parameters.thick=1 mm", "parameters.end=0.1 ms"});
  }
}

TEST(FastFaces, GiveTheirMomentumInSpace) {
  for (const Real mach : {0.5, 2.0}) expect_momentum_is_given(3, mach, 0.086 / 4);
}

// Pairs far stiffer than their elements, with `step_by_area`: docs/theory/contact.md (C56).
// Elements of h = 1 mm, c = 100 m/s and safety 0.9 have a step of 9 us times the factor r of (C39),
// which is 0.786 for phi = 2 and 0.199 for phi = 50, and e = 0.57 of that where whole faces press.
// What the mean of the forces at both ends of a step makes of the first one into a spring is k
// dx^2/8 too much at most, k = phi M/2h, dx = 0.9 e r v h/c: phi (0.9 e r)^2/4n of the rho n h
// v^2/4 that two bodies of n elements lose, 2.2 % for n = 6, and the same once more where they
// part. (Where whole faces bound the step always, at the limit itself, nodes that bounce off and
// back make 93 %.)
TEST(FastFaces, StiffOnesBoundTheStepByTheAreaThatTheyPress) {
  const auto run = meet(kTube, 0.1,
                        {"contact.default.damping=0", "contact.default.stiffness=50",
                         "contact.default.step_by_area=true", "parameters.end=1 ms"});
  ASSERT_EQ(run.failure, "");
  EXPECT_NEAR(run.last("body.standing.velocity.y") + run.last("body.flying.velocity.y"), -10, 1e-9);
  EXPECT_LT(run.last("body.standing.velocity.y"), run.last("body.flying.velocity.y"));
  EXPECT_LT(run.created, 2 * 0.022);
  expect_small_remainder(run, 2 * 0.022);
  const auto dt = run.column("dt");
  EXPECT_LE(*std::min_element(dt.begin(), dt.end()), 0.9e-5 * surface_step_ratio(50, 0));
  // Apart they are as free as their elements are; the last steps lead to the end.
  EXPECT_GE(dt[dt.size() - 20], 0.98 * 0.9e-5 * surface_step_ratio(2, 0));
}

TEST(FastFaces, SeeEachOtherFromAfar) {
  // 5 mm are more than a step of the elements alone would jump: at 2 c, 1.8 mm.
  for (const Real gap : {3.1, 5.0, 5.7}) {
    expect_momentum_is_given(2, 2, 0.086 / 2,
                             {"parameters.gap=" + std::to_string(gap) + " mm",
                              "parameters.thick=2 mm", "parameters.end=0.12 ms"});
  }
}

TEST(FastFaces, HoldTheShockAtFiveTimesTheirSound) {
  // Until the shocks have come through two elements each: 24 us. Later elements are crushed to
  // less than a hundredth, and what is left of them is unstable.
  const auto run = meet(kTube, 5, {"parameters.end=24 us"});
  ASSERT_EQ(run.failure, "");
  Real deepest = 0;
  for (const Real d : run.column("contact.flying-standing.max_penetration"))
    deepest = std::max(deepest, d);
  EXPECT_LT(deepest, 1e-3);  // where they would let go
  // The shock is in both alike: between two faces that move at v/2, the middle.
  EXPECT_GT(run.last("body.standing.velocity.y"), -250);
  EXPECT_LT(run.last("body.standing.velocity.y"), -50);
  expect_small_remainder(run, 0.01);
}

/// A block on a wider plate; what the block is besides.
std::string block_on_plate(const std::string& kind) {
  return R"(
geometry: plane-strain
parameters: {speed: 10 m/s}
bodies:
  flying:
    )" + kind +
         R"(material: soft
    shape: {box: {min: [3 mm, 0.3 mm], max: [13 mm, 6.3 mm]}}
    size: 1 mm
    velocity: [0, = -$speed]
  standing:
    material: soft
    shape: {box: {min: [0, -6 mm], max: [16 mm, 0]}}
    size: 1 mm
)";
}

TEST(FastFaces, ReturnWhereTheyAreFreeAside) {
  // From 0.7 times the speed of sound on, elements without strength fold at the corners of the
  // block, and faces go through each other there: lost_contacts_test.cpp.
  const std::string deck = block_on_plate("");
  for (const Real mach : {0.1, 0.3, 0.5, 0.6}) {
    const auto run = meet(deck, mach, {"time.end=0.5 ms"});
    ASSERT_EQ(run.failure, "") << mach;
    EXPECT_LT(run.last("body.standing.velocity.y"), run.last("body.flying.velocity.y")) << mach;
    EXPECT_EQ(run.last("contact.flying-standing.max_penetration"), 0) << mach;
    EXPECT_GT(run.last("body.flying.position.y"), run.last("body.standing.position.y") + 5e-3);
    expect_small_remainder(run, 0.086 / 6);
  }
}

TEST(FastFaces, HoldARigidBody) {
  // A free rigid block of the same mass falls on the plate, and one that is held is hit by it.
  const std::string deck = block_on_plate("rigid: true\n    ");
  for (const Real mach : {0.1, 0.5, 1.0}) {
    const auto run = meet(deck, mach, {"time.end=0.6 ms"});
    ASSERT_EQ(run.failure, "") << mach;
    EXPECT_LT(run.last("body.standing.velocity.y"), run.last("body.flying.velocity.y")) << mach;
    expect_small_remainder(run, 0.172 / 6);
  }
  const std::string wall = R"(
geometry: plane-strain
parameters: {speed: 10 m/s}
bodies:
  wall:
    rigid: true
    shape: {box: {min: [-2 mm, -4 mm], max: [12 mm, 0]}}
    size: 2 mm
  flying:
    material: soft
    shape: {box: {min: [0, 0.3 mm], max: [10 mm, 6.3 mm]}}
    size: 1 mm
    velocity: [0, = -$speed]
boundaries:
  a: {body: flying, where: {side: min-x}, fix: [x]}
  b: {body: flying, where: {side: max-x}, fix: [x]}
)";
  for (const Real mach : {0.5, 1.0, 2.0}) {
    const auto run = meet(wall, mach, {"time.end=0.3 ms"});
    ASSERT_EQ(run.failure, "") << mach;
    EXPECT_GT(run.last("body.flying.velocity.y"), 0) << mach;
    EXPECT_GT(least(run.bodies.at("flying"), 1), 0) << mach;
    expect_small_remainder(run, 0.086 / 6);
  }
}

}  // namespace
}  // namespace brunt::test
