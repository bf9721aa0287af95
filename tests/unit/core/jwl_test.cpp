// JWL of TNT (Dobratz & Crawford, LLNL Explosives Handbook, UCRL-52997, 1985): rho0 = 1630 kg/m^3,
// A = 371.2 GPa, B = 3.231 GPa, R1 = 4.15, R2 = 0.95, omega = 0.30, E0 = 7.0 GPa; detonation at
// D = 6930 m/s with p_CJ = 21.0 GPa. Products that have burnt at constant volume, V = 1, E = E0:
// 371.2e9 (1 - 0.3/4.15) exp(-4.15) + 3.231e9 (1 - 0.3/0.95) exp(-0.95) + 0.3 7e9 = 8.384 GPa.
// At Chapman and Jouguet's point V = 1 - p_CJ/(rho0 D^2) = 0.7317 the Hugoniot, E = E0 + 1/2 p
// (1-V), has the pressure p_CJ.
#include "core/materials/jwl.hpp"

#include "eos_tile.hpp"

namespace brunt {
namespace {

constexpr Real kExplosiveDensity = 1630;

Jwl tnt() {
  Jwl products;
  products.A = 371.2e9, products.B = 3.231e9, products.R1 = 4.15, products.R2 = 0.95;
  products.omega = 0.3, products.E0 = 7e9;
  return products;
}

TEST(Jwl, IsThePrintedFormula) {
  const PrintedEquation eos(tnt(), {kExplosiveDensity, 0});
  const auto printed = [](Real V, Real E) {
    return 371.2e9 * (1 - 0.3 / (4.15 * V)) * std::exp(-4.15 * V) +
           3.231e9 * (1 - 0.3 / (0.95 * V)) * std::exp(-0.95 * V) + 0.3 * E / V;
  };
  EXPECT_NEAR(eos.pressure(0.8, 9e9) / printed(0.8, 9e9), 1, 1e-14);
  EXPECT_NEAR(eos.pressure(7, 2e9) / printed(7, 2e9), 1, 1e-14);
  EXPECT_NEAR(eos.initial_pressure(), 8.384e9, 0.001e9);
}

TEST(Jwl, HasTheDetonationThatItWasFittedTo) {
  const PrintedEquation eos(tnt(), {kExplosiveDensity, 0});
  const Real p = 21e9, V = 1 - p / (kExplosiveDensity * 6930 * 6930);
  EXPECT_NEAR(V, 0.7317, 0.0001);
  EXPECT_NEAR(eos.pressure(V, 7e9 + 0.5 * p * (1 - V)) / p, 1, 0.001);  // digits of the source
}

TEST(Jwl, ClosesItsEnergyAndHasTheTangentOfItsIsentrope) {
  for (const Real ratio : {0.75, 1.5, 4.0}) {
    expect_energy_closes(tnt(), kExplosiveDensity, ratio, 1e8);
    expect_isentropic_tangent(tnt(), kExplosiveDensity, ratio);
  }
}

}  // namespace
}  // namespace brunt
