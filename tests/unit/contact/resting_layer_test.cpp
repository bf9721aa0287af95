// A body of height H, modulus M and density rho under g rests on a layer of k_s = 0.4 M/H, used up
// at n rho g H: d = n rho g H / k_s.
#include "contact/law/resting_layer.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace brunt {
namespace {

constexpr Real kG = 9.81;

RestingBody body(Real height, Real modulus, Real density) {
  return {height, modulus, std::sqrt(modulus / density)};
}

TEST(RestingLayer, IsSoftAsTheBodyAndAsDeepAsItsWeights) {
  const RestingBody block = body(0.04, 1e7, 1000), rigid;
  const RestingLayer layer = resting_layer(block, rigid, kG, 3);
  EXPECT_DOUBLE_EQ(layer.stiffness, 0.4 * 1e7 / 0.04);
  EXPECT_NEAR(layer.depth, 3 * 1000 * kG * 0.04 / layer.stiffness, 1e-18);
  EXPECT_DOUBLE_EQ(layer.over(10 * layer.stiffness, 1).softness, 0.1);
  EXPECT_EQ(layer.over(0.5 * layer.stiffness, 1).softness, 1);  // never stiffer than the contact
  EXPECT_EQ(layer.over(10 * layer.stiffness, 1).depth, layer.depth);
}

// A metre of jelly would sink in by 0.4 m, 1,000 m of rock by 6 m: not deeper than 2 % of what
// touches.
TEST(RestingLayer, IsNoDeeperThanAPartOfWhatTouches) {
  for (const auto& soft : {body(1, 1e5, 1000), body(1000, 1e10, 2600)}) {
    const RestingLayer layer = resting_layer(soft, {}, kG, 3);
    EXPECT_GT(layer.depth, 0.4);
    EXPECT_DOUBLE_EQ(layer.over(1e12, 0.05).depth, 1e-3);
  }
}

TEST(RestingLayer, IsThatOfTheLowerBody) {
  const RestingBody brick = body(0.04, 1e7, 1000), ground = body(10, 1e10, 2000);
  const RestingLayer one = resting_layer(brick, ground, kG, 3);
  EXPECT_EQ(one.stiffness, resting_layer(ground, brick, kG, 3).stiffness);
  EXPECT_DOUBLE_EQ(one.stiffness, 0.4 * 1e7 / 0.04);
}

TEST(RestingLayer, ARigidBodyRestsOnWhatGivesWay) {
  const RestingBody slab = body(0.5, 1e10, 2000), weight{0.1, 0, 0};
  const RestingLayer layer = resting_layer(weight, slab, kG, 3);
  EXPECT_DOUBLE_EQ(layer.stiffness, 0.4 * 1e10 / 0.1);
  EXPECT_NEAR(layer.depth, 3 * 2000 * kG * 0.1 / layer.stiffness, 1e-20);
}

TEST(RestingLayer, ThereIsNoneWithoutWeightOrBetweenRigidBodies) {
  const RestingBody block = body(0.04, 1e7, 1000), rigid{0.1, 0, 0};
  EXPECT_FALSE(resting_layer(block, {}, 0, 3).acts());
  EXPECT_FALSE(resting_layer(block, {}, kG, 0).acts());
  EXPECT_FALSE(resting_layer(rigid, rigid, kG, 3).acts());
}

}  // namespace
}  // namespace brunt
