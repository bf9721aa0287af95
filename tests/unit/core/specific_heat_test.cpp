/// cp of a table, its enthalpy and the inverse. By hand for cp = 400, 800, 200 J/kg/K at 300, 500,
/// 600 K: h = 600 * 200 = 120 000 J/kg at 500 K, and 500 * 100 = 50 000 more at 600 K.
#include "core/materials/specific_heat.hpp"

#include <gtest/gtest.h>

#include <array>

#include "core/points.hpp"

namespace brunt {
namespace {

SpecificHeat table(std::vector<Real> T, std::vector<Real> cp) {
  Varying given;
  given.over = Varying::Over::temperature;
  given.abscissa = std::move(T), given.ordinate = std::move(cp);
  return SpecificHeat(given);
}
SpecificHeat tent() { return table({300, 500, 600}, {400, 800, 200}); }

TEST(SpecificHeat, EnthalpyIsTheAreaBelowTheTable) {
  const auto cp = tent();
  EXPECT_TRUE(cp.varies());
  EXPECT_EQ(cp.at(200), 400);
  EXPECT_EQ(cp.at(450), 700);
  EXPECT_EQ(cp.at(700), 200);
  EXPECT_EQ(cp.enthalpy(300), 0);
  EXPECT_EQ(cp.enthalpy(200), -40000);
  EXPECT_EQ(cp.enthalpy(500), 120000);
  EXPECT_EQ(cp.enthalpy(600), 170000);
  EXPECT_EQ(cp.enthalpy(700), 190000);
  EXPECT_EQ(cp.enthalpy(550), 120000 + 0.5 * (800 + 500) * 50);
}

// h is known to some ulp of its largest value, 2e5 * 2e-16, and so is T by h/cp: 2e-13 K.
TEST(SpecificHeat, TemperatureIsTheInverse) {
  const auto cp = tent();
  Real before = -kInfinity;
  for (Real T = 150; T < 800; T += 0.37) {
    EXPECT_NEAR(cp.temperature(cp.enthalpy(T)), T, 1e-12) << T;
    EXPECT_LT(before, cp.enthalpy(T));
    before = cp.enthalpy(T);
  }
  // A peak of 397 kJ/kg over 0.1 K: as steep as T(h) can be asked to be.
  const auto peak = table({933, 933.05, 933.1}, {900, 8e6, 900});
  for (Real T = 932; T < 934; T += 0.0021) {
    EXPECT_NEAR(peak.temperature(peak.enthalpy(T)), T, 1e-12) << T;
  }
}

TEST(SpecificHeat, LeastBetweenTwoTemperatures) {
  const auto cp = tent();
  EXPECT_EQ(cp.least(), 200);
  EXPECT_EQ(cp.least_between(450, 550), 500);
  EXPECT_EQ(cp.least_between(550, 450), 500);
  EXPECT_EQ(cp.least_between(100, 200), 400);
  EXPECT_EQ(cp.least_between(100, 900), 200);
  EXPECT_EQ(table({300, 400, 500}, {900, 100, 900}).least_between(310, 490), 100);
  EXPECT_EQ(SpecificHeat(383).least_between(1, 2), 383);
}

// Two thirds of the tent and a third of 300 J/kg/K: at 500 K 1900/3, at 450 K 1700/3.
TEST(SpecificHeat, MixturesAddTheirParts) {
  const auto cp = tent();
  const SpecificHeat constant(300);
  const std::array parts{&cp, &constant};
  const std::array shares{2.0 / 3, 1.0 / 3};
  const auto mixture = SpecificHeat::of_mixture(parts, shares);
  EXPECT_NEAR(mixture.at(500), 1900.0 / 3, 1e-12);
  EXPECT_NEAR(mixture.at(450), 1700.0 / 3, 1e-12);
  EXPECT_NEAR(mixture.enthalpy(600), (2 * 170000.0 + 300 * 300) / 3, 1e-9);
  const std::array alone{&cp};
  const std::array whole{1.0};
  EXPECT_EQ(SpecificHeat::of_mixture(alone, whole), cp);
  const std::array still{&constant};
  EXPECT_FALSE(SpecificHeat::of_mixture(still, whole).varies());
}

// 2 kg of the tent from 450 K to 550 K take 2 (120 000 + 32 500 - 400 150 - 0.5 2 150^2).
TEST(SpecificHeat, PointsTakeTheHeatOfTheirTable) {
  Points<2> points;
  points.resize(2);
  points.conduct({450, 300});
  points.vary_capacities({tent()});
  points.capacity[1] = 7;
  points.vary_capacity(0, 0, 2);
  EXPECT_EQ(points.capacity[0], 1400);
  const Real heat = 2 * (120000 + 32500 - 400 * 150 - 22500.0);
  EXPECT_NEAR(points.heat_needed(0, 550), heat, 1e-9);
  EXPECT_NEAR(points.temperature_with(0, heat), 550, 1e-12);
  EXPECT_EQ(points.least_capacity(0), 400);
  EXPECT_EQ(points.temperature_with(1, 70), 310);
  EXPECT_EQ(points.heat_needed(1, 310), 70);
  EXPECT_EQ(points.least_capacity(1), 7);
  const std::array<LocalIndex, 1> first{0};
  const auto part = points.subset(first, 1);
  EXPECT_EQ(part.temperature_with(0, heat), points.temperature_with(0, heat));
}

}  // namespace
}  // namespace brunt
