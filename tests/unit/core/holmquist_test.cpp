/// Holmquist, Johnson and Cook's concrete: values of the printed formulas by hand, release, energy.
///   48 MPa concrete of their paper of 1993: A .79, B 1.60, N .61, C .007, S_max 7, T 4 MPa,
///   p_crush 16 MPa, mu_crush .001, p_lock 800 MPa, mu_lock .10, K1/K2/K3 85/-171/208 GPa
#include "core/materials/holmquist.hpp"

#include <gtest/gtest.h>

#include "concrete_point.hpp"

namespace brunt {
namespace {

Holmquist paper() {
  Holmquist law;
  law.fc = 48e6, law.G = 14.86e9, law.A = 0.79, law.B = 1.6, law.N = 0.61, law.C = 0.007;
  law.S_max = 7, law.T = 4e6, law.D1 = 0.04, law.D2 = 1, law.ef_min = 0.01;
  law.p_crush = 16e6, law.mu_crush = 0.001, law.p_lock = 800e6, law.mu_lock = 0.1;
  law.K1 = 85e9, law.K2 = -171e9, law.K3 = 208e9;
  law.prepare();
  return law;
}

TEST(Holmquist, PressuresAreAsPrinted) {
  const Holmquist law = paper();
  const std::array<std::array<Real, 2>, 6> printed{
      {{0.0005, 8}, {0.001, 16}, {0.02, 166}, {0.05, 404}, {0.1, 800}, {0.15, 3530}}};
  for (const auto& [mu, p] : printed) {
    EXPECT_NEAR(law.first_loading(mu) / (p * 1e6), 1, 0.004) << mu;
    const Material material = concrete_of(law);
    ConcretePoint point(material);
    const Real strain = -std::log(1 + mu) / 3 / 100;
    for (int n = 0; n < 100; ++n) point.diagonal(strain, strain, strain);
    EXPECT_NEAR(point.pressure() / (p * 1e6), 1, 0.004) << mu;
  }
}

TEST(Holmquist, StrengthAndStrainToFailAreAsPrinted) {
  const Holmquist law = paper();
  // 0.79 + 1.6 (1/3)^0.61 = 1.6086 at a third of fc; ln 100 = 4.605
  EXPECT_NEAR(law.strength(16e6, 0, 1), 1.6086 * 48e6, 1e-4 * 48e6);
  EXPECT_NEAR(law.strength(16e6, 0, 100), 1.6086 * 48e6 * (1 + 0.007 * 4.60517), 2e-4 * 48e6);
  EXPECT_NEAR(law.strength(16e6, 1, 1), 0.8186 * 48e6, 1e-4 * 48e6);
  EXPECT_NEAR(law.strength(-2e6, 0, 1), 0.395 * 48e6, 1);
  EXPECT_EQ(law.strength(-2e6, 0.5, 1), 0.0);
  EXPECT_NEAR(law.strength(5e9, 0, 1e3), 7 * 48e6, 1);
  EXPECT_NEAR(law.strain_to_fail(44e6), 0.04, 1e-12);
  EXPECT_EQ(law.strain_to_fail(0), 0.01);
}

// The unconfined strength without damage: q = fc (A + B (q/3fc)^N), at q = 2.06 fc. Damage begins
// with the first plastic strain, and within 2 % of it a point has failed.
TEST(Holmquist, UnconfinedStrengthIsThatOfTheFormula) {
  const Material material = concrete_of(paper());
  ConcretePoint point(material);
  Real peak = 0;
  for (int n = 0; n < 2000; ++n) {
    point.triaxial(-1e-5, 0);
    peak = std::max(peak, point.q());
  }
  EXPECT_NEAR(peak / 48e6, 2.06, 0.06);
  EXPECT_GT(point.points.state.damage[1], 0.5);
}

TEST(Holmquist, ReleaseLeavesWhatIsCrushed) {
  for (const auto locking : {Holmquist::Locking::at_pressure, Holmquist::Locking::permanent}) {
    Holmquist law = paper();
    law.locking = locking;
    law.prepare();
    const Material material = concrete_of(law);
    ConcretePoint point(material);
    const Real strain = std::log(1.05) / 3 / 500;
    for (int n = 0; n < 500; ++n) point.diagonal(-strain, -strain, -strain);
    const Real most = point.pressure();
    while (point.pressure() > 0) point.diagonal(strain, strain, strain);
    const Real left = std::exp(-point.logarithm) - 1;
    EXPECT_NEAR(left, law.permanent(0.05), 3e-4);
    EXPECT_GT(left, 0.03);
    EXPECT_GT(point.work, 0);
    // On the way back it is elastic up to where it has been.
    while (point.logarithm > -std::log(1.05)) point.diagonal(-strain, -strain, -strain);
    EXPECT_NEAR(point.pressure() / most, 1, 0.01);
  }
}

// Where mu_lock is what is left, the dense curve reaches p_lock at 0.1 + 1.1 m, 85 m - 171 m^2 +
// 208 m^3 = 0.8: m = 0.009596; crushing ends there, and release comes back to 0.1 along that curve.
TEST(Holmquist, PermanentLockingIsThatOfTheDenseCurve) {
  Holmquist law = paper();
  law.locking = Holmquist::Locking::permanent;
  law.prepare();
  EXPECT_NEAR(law.compression_full(), 0.1 + 1.1 * 0.009596, 1e-5);
  EXPECT_NEAR(law.first_loading(law.compression_full()), 800e6, 1e3);
  EXPECT_NEAR(law.permanent(0.2), 0.1, 1e-12);
}

TEST(Holmquist, TensionIsBoundedAndEndsWithDamage) {
  const Material material = concrete_of(paper());
  ConcretePoint point(material);
  Real largest = 0;
  for (int n = 0; n < 400; ++n) {
    point.diagonal(1e-5, 0, 0);
    largest = std::max(largest, -point.pressure());
  }
  EXPECT_LE(largest, 4e6 * (1 + 1e-12));
  EXPECT_EQ(point.points.state.damage[1] < 1 ? 0.0 : point.pressure(), 0.0);
}

TEST(Holmquist, NoStepIsTooLarge) { expect_states_of_random_paths(concrete_of(paper())); }

}  // namespace
}  // namespace brunt
