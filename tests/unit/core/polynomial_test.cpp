// The polynomial of LS-DYNA's *EOS_LINEAR_POLYNOMIAL at points computed by hand. With C4 = C5 = 0.4
// and no others it is the ideal gas of gamma = 1.4, as that manual says: 0.4 (1 + mu) E.
#include "core/materials/polynomial.hpp"

#include "eos_tile.hpp"

namespace brunt {
namespace {

/// All coefficients differ, so that none is taken for another.
Polynomial full() {
  Polynomial law;
  law.C0 = 1e6, law.C1 = 2e9, law.C2 = 3e9, law.C3 = 5e9;
  law.C4 = 0.3, law.C5 = 0.7, law.C6 = 1.1, law.E0 = 1e7;
  return law;
}

TEST(Polynomial, IsThePrintedFormula) {
  const PrintedEquation eos(full(), {1000, 0});
  // mu = 1/4: 1e6 + 0.5e9 + 3e9/16 + 5e9/64 + (0.3 + 0.175 + 0.06875) 2e7
  EXPECT_NEAR(eos.pressure(0.8, 2e7), 1e6 + 0.5e9 + 187.5e6 + 78.125e6 + 0.54375 * 2e7, 1e-6);
  // mu = -1/5, without C2 and C6: 1e6 - 0.4e9 - 5e9/125 + (0.3 - 0.14) 2e7
  EXPECT_NEAR(eos.pressure(1.25, 2e7), 1e6 - 0.4e9 - 40e6 + 0.16 * 2e7, 1e-6);
  EXPECT_DOUBLE_EQ(eos.initial_pressure(), 1e6 + 0.3 * 1e7);
  EXPECT_DOUBLE_EQ(eos.bulk_modulus(), 2e9 + 0.7 * 1e7 + 0.3 * (1e6 + 0.3 * 1e7));
}

TEST(Polynomial, ClosesItsEnergyAndHasTheTangentOfItsIsentrope) {
  for (const Real ratio : {0.7, 0.95, 1.02}) {
    expect_energy_closes(full(), 1000, ratio, 2e6);
    if (ratio < 1) expect_isentropic_tangent(full(), 1000, ratio);
  }
}

TEST(Polynomial, WithoutTermsOfEnergyNeedsNone) {
  Polynomial law;
  law.C1 = 2e9;
  EosTile tile(law, 1000);
  EXPECT_FALSE(tile.eos->needs_energy());
  tile.go(0.8);
  EXPECT_DOUBLE_EQ(tile.pressure(), 0.25 * 2e9);
  EXPECT_EQ(tile.energy(), 0);
}

TEST(Polynomial, IsTheIdealGasOfThatManual) {
  Polynomial law;
  law.C4 = law.C5 = 0.4, law.E0 = 2.5e5;
  IdealGas gas;
  gas.gamma = 1.4, gas.pressure = 1e5;
  EosTile one(law, 1.2), other(gas, 1.2);
  for (const Real ratio : {0.9, 0.4, 0.8, 1.3}) {
    one.go(ratio), other.go(ratio);
    EXPECT_NEAR(one.pressure() / other.pressure(), 1, 1e-13);
    EXPECT_NEAR(one.bulk() / other.bulk(), 1, 1e-13);
  }
}

}  // namespace
}  // namespace brunt
