// Free rigid bodies that end at planes of symmetry: the half has the motion of the whole, which
// neither moves across the plane nor turns but about its normal.
//   A box of 20 x 20 x 10 mm and 2000 kg/m^3, cut at x = 0, is pushed along z at its faces y = max
// and x = max by forces that do not turn with it. Of the half, M = 0.004 kg: v_z = F t/M; about x,
// through the middle, J = M (b^2 + c^2)/12 and w = F (b/2) t/J, as long as the arm has hardly
// turned: by w t/2 = 3e-4 here, of which the cosine leaves 1e-7. Forces act from the middle of the
// first step on. The torque about y of the push at x = max is the plane's.
//   A cube that is free hits a block of elements: a quarter of both has the speed of the whole
// after it. Nodes on the plane have the mass of the part, by which contact damps: 1 % of the speed.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

TEST(RigidSymmetry, AHalfTurnsAboutTheNormalAlone) {
  const std::string text = R"(
title: Half of a box is pushed at two of its sides
geometry: 3d
time: {end: 1 ms, max_step: 10 us}
materials: {stuff: {density: 2000 kg/m^3, elastic: {E: 1 GPa, nu: 0.3}}}
bodies:
  box:
    rigid: true
    material: stuff
    shape: {box: {min: [0, -10 mm, -5 mm], max: [10 mm, 10 mm, 5 mm]}}
symmetry: {x: 0}
boundaries:
  end: {body: box, where: {side: max-y}, force: [0, 0, 0.01 N]}
  side: {body: box, where: {side: max-x}, force: [3 N, 0, 0.02 N]}
measures:
  x: {point: {body: box, at: [0, 0, 0], field: displacement.x}}
)";
  const auto run = simulate_text(text);
  ASSERT_EQ(run.failure, "");
  const Real M = 2000 * 10e-3 * 20e-3 * 10e-3, J = M * (20e-3 * 20e-3 + 10e-3 * 10e-3) / 12;
  const Real t = 1e-3 - 5e-6, spin = 0.01 * 10e-3 * t / J;
  EXPECT_NEAR(run.last("body.box.velocity.z"), 0.03 * t / M, 1e-9);
  EXPECT_NEAR(run.last("body.box.spin.x"), spin, 1e-6 * spin);
  EXPECT_EQ(run.last("body.box.spin.y"), 0);
  EXPECT_EQ(run.last("body.box.spin.z"), 0);
  EXPECT_EQ(run.last("body.box.velocity.x"), 0);
  EXPECT_EQ(run.measures.at("x"), 0);
  EXPECT_LT(std::fabs(run.last("energy.drift")), 1e-12);
  RunVariation split;
  split.split_at = 30;
  EXPECT_EQ(simulate_text(text, {}, split).hashes.back(), run.hashes.back());
}

std::string hit(bool quarter) {
  return std::string(R"(
title: A rigid cube hits a block of elements
geometry: 3d
time: {end: 40 us}
materials:
  steel: {density: 7850 kg/m^3, elastic: {E: 200 GPa, nu: 0.3}}
  nylon: {density: 1140 kg/m^3, elastic: {E: 3 GPa, nu: 0.35}}
bodies:
  cube: {rigid: true, material: steel, velocity: [0, 0, -20 m/s], shape: {box: {min: )") +
         (quarter ? "[0, 0, 0.1 mm]" : "[-4 mm, -4 mm, 0.1 mm]") +
         R"(, max: [4 mm, 4 mm, 8 mm]}}}
  block:
    material: nylon
    size: 2 mm
    shape: {box: {min: )" +
         (quarter ? "[0, 0, -8 mm]" : "[-10 mm, -10 mm, -8 mm]") + R"(, max: [10 mm, 10 mm, 0]}}
contact: {default: {friction: 0.3}}
)" + (quarter ? "symmetry: {x: 0, y: 0}\n" : "");
}

// A box of 4 x 20 x 20 mm is pressed by 10 MPa on a held one, and half of it: as deep, since the
// face on the plane is none of its surface; it turns about x as it was told.
TEST(RigidSymmetry, AHalfIsAsStiffAsTheWholeAndKeepsItsSpin) {
  const auto pressed = [](const std::string& low, const std::string& floor_low,
                          const std::string& more) {
    return simulate_text(R"(
title: A rigid box is pressed on another
geometry: 3d
time: {end: 40 us, max_step: 0.1 us}
materials: {steel: {density: 7850 kg/m^3, elastic: {E: 200 GPa, nu: 0.3}}}
bodies:
  box:
    rigid: true
    material: steel
    shape: {box: {min: [)" +
                         low + R"(, -10 mm, 0], max: [2 mm, 10 mm, 20 mm]}}
  floor:
    material: steel
    size: 4 mm
    shape: {box: {min: [)" +
                         floor_low + R"(, -12 mm, -4 mm], max: [12 mm, 12 mm, 0]}}
boundaries:
  press: {body: box, where: {side: max-z}, pressure: 10 MPa}
  hold: {body: floor, where: all, fix: [x, y, z]}
contact: {default: {friction: 0}}
)" + more);
  };
  const auto whole = pressed("-2 mm", "-12 mm", "");
  const auto half = pressed("0", "0", "symmetry: {x: 0}\n");
  ASSERT_EQ(whole.failure, "");
  ASSERT_EQ(half.failure, "");
  EXPECT_NEAR(half.last("contact.box-floor.max_penetration"),
              whole.last("contact.box-floor.max_penetration"),
              1e-3 * whole.last("contact.box-floor.max_penetration"));
  const auto spun = simulate_text(R"(
title: Half of a box spins
geometry: 3d
time: {end: 1 us, max_step: 0.1 us}
materials: {steel: {density: 7850 kg/m^3, elastic: {E: 200 GPa, nu: 0.3}}}
bodies:
  a: {rigid: true, material: steel, spin: {axis: x, rate: 300 rad/s, about: [0, 0, 20 mm]},
      shape: {box: {min: [0, -4 mm, 16 mm], max: [4 mm, 4 mm, 24 mm]}}}
symmetry: {x: 0}
)");
  ASSERT_EQ(spun.failure, "");
  EXPECT_NEAR(spun.last("body.a.spin.x"), 300, 1e-9);
}

TEST(RigidSymmetry, AQuarterOfACubeHitsAsTheCube) {
  const auto whole = simulate_text(hit(false)), part = simulate_text(hit(true));
  ASSERT_EQ(whole.failure, "");
  ASSERT_EQ(part.failure, "");
  EXPECT_NEAR(part.last("body.cube.velocity.z"), whole.last("body.cube.velocity.z"), 0.2);
  EXPECT_EQ(part.last("body.cube.velocity.x"), 0);
  EXPECT_EQ(part.last("body.cube.spin.z"), 0);
}

TEST(RigidSymmetry, APlaneStrainHalfOnlySlides) {
  const auto run = simulate_text(R"(
title: Half of a block falls
geometry: plane-strain
time: {end: 1 ms, max_step: 10 us}
materials: {stuff: {density: 2000 kg/m^3, elastic: {E: 1 GPa, nu: 0.3}}}
bodies:
  block: {rigid: true, material: stuff, shape: {box: {min: [-10 mm, 0], max: [0, 10 mm]}}}
symmetry: {x: 0}
boundaries: {side: {body: block, where: {side: min-x}, force: [1 N, 2 N]}}
)");
  ASSERT_EQ(run.failure, "");
  EXPECT_EQ(run.last("body.block.velocity.x"), 0);
  EXPECT_EQ(run.last("body.block.spin.z"), 0);
  EXPECT_NEAR(run.last("body.block.velocity.y"), 2 * (1e-3 - 5e-6) / 0.2, 1e-9);
}

}  // namespace
}  // namespace brunt::test
