// Tetrahedra in the place of hexahedra, six of each.
//
// A cantilever of length L and height h = L/10 under a force F at its end (Timoshenko, as in
// bending_test.cpp): d = F L^3/(3 E I) + 6 F L/(5 G A). Strains are even in an element, so that it
// is too stiff in bending at any nu, as linear tetrahedra are: 0.67 of d with two boxes through the
// height. What shows that nothing locks in volume is that nu = 0.499, where K/G is 500 and not 2.2,
// costs a quarter of that (0.51; of four boxes 0.74 and 0.67): with a volume of its own each,
// elements bend 0.50 and 0.022 of d. Lame's tube in unit/fe/tet4_test.cpp has the closed form.
//
// The Taylor bar of taylor_test.cpp: 21.43 mm long and 7.22 mm of radius at the foot once hexahedra
// have converged.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/materials.hpp"
#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

/// How far a cantilever bends, over Timoshenko's.
Real bending(Real nu) {
  const std::string deck = R"(
title: Cantilever of tetrahedra
geometry: 3d
time: {end: 10 ms}
heat: off
damping: {rate: 2000 1/s}
materials: {plastic: {density: 1200 kg/m^3, elastic: {E: 2 GPa, nu: )" +
                           std::to_string(nu) + R"(}}}
bodies:
  beam:
    material: plastic
    shape: {box: {min: [0, 0, 0], max: [100 mm, 10 mm, 10 mm]}}
    cells: [20, 2, 2]
    element: {type: tet4}
boundaries:
  wall: {body: beam, where: {side: min-x}, fix: [x, y, z]}
  end: {body: beam, where: {side: max-x}, force: [0, 10 N, 0]}
measures:
  deflection: {max: {body: beam, field: displacement.y}}
output: {history: 1 ms}
)";
  const auto run = simulate_text(deck, {});
  EXPECT_EQ(run.failure, "");
  EXPECT_LT(run.worst_drift, 1e-10);
  EXPECT_LT(run.last("energy.kinetic"), 1e-4 * run.last("energy.internal"));
  const Real L = 0.1, h = 0.01, E = 2e9, F = 10, G = E / (2 * (1 + nu)), I = std::pow(h, 4) / 12;
  return run.measures.at("deflection") /
         (F * std::pow(L, 3) / (3 * E * I) + 6 * F * L / (5 * G * h * h));
}

TEST(TetrahedraLong, NothingLocksWithoutCompressibility) {
  const Real compressible = bending(0.3), incompressible = bending(0.499);
  EXPECT_GT(compressible, 0.63);
  EXPECT_LT(compressible, 1);
  EXPECT_GT(incompressible, 0.7 * compressible);
}

std::string bar(const std::string& cells) {
  return R"(
title: Taylor bar of tetrahedra
geometry: 3d
time: {end: 80 us, safety: 0.9}
)" + kTaylorCopper +
         R"(bodies:
  bar:
    material: copper
    shape: {cylinder: {radius: 3.2 mm, length: 32.4 mm, base: [0, 0, 0], axis: z}}
    velocity: [0, 0, -227 m/s]
    cells: )" +
         cells + R"(
    element: {type: tet4}
contact: {default: {ignore: true}}
boundaries: {foot: {body: bar, where: {side: min-z}, fix: [z]}}
measures:
  length: {extent: {body: bar, axis: z}}
  width: {extent: {body: bar, axis: x}}
  depth: {extent: {body: bar, axis: y}}
output: {history: 0.5 us}
)";
}

TEST(TetrahedraLong, TaylorBar) {
  const auto run = simulate_text(bar("[6, 6, 60]"), {});
  ASSERT_EQ(run.failure, "");
  EXPECT_NEAR(1e3 * run.measures.at("length"), 21.43, 0.03 * 21.43);
  EXPECT_NEAR(0.5e3 * run.measures.at("width"), 7.22, 0.03 * 7.22);
  EXPECT_NEAR(0.5e3 * run.measures.at("depth"), 7.22, 0.03 * 7.22);
  EXPECT_LT(run.worst_drift, 0.01);
}

}  // namespace
}  // namespace brunt::test
