/// The printed formula at points computed by hand, its limits, and what RadialReturn asks of a law:
/// slopes against central differences, a floor that is never above the static flow stress.
#include "core/materials/johnson_cook.hpp"

#include <gtest/gtest.h>

#include <random>

namespace brunt {
namespace {

static_assert(FlowLaw<JohnsonCook>);

JohnsonCook copper() {
  JohnsonCook law;
  law.A = 90e6, law.B = 292e6, law.n = 0.31, law.C = 0.025;
  law.m = 1.09, law.T_melt = 1356, law.T_ref = 298;
  law.prepare();
  return law;
}

TEST(JohnsonCook, IsThePrintedFormula) {
  const JohnsonCook law = copper();
  const Real hot = (600.0 - 298) / (1356 - 298);
  const Real wanted = (90e6 + 292e6 * std::pow(0.2, 0.31)) * (1 + 0.025 * std::log(1e4)) *
                      (1 - std::pow(hot, 1.09));
  // a handful of roundings, of which pow amplifies one by its exponent's size
  EXPECT_NEAR(law.flow_stress(0.2, 1e4, 600.0) / wanted, 1, 2e-15);
}

TEST(JohnsonCook, LimitsAreThoseOfTheModel) {
  const JohnsonCook law = copper();
  EXPECT_EQ(law.flow_stress(0.0, 0.0, 298.0), 90e6);
  EXPECT_EQ(law.flow_stress(0.0, 1e-12, 100.0), 90e6);  // static and cold: A alone
  EXPECT_EQ(law.flow_stress(0.0, 1.0, 298.0), law.flow_stress(0.0, 0.5, 298.0));
  EXPECT_EQ(law.flow_stress(0.3, 1e5, 1356.0), 0.0);
  EXPECT_EQ(law.flow_stress(0.3, 1e5, 1e5), 0.0);
  JohnsonCook cold = law;
  cold.T_melt.reset();
  EXPECT_FALSE(cold.needs_temperature());
  EXPECT_TRUE(law.needs_temperature());
  EXPECT_EQ(cold.flow_stress(0.3, 1e5, 1300.0), law.flow_stress(0.3, 1e5, 298.0));
}

TEST(JohnsonCook, NearAPointItIsTheSameLawWithItsSlopes) {
  const JohnsonCook law = copper();
  std::mt19937_64 random(6);
  std::uniform_real_distribution<Real> digit(0, 1);
  for (int i = 0; i < 2000; ++i) {
    // increments from 1e-8 to 1 of eps_p: both sides of the reach of the series
    const Real eps_p = i % 10 == 0 ? 0 : std::pow(10, -4 + 4 * digit(random));
    const Real increment = (eps_p + 1e-4) * std::pow(10, -8 * digit(random));
    const Real rate = std::pow(10, -2 + 8 * digit(random)), T = 250 + 1000 * digit(random);
    const Real hotter = T + 50 * std::pow(10, -6 * digit(random)), e = eps_p + increment;
    const auto flow = law.near(eps_p, T).at(increment, rate, hotter);
    EXPECT_NEAR(flow.value / law.flow_stress(e, rate, hotter), 1, 1e-13);
    EXPECT_NEAR(law.near(eps_p, T).static_stress() / law.flow_stress(eps_p, 0.0, T), 1, 1e-14);
    const auto slope = [](auto&& f, Real x) {  // central: error h^2 f'''/6, 1e-8 relative here
      const Real h = 1e-5 * x;
      return (f(x + h) - f(x - h)) / (2 * h);
    };
    const auto by_eps = [&](Real x) { return law.flow_stress(x, rate, hotter); };
    const auto by_rate = [&](Real x) { return law.flow_stress(e, x, hotter); };
    const auto by_T = [&](Real x) { return law.flow_stress(e, rate, x); };
    EXPECT_NEAR(flow.d_eps_p / slope(by_eps, e), 1, 1e-5);
    if (std::fabs(rate - 1) > 1e-3) {
      EXPECT_NEAR(flow.d_rate * rate, slope(by_rate, rate) * rate, 1e-5 * flow.value);
    }
    if (std::fabs(hotter - 298) > 1) {
      EXPECT_NEAR(flow.d_temperature * hotter, slope(by_T, hotter) * hotter, 1e-4 * flow.value);
    }
  }
}

TEST(JohnsonCook, FloorIsNeverAboveTheStaticFlowStress) {
  JohnsonCook law = copper();
  for (const Real n : {0.1, 0.25, 0.31, 0.5, 0.9, 1.0, 1.7}) {
    for (const Real m : {0.6, 1.0, 1.3}) {
      law.n = n, law.m = m;
      for (const Real eps_p : {0.0, 1e-9, 1e-3, 0.3, 0.999999999, 1.0, 1.0000001, 7.0}) {
        for (const Real T : {0.0, 298.0, 298.0001, 700.0, 1355.9999, 1356.0, 1e6}) {
          EXPECT_LE(law.static_floor(eps_p, T), law.near(eps_p, T).static_stress())
              << n << ' ' << m << ' ' << eps_p << ' ' << T;
        }
      }
    }
  }
  EXPECT_GT(copper().static_floor(0.0, 298.0), 0.999999 * 90e6);  // and it is of use
}

}  // namespace
}  // namespace brunt
