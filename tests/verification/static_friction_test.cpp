// Static friction holds at the defaults. A block on a slope of less than atan(mu), let go unloaded
// as gravity sets in, swings on its springs by 2 rho g H/M of its height, and comes to rest: its
// weight is held, m g sin(a) along the slope, and it has moved by no more than its springs give,
// its own, 5 rho g H^2/G in shear and twice that in bending of a block twice as wide as high, and
// those of the contact. Springs as stiff as its elements let it flutter and slide instead, at 20 to
// 250 mm/s after half a second (docs/theory/contact.md, resting layer).
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

const char* const kMaterials = R"(
title: a block rests on a slope
parameters: {angle: 30 deg, mu: 0.6, g: 9.81 m/s^2, end: 0.2 s, size: 10 mm}
time: {end: $end}
materials:
  rubber: {density: 1000 kg/m^3, elastic: {E: 10 MPa, nu: 0.3}}
  steel: {density: 7850 kg/m^3, elastic: {E: 200 GPa, nu: 0.3}}
contact: {default: {friction: $mu}}
output: {history: = $end / 200}
)";
const char* const kInPlane = R"(
geometry: plane-strain
gravity: [= $g * sin($angle), = -$g * cos($angle)]
bodies:
  block: {material: rubber, shape: {box: {min: [-50 mm, 0], max: [50 mm, 40 mm]}}, size: $size}
)";
const char* const kInSpace = R"(
geometry: 3d
gravity: [= $g * sin($angle), 0, = -$g * cos($angle)]
bodies:
  block: {material: rubber, shape: {box: {min: [-50 mm, -50 mm, 0], max: [50 mm, 50 mm, 40 mm]}},
          size: $size}
)";
const char* const kRigid[2] = {
    "  slope: {rigid: true, shape: {plane: {origin: [0, 0], normal: y, extent: 2 m}}}\n",
    "  slope: {rigid: true, shape: {plane: {origin: [0, 0, 0], normal: z, extent: 2 m}}}\n"};

struct Block {
  int dim = 2;
  std::string method = "fe", material = "rubber";
  std::vector<std::string> overrides;
};

Simulation run(const Block& block) {
  const bool plane = block.dim == 2;
  const std::string deck =
      std::string(kMaterials) + (plane ? kInPlane : kInSpace) + kRigid[plane ? 0 : 1];
  std::vector<std::string> overrides = block.overrides;
  overrides.push_back("bodies.block.material=" + block.material);
  overrides.push_back("bodies.block.method=" + block.method);
  return simulate_text(deck, overrides);
}

void expect_rests(const Block& block, Real stiffness, Real density) {
  const auto simulation = run(block);
  ASSERT_EQ(simulation.failure, "");
  const Real weight = simulation.first("body.block.mass") * 9.81;
  const Real along = simulation.last("contact.block-slope.force.x");
  EXPECT_NEAR(along, -0.5 * weight, 1e-4 * weight);
  const std::string up = block.dim == 2 ? "y" : "z";
  for (const std::string& c : {std::string("x"), up}) {
    EXPECT_LT(std::fabs(simulation.last("body.block.velocity." + c)), 1e-6);
  }
  const Real H = 0.04, G = stiffness / 2.6;
  const Real moved =
      simulation.last("body.block.position.x") - simulation.first("body.block.position.x");
  EXPECT_LT(std::fabs(moved), 15 * density * 9.81 * H * H / G);
}

TEST(StaticFriction, HoldsABlockOfElementsOfAnySize) {
  for (const int dim : {2, 3}) {
    for (const char* size : {"20 mm", "10 mm"}) {
      SCOPED_TRACE(std::to_string(dim) + "D " + size);
      expect_rests({dim, "fe", "rubber", {std::string("parameters.size=") + size}}, 10e6, 1000);
    }
  }
  expect_rests({2, "fe", "rubber", {"parameters.size=5 mm"}}, 10e6, 1000);
}

TEST(StaticFriction, HoldsABlockOfParticles) {
  for (const int dim : {2, 3}) expect_rests({dim, "sph", "rubber", {}}, 10e6, 1000);
}

TEST(StaticFriction, HoldsASteelBlock) {
  expect_rests({2, "fe", "steel", {"parameters.end=4 ms"}}, 200e9, 7850);
}

TEST(StaticFriction, HoldsOnASteepSlopeToo) {
  const auto simulation =
      run({2, "fe", "rubber", {"parameters.angle=45 deg", "parameters.mu=1.1"}});
  ASSERT_EQ(simulation.failure, "");
  EXPECT_LT(std::fabs(simulation.last("body.block.velocity.x")), 1e-6);
}

// Without the layer it does not: the test above can fail.
TEST(StaticFriction, FluttersOnSpringsAsStiffAsElements) {
  const auto simulation = run({2, "fe", "rubber", {"contact.default.resting_layer=0"}});
  ASSERT_EQ(simulation.failure, "");
  EXPECT_GT(std::fabs(simulation.last("body.block.velocity.x")), 1e-3);
}

// Impacts hardly know the layer: a block dropped at 1 m/s, 300 times the speed at which its weight
// brings it through the layer, leaves with all but 1 % of the speed that it has without it.
TEST(StaticFriction, LayersTakeNextToNothingFromImpacts) {
  const auto leaves = [](const char* weights) {
    const auto simulation =
        run({2,
             "fe",
             "rubber",
             {"parameters.angle=0 deg", "parameters.end=10 ms", "bodies.block.velocity=[0, -1 m/s]",
              std::string("contact.default.resting_layer=") + weights}});
    EXPECT_EQ(simulation.failure, "");
    const auto v = simulation.column("body.block.velocity.y");
    return *std::max_element(v.begin(), v.end());
  };
  const Real without = leaves("0"), with_layer = leaves("3");
  EXPECT_GT(without, 0.7);
  EXPECT_NEAR(with_layer, without, 0.01 * without);
}

}  // namespace
}  // namespace brunt::test
