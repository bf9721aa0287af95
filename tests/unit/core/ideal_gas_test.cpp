// Ideal gas. Air at 1.2 kg/m^3 and 101,325 Pa, gamma = 1.4: c = sqrt(gamma p/rho) = 343.82 m/s.
// Isentrope: p V^gamma constant. A shock of a piston at u into gas at rest (Rankine 1870, Hugoniot
// 1889): one step with the work of the mean pressure is the Hugoniot relation
// E - E0 = 1/2 (p + p0)(1 - V), so that p/p0 = ((gamma+1)/V - (gamma-1))/((gamma+1) - (gamma-1)/V):
// at V = 1/2 and gamma = 1.4, (4.8 - 0.4)/(2.4 - 0.8) = 2.75.
#include "core/materials/ideal_gas.hpp"

#include "eos_tile.hpp"

namespace brunt {
namespace {

IdealGas air() {
  IdealGas gas;
  gas.gamma = 1.4, gas.pressure = 101325;
  return gas;
}
constexpr Real kDensity = 1.2;

TEST(IdealGas, StartsAtItsPressureWithItsSoundSpeed) {
  const EosTile tile(air(), kDensity);
  EXPECT_DOUBLE_EQ(tile.pressure(), 101325);
  EXPECT_DOUBLE_EQ(tile.energy(), 101325 / 0.4);
  EXPECT_DOUBLE_EQ(tile.bulk(), 1.4 * 101325);
  EXPECT_NEAR(std::sqrt(tile.bulk() / kDensity), 343.82, 0.005);
  EXPECT_TRUE(tile.eos->needs_energy());
}

TEST(IdealGas, IsThePrintedFormula) {
  EosTile tile(air(), kDensity);
  tile.go(0.8, 5e4);
  EXPECT_NEAR(tile.pressure(), 0.4 * tile.energy() / 0.8, 1e-9);
  EXPECT_NEAR(tile.bulk(), 1.4 * tile.pressure(), 1e-8);
}

TEST(IdealGas, KeepsItsAdiabaticConstantUnderCompressionAndRelease) {
  for (const Real ratio : {0.1, 0.5, 3.0}) {
    EosTile tile(air(), kDensity);
    tile.go_slowly(ratio, 4000);
    const Real constant = tile.pressure() * std::pow(ratio, 1.4) / 101325;
    EXPECT_NEAR(constant, 1, 1e-5) << ratio;  // trapezoidal work: the square of ln(ratio)/4000
    tile.go_slowly(1, 4000);
    EXPECT_NEAR(tile.pressure() / 101325, 1, 1e-11);  // the path back is the path there
  }
}

TEST(IdealGas, TakesTheJumpOfAShockInOneStep) {
  EosTile tile(air(), kDensity);
  tile.go(0.5);
  EXPECT_NEAR(tile.pressure() / 101325, 2.75, 1e-14);
  expect_energy_closes(air(), kDensity, 0.5, 0);
  expect_energy_closes(air(), kDensity, 1.7, 3e4);
}

TEST(IdealGas, TangentIsThatOfTheIsentrope) {
  for (const Real ratio : {0.2, 0.9, 2.0}) expect_isentropic_tangent(air(), kDensity, ratio);
}

// T V^(gamma-1) is constant too, however large the step.
TEST(IdealGas, WarmsAsItIsCompressed) {
  EosTile tile(air(), kDensity);
  std::fill_n(tile.points.tile.ratio, kTile, 0.25);
  alignas(32) Real logarithm[kTile];
  tile.eos->isentropic_heating(tile.points.at_first(), kInfinity, logarithm);
  EXPECT_NEAR(logarithm[3], 0.4 * std::log(4), 1e-14);
}

}  // namespace
}  // namespace brunt
