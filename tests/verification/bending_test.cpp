// A cantilever of length L and height h = L/10 is pulled aside at its end by F, and comes to rest
// under damping. By Timoshenko, with E' = E/(1 - nu^2) in plane strain and E of a square bar,
//   d = F L^3/(3 E' I) + 6 F L/(5 G A).
//
// Two one-point elements through the height with assumed-strain hourglass control, the default of
// elastic bodies, are within 2 % of it (measured 0.8 % and 1.0 % short: the wall holds what would
// contract beside it, and elements half as long as high see a shear of steps). By stiffness control
// they would be 28 % too soft: each layer is stretched evenly and bends for nothing, which leaves
// 1 - 1/n^2 of the moment of inertia. At nu = 0.499, 20 elements long, 5 %: nothing locks (4 %).
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

constexpr Real kLength = 0.1, kHeight = 0.01, kE = 2e9, kForce = 10;

std::string deck(bool plane, const std::string& nu) {
  const std::string third = plane ? "" : ", 0", fix = plane ? "[x, y]" : "[x, y, z]";
  return R"(
title: Cantilever
geometry: )" +
         std::string(plane ? "plane-strain" : "3d") + (plane ? "\ndepth: 10 mm" : "") + R"(
time: {end: 50 ms}
heat: off
damping: {rate: 600 1/s}
materials: {plastic: {density: 1200 kg/m^3, elastic: {E: 2 GPa, nu: )" +
         nu + R"(}}}
bodies:
  beam:
    material: plastic
    shape: {box: {min: [0, 0)" +
         third + "], max: [100 mm, 10 mm" + (plane ? "" : ", 10 mm") + R"(]}}
    cells: )" +
         (plane ? "[20, 2]" : "[20, 2, 2]") + R"(
boundaries:
  wall: {body: beam, where: {side: min-x}, fix: )" +
         fix + R"(}
  end: {body: beam, where: {side: max-x}, force: [0, 10 N)" +
         third + R"(]}
measures:
  deflection: {max: {body: beam, field: displacement.y}}
output: {history: 1 ms}
)";
}

/// How far a cantilever bends, over Timoshenko's.
Real bending(bool plane, Real nu, const std::vector<std::string>& overrides = {}) {
  const auto run = simulate_text(deck(plane, std::to_string(nu)), overrides);
  EXPECT_EQ(run.failure, "");
  EXPECT_LT(run.worst_drift, 1e-10);
  EXPECT_LT(run.last("energy.kinetic"), 1e-6 * run.last("energy.internal"));
  const Real shear = kE / (2 * (1 + nu)), modulus = plane ? kE / (1 - nu * nu) : kE;
  const Real area = kHeight * kHeight, inertia = area * kHeight * kHeight / 12;
  const Real exact = kForce * std::pow(kLength, 3) / (3 * modulus * inertia) +
                     6 * kForce * kLength / (5 * shear * area);
  return run.measures.at("deflection") / exact;
}

TEST(Bending, TwoElementsThroughTheHeightBendRight) {
  EXPECT_NEAR(bending(true, 0.3), 1, 0.02);
  EXPECT_NEAR(bending(false, 0.3), 1, 0.02);
}

TEST(Bending, OneElementBendsTooWhereNothingElseWould) {
  EXPECT_NEAR(bending(true, 0.3, {"bodies.beam.cells=[20, 1]"}), 1, 0.02);
}

TEST(Bending, StiffnessControlIsTooSoft) {
  EXPECT_GT(bending(true, 0.3, {"bodies.beam.element.hourglass={stiffness: 0.05}"}), 1.2);
}

TEST(Bending, LongNothingLocksWithoutCompressibility) {
  EXPECT_NEAR(bending(true, 0.499), 1, 0.05);
  EXPECT_NEAR(bending(false, 0.499), 1, 0.05);
}

}  // namespace
}  // namespace brunt::test
