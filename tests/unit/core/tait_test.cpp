// Tait's equation of water, rho0 = 1000, c0 = 1480 m/s, gamma = 7.15: B = 1000 1480^2/7.15 =
// 306.35 MPa (Cole gives 304.7 MPa at 20 degC). At a compression of 1 %: 1.01^7.15 = 1.0737368,
// p = 22.589 MPa. rho c^2 = gamma (p + B).
#include "core/materials/tait.hpp"

#include "eos_tile.hpp"

namespace brunt {
namespace {

Tait water() {
  Tait law;
  law.c0 = 1480;
  return law;
}

TEST(Tait, IsThePrintedFormula) {
  EosTile tile(water(), 1000);
  EXPECT_EQ(tile.pressure(), 0);
  EXPECT_DOUBLE_EQ(tile.bulk(), 1000.0 * 1480 * 1480);
  EXPECT_FALSE(tile.eos->needs_energy());
  tile.go(1 / 1.01);
  const Real B = 1000.0 * 1480 * 1480 / 7.15;
  EXPECT_NEAR(B, 306.35e6, 0.005e6);
  EXPECT_NEAR(tile.pressure(), B * (std::pow(1.01, 7.15) - 1), 1e-12 * B);
  EXPECT_NEAR(tile.pressure(), 22.589e6, 0.001e6);
  EXPECT_NEAR(tile.bulk() / (7.15 * (tile.pressure() + B)), 1, 1e-14);
  tile.go(1.05);
  EXPECT_NEAR(tile.pressure(), B * (std::pow(1 / 1.05, 7.15) - 1), 1e-12 * B);
}

TEST(Tait, StartsAtAPressureWhereItIsGivenOne) {
  Tait law = water();
  law.pressure = 101325;
  const EosTile tile(law, 1000);
  EXPECT_DOUBLE_EQ(tile.pressure(), 101325);
  EXPECT_DOUBLE_EQ(tile.bulk(), 1000.0 * 1480 * 1480);
}

// Cole's constant of water: c0 = sqrt(gamma B/rho0) = sqrt(7.15 x 304.7e6/1000) = 1476.01 m/s.
TEST(Tait, TakesItsConstantForTheSoundSpeed) {
  Tait law;
  law.B = 304.7e6;
  EosTile tile(law, 1000);
  EXPECT_NEAR(std::sqrt(tile.bulk() / 1000), 1476.01, 0.005);
  tile.go(1 / 1.01);
  EXPECT_NEAR(tile.pressure(), 304.7e6 * (std::pow(1.01, 7.15) - 1), 1e-12 * 304.7e6);
}

TEST(Tait, TangentIsThatOfTheIsentrope) {
  for (const Real ratio : {0.8, 0.99}) expect_isentropic_tangent(water(), 1000, ratio);
}

// Farther apart than water can be, sound still has a speed, and the step an end.
TEST(Tait, KeepsAStiffnessFarInTension) {
  EosTile tile(water(), 1000);
  tile.go(50);
  EXPECT_NEAR(tile.pressure(), -1000.0 * 1480 * 1480 / 7.15, 1);
  EXPECT_DOUBLE_EQ(tile.bulk(), 1e-3 * 1000 * 1480 * 1480);
}

}  // namespace
}  // namespace brunt
